// A gear or a rack in the form that the writers of files need.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Returns the gear in its own frame. Its place in a pair is `pair.pose_1().isometry()` or
/// `pose_2()`.
///
/// Errors    `cut_by` for an internal gear without a pinion cutter; `teeth` for a gear whose tooth
///           cannot exist (severed, or through the axis)
Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore = {});

/// Gives the body of a gear the modifications of its right and its left flank. If its teeth cannot
/// be made with them, the teeth stay as cut and `unmodified` gives the reason.
///
/// Errors    `modifications.right.…`, `modifications.left.…` as make_removal_field
std::optional<Error> modify(ToothedBody& body, const Gear& gear,
                            const std::array<FlankModifications, 2>& flanks);

/// The rack in its own frame (pair/rack_outline.hpp); its place is `rack_pair.pose_2().isometry()`.
///
/// Errors    `gear2.teeth` or `gear2.height` if the rack has none, or if its back lies above the
///           roots, with the least height that leaves material; those of rack_outline()
Result<ToothedBody> rack_body(const RackGeometry& rack, const std::string& name);

}  // namespace gearwright
