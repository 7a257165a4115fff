// A tip that projects beyond the involute of its flank.
//
// An undercut pinion cutter, or one with protuberance, lacks the part of its flank that would cut
// the tip of the gear. The material left there projects beyond the involute and collides with other
// mating gears.
//
//   δ = r_b (θ − θ_i)  θ of the outline, θ_i of the involute: along the involute's normal [T2.35]
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The bulge of the tip; none if no arc beyond the flank projects by more than 1e-9 modules.
///
/// Domain    an involute gear that exists (contract)
/// Accuracy  the greatest δ of each arc past the flank, to rounding, where δ has one hump
std::optional<TipBulge> tip_bulge(const Gear& gear);

}  // namespace gearwright
