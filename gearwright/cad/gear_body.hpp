// A gear or a rack in the form that the writers of files require.
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

/// Returns the gear in its own frame. Its pose in a pair is `pair.pose_1().isometry()` or
/// `pose_2()`.
///
/// Errors    `cut_by` for an internal gear without a pinion cutter; `teeth` for a gear whose tooth
///           cannot exist (severed, or through the axis)
Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore = {});

/// Applies the modifications of the right and the left flank to the body of a gear. If the teeth
/// cannot be made with these modifications, they remain as cut and `unmodified` contains the
/// reason.
///
/// Errors    `modifications.right.…`, `modifications.left.…`, those of make_removal_field
std::optional<Error> modify(ToothedBody& body, const Gear& gear,
                            const std::array<FlankModifications, 2>& flanks);

/// Returns the rack in its own frame (pair/rack_outline.hpp). Its pose is
/// `rack_pair.pose_2().isometry()`.
///
/// Errors    `gear2.teeth` or `gear2.height` if it is not given; `gear2.height` if the back lies
///           above the roots, with the smallest permissible height; those of rack_outline()
Result<ToothedBody> rack_body(const RackGeometry& rack, const std::string& name);

}  // namespace gearwright
