// A tip that projects beyond the involute of its flank.
//
// A pinion cutter with undercut or protuberance lacks the part of its flank that would cut the tip of
// the gear. The remaining material projects beyond the involute and can collide with other mating gears.
//
//   δ = r_b (θ − θ_i)   projection along the normal of the involute, mm [T2.35]
//   θ, θ_i              polar angles of the outline and of the involute at one radius
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The projection of the tip; none if no arc beyond the flank projects by more than 1e-9 modules.
///
/// Domain    an involute gear that exists (contract)
/// Accuracy  the greatest δ of each arc beyond the flank, to rounding if δ has only one maximum
std::optional<TipBulge> tip_bulge(const Gear& gear);

}  // namespace gearwright
