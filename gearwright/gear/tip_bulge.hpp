// A tip that stands out beyond the involute of its flank.
//
// An undercut pinion cutter, or one with protuberance, lacks the part of its flank that would cut
// the tip of the gear: what is left there is more than the involute, and strikes other mating gears.
//
//   δ = r_b (θ − θ_i)  θ of the outline, θ_i of the involute: along the involute's normal [T2.35]
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The bulge of the tip; none: no arc past the flank stands out by more than 1e-9 modules.
///
/// Domain    an involute gear that exists (contract)
/// Accuracy  the greatest δ of each arc past the flank, to rounding, where δ has one hump
std::optional<TipBulge> tip_bulge(const Gear& gear);

}  // namespace gearwright
