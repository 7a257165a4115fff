// The gears that other gears cut, and the tips that keep clear of a mating gear's root; both come
// before the pair is placed. Internal to arrange/.
#pragma once

#include <array>
#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

using MadeGears = std::array<std::optional<Gear>, 2>;

/// What a tip fillet leaves to the mating gear's root by rule: 0.2 m_n + 0.05 mm. [T6.7]
inline double default_tip_clearance(double normal_module) { return 0.2 * normal_module + 0.05; }

/// Makes every gear with cut_by and writes what follows (module, angles, shift) into its input;
/// with it the gear that cuts it. The pair's distance is set to the generating one where it is
/// absent and one gear cuts the other.
///
/// Errors    `gearN.cut_by` for circles, internal gears as cutters, gears that do not exist; as
///           make_pinion_cut_gear
std::optional<Error> make_cut_gears(GivenPair& given, MadeGears& made);

/// Turns the clearance of a tip fillet into where the tooth ends, at the centre distance a.
///
/// Errors    `gearN.tip_fillet.clearance` where there is no mating gear, or it is cut by this gear
std::optional<Error> place_clear_tips(GivenPair& given, const MadeGears& made,
                                      std::optional<double> center_distance);

}  // namespace gearwright
