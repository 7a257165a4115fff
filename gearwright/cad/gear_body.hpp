// A gear in the form that the writers of files need.
#pragma once

#include <optional>
#include <string>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The gear in its own frame; its place in a pair is `pair.pose_1().isometry()`, `pose_2()`.
///
/// Errors    `cut_by` of an internal gear that no pinion cutter has cut, `teeth` of a gear whose
///           tooth cannot exist (severed, through the axis)
Result<ToothedBody> gear_body(const Gear& gear, const std::string& name,
                              const std::optional<Bore>& bore = {});

}  // namespace gearwright
