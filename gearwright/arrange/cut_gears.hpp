// Makes gears that are cut by a pinion cutter, and tips that keep a clearance to the root of the mating
// gear, before the pair is mounted. Internal to arrange/.
#pragma once

#include <array>
#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

using MadeGears = std::array<std::optional<Gear>, 2>;

/// The default clearance between a tip fillet and the mating gear's root: 0.2 m_n + 0.05 mm. [T6.7]
inline double default_tip_clearance(double normal_module) { return 0.2 * normal_module + 0.05; }

/// Makes every gear that has cut_by, and the gear that cuts it. The resulting values (module, angles,
/// shift) are written into the input. If one gear cuts the other, an absent centre distance of the pair
/// is set to the generating centre distance.
///
/// Errors    `gearN.cut_by` for gears that cut each other, internal gears as cutters, gears that do not
///           exist; `gearN.tip_fillet.clearance` if this gear cuts its mating gear; as
///           make_pinion_cut_gear
std::optional<Error> make_cut_gears(GivenPair& given, MadeGears& made);

/// Converts the clearance of a tip fillet into the radius at which the tooth ends, for the given centre
/// distance.
///
/// Errors    `gearN.tip_fillet.clearance` if there is no mating gear
std::optional<Error> place_clear_tips(GivenPair& given, const MadeGears& made,
                                      std::optional<double> center_distance);

}  // namespace gearwright
