// The root of a gear with few teeth: as it is, and as the rack alone would cut it.
//
//   F    where undercut begins: the flank on the base circle, ξ = 0
//   C, J where a circular root fillet and a circular tip fillet touch the flank
//   r_r, r_t  their radii, mm
//   l    mm along the rack's straight flank, from its lower end
//                                              theory: docs/theory/06-few-teeth.md
#pragma once

#include <optional>
#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// Whether the picture says something: a circular root fillet, undercut, or at most 12 teeth, of a
/// gear that a rack has cut and that has an outline.
bool root_is_worth_a_picture(const Gear& gear);

/// The same spec without circular fillets, as its rack cuts it; nothing when the spec has none, or
/// when there is no such gear.
std::optional<Gear> by_rack_alone(const Gear& gear);

/// The flank's point on the base circle, side y > 0, mm.
///
/// Formula   r_b e^{i ψ_b}, ψ_b = s_bt/d_b
Vec2 undercut_limit_point(const Gear& gear);

/// The figure; empty where it says nothing. `shape` names the gear's definitions (gear_shape.hpp).
std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
