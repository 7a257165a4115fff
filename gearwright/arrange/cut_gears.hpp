// Makes the gears that are cut by a pinion cutter, before the pair is mounted. Also computes tips
// with a given clearance to the root of the mating gear. Internal to arrange/.
#pragma once

#include <array>
#include <optional>

#include "gearwright/arrange/given_pair.hpp"

namespace gearwright {

using MadeGears = std::array<std::optional<Gear>, 2>;

/// Returns the default clearance from a tip fillet to the mating root, 0.2 m_n + 0.05 mm. [T6.7]
inline double default_tip_clearance(double normal_module) { return 0.2 * normal_module + 0.05; }

/// Makes every gear that has `cut_by`, and writes the resulting module, angles and shift into the
/// input. If one gear of the pair cuts the other, the gear that cuts is made as well. If, in this
/// case, no centre distance is given, the generating centre distance is written into the pair.
///
/// Errors    `gearN.cut_by` if a gear cuts itself, if two gears cut each other, or if the cutter is
///           an internal gear, is absent or is not a possible gear; `gearN.tip_fillet.clearance` if
///           this gear cuts its mating gear; `pair.shorten_tips` if it is true; `pair.mounting` if
///           it is extended and one gear cuts the other; a member of the gear that contradicts the
///           cutter; the errors of make_gear for the cutter; the errors of make_pinion_cut_gear,
///           which name `pair.center_distance` if this is the generating distance
std::optional<Error> make_cut_gears(GivenPair& given, MadeGears& made);

/// Computes the radius at which each tooth with a tip fillet ends, if the clearance of the fillet
/// to the root of the mating gear is given. The radius also depends on the centre distance.
///
/// Errors    `gearN.tip_fillet.clearance` if there is no mating gear on a parallel axis; the errors
///           of make_gear for the mating gear
std::optional<Error> place_clear_tips(GivenPair& given, const MadeGears& made,
                                      std::optional<double> center_distance);

// Rewrites errors about computed numbers, so that they name the given numbers from which the
// computed numbers follow.

/// Converts the error of a gear to an error of gear 1 or 2. If the gear is given by its base
/// cylinder, the input contains no rack data. The message then names the rack that describes the
/// gear. An error of a computed tip diameter names a given value from which the diameter follows.
Error of_given_gear(Error error, const GivenPair& given, int which);

/// If an error of a pair names rack data of a gear that is given by its base cylinder, returns an
/// error that names the corresponding data of the base cylinder. Returns any other error unchanged.
Error of_basic(const Error& error, const GivenPair& given);

/// Attributes an error about the radius at which the tooth ends to the given tip clearance.
Error of_clearance(const Error& error, const GivenPair& given, int which);

/// Attributes the error of a computed profile shift to the given centre distance.
Error of_distance(const Error& error, const GivenPair& given);

/// Changes the kind of the error from `value` to `placement`. Any other kind is unchanged.
Error not_placed(Error error);

}  // namespace gearwright
