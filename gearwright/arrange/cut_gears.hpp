// The gears that other gears cut, and the tips that keep clear of a mating gear's root; both are
// computed before the pair is placed. Internal to arrange/.
#pragma once

#include <array>
#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

using MadeGears = std::array<std::optional<Gear>, 2>;

/// The default clearance between a tip fillet and the mating gear's root: 0.2 m_n + 0.05 mm. [T6.7]
inline double default_tip_clearance(double normal_module) { return 0.2 * normal_module + 0.05; }

/// Makes every gear with cut_by, and the gear that cuts it, and writes the values that follow
/// (module, angles, shift) into its input. An absent centre distance of the pair is set to the
/// generating one if one gear cuts the other.
///
/// Errors    `gearN.cut_by` for circles, internal gears as cutters, gears that do not exist; as
///           make_pinion_cut_gear
std::optional<Error> make_cut_gears(GivenPair& given, MadeGears& made);

/// Converts the clearance of a tip fillet into the end of the tooth, at the centre distance a.
///
/// Errors    `gearN.tip_fillet.clearance` if there is no mating gear, or if this gear cuts it
std::optional<Error> place_clear_tips(GivenPair& given, const MadeGears& made,
                                      std::optional<double> center_distance);

}  // namespace gearwright
