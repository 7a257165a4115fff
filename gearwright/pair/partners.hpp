// Which two gears can mesh, and the possible positions of their axes.
//
//   Two gears mesh when their normal base pitches agree. Their base helices then decide: equal and
//   opposite (an internal gear: equal) leave parallel axes, any others cross.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/working_angles.hpp"

namespace gearwright {

/// The two gears by their own dimensions, with the teeth as cut.
BasePair<double> base_pair(const Gear& gear_1, const Gear& gear_2);

/// The two gears by their own dimensions, without thickness allowances, which cause backlash and do
/// not change a backlash-free position.
BasePair<double> nominal_base_pair(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2);

/// |β_b1 + σ β_b2| ≤ 1e-9 rad: the axes are parallel for every rack between the gears.
bool axes_are_parallel(const BasePair<double>& gears);

/// The reason why two gears cannot mesh at any centre distance; empty if they can. `shaft_angle` is
/// absent if it is not given.
///
/// Errors    `gear2.normal_module` for unequal base pitches, `gear2.helix_angle` if internal
///           on a crossed axis, `gear1.teeth`, `gear2.teeth` for impossible internal pairs,
///           `pair.shaft_angle` out of reach; each with the amount and the value that fits
std::optional<Error> check_partners(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2,
                                    const std::optional<Angle>& shaft_angle);

/// The requested position of a pair.
struct PairSpec {
  std::optional<double> center_distance = {};  ///< a  mm; by default free of backlash, or with
                                               ///< circular-arc teeth the reference one
  std::optional<Angle> shaft_angle = {};  ///< Σ  of crossed axes; by default parallel axes, or
                                          ///< without a distance as complete_place has it
  std::optional<double> friction = {};    ///< μ, for the efficiency
  std::optional<double> speed_rpm = {};   ///< n_1  1/min, of gear 1
};

/// The position of a pair.
struct PairPlace {
  double center_distance = 0.0;           ///< a  mm
  std::optional<Angle> shaft_angle = {};  ///< Σ  of crossed axes; none for parallel axes
};

/// Completes a place from what is given: an absent Σ is 0 if the helices permit it, otherwise that
/// of the least centre distance. An absent a is the distance at which `nominal` teeth (without
/// allowances) have no backlash.
///
/// Domain    check_partners found nothing for the gears of `nominal` (contract)
/// Errors    `pair.shaft_angle`, `profile_shift` if the teeth have no such position
Result<PairPlace> complete_place(const BasePair<double>& nominal, std::optional<double> distance,
                                 std::optional<Angle> shaft_angle);

}  // namespace gearwright
