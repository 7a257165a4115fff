// Which two gears go together, and how their axes may stand.
//
//   Two gears mesh when their normal base pitches agree. Their base helices then decide: equal and
//   opposite (an internal gear: equal) leave parallel axes, any others cross.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/working_angles.hpp"

namespace gearwright {

/// The two gears as themselves, with the teeth as cut.
BasePair<double> base_pair(const Gear& gear_1, const Gear& gear_2);

/// The two gears as themselves, without thickness allowances: those make backlash and do not move
/// a place that is to be free of it.
BasePair<double> nominal_base_pair(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2);

/// |β_b1 + σ β_b2| ≤ 1e-9 rad: the axes are parallel for every rack between the gears.
bool axes_are_parallel(const BasePair<double>& gears);

/// What keeps two gears apart, whatever the centre distance; nothing: they mesh. `shaft_angle`
/// is absent when the caller leaves it open.
///
/// Errors    `gear2.normal_module` for unequal base pitches, `gear2.helix_angle` if internal
///           on a crossed axis, `gear1.teeth`, `gear2.teeth` for impossible internal pairs,
///           `pair.shaft_angle` out of reach; each says by how much, and what would do
std::optional<Error> check_partners(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2,
                                    const std::optional<Angle>& shaft_angle);

/// How a pair is to stand.
struct PairSpec {
  std::optional<double> center_distance = {};  ///< a  mm; none: free of backlash, or with
                                               ///< circular-arc teeth the reference one
  std::optional<Angle> shaft_angle = {};       ///< Σ  of crossed axes; none: parallel axes, or
                                               ///< without a distance as complete_place has it
  std::optional<double> friction = {};         ///< μ, for the efficiency
  std::optional<double> speed_rpm = {};        ///< n_1  1/min, of gear 1
};

/// Where a pair stands.
struct PairPlace {
  double center_distance = 0.0;           ///< a  mm
  std::optional<Angle> shaft_angle = {};  ///< Σ  of crossed axes; none: parallel axes
};

/// Completes a place from what is given: Σ absent is 0 where the helices allow it, else that of the
/// least centre distance; a absent is the one at which `nominal` teeth (without allowances) have no
/// backlash.
///
/// Domain    check_partners found nothing for the gears of `nominal` (contract)
/// Errors    `pair.shaft_angle`, `profile_shift` when the teeth leave no such place
Result<PairPlace> complete_place(const BasePair<double>& nominal, std::optional<double> distance,
                                 std::optional<Angle> shaft_angle);

}  // namespace gearwright
