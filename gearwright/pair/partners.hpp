// Checks the conditions under which two gears can mesh, and computes the positions of their axes.
//
// Two gears mesh if their normal base pitches agree. The axes are parallel if the base helix
// angles are equal and opposite or, in an internal pair, equal. Otherwise the axes cross.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/working_angles.hpp"

namespace gearwright {

/// The base dimensions of both gears, for the teeth as cut.
BasePair<double> base_pair(const Gear& gear_1, const Gear& gear_2);

/// The base dimensions of both gears without thickness allowances. Allowances cause backlash, but
/// they do not change the backlash-free position of the nominal teeth.
BasePair<double> nominal_base_pair(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2);

/// True if |β_b1 + σ β_b2| ≤ 1e-9 rad. The axes are then parallel for every rack between the gears.
bool axes_are_parallel(const BasePair<double>& gears);

/// Returns the reason why two gears cannot mesh at any centre distance, or none if they can.
/// `shaft_angle` is empty if the user gives no shaft angle.
///
/// Errors    `gear2.normal_module` if the base pitches differ; `gear2.helix_angle` if the axes of
///           an internal pair would cross although no shaft angle is given; `gear1.teeth` or
///           `gear2.teeth` if an internal pair is impossible; `pair.shaft_angle` if the shaft angle
///           is outside its range. Each message gives the deviation and a value that fits
std::optional<Error> check_partners(const CylindricalSpec& gear_1, const CylindricalSpec& gear_2,
                                    const std::optional<Angle>& shaft_angle);

/// The error of a pair whose gear 1 is internal.   Domain  teeth_1 < 0
Error internal_gear_1(int teeth_1, int teeth_2);

/// The requested position of a pair.
struct PairSpec {
  std::optional<double> center_distance = {};  ///< a  mm; by default the backlash-free distance, or
                                               ///< a_d for circular-arc teeth
  /// Σ  of crossed axes. If it is absent and a distance is given, Σ is 0. If both are absent,
  /// complete_place() computes Σ.
  std::optional<Angle> shaft_angle = {};
  std::optional<double> friction = {};   ///< μ, for the efficiency
  std::optional<double> speed_rpm = {};  ///< n_1  1/min, of gear 1
};

/// The position of a pair.
struct PairPlace {
  double center_distance = 0.0;           ///< a  mm
  std::optional<Angle> shaft_angle = {};  ///< Σ  of crossed axes; none for parallel axes
};

/// Completes the position of a pair. The default of Σ is 0 if the base helix angles permit parallel
/// axes. Otherwise, the default of Σ is the shaft angle at the least centre distance. The default
/// of a is the distance at which the `nominal` teeth (without allowances) have no backlash.
///
/// Domain    check_partners returns no error for the gears of `nominal` (contract)
/// Errors    `pair.shaft_angle`, `profile_shift` if the teeth have no such position
Result<PairPlace> complete_place(const BasePair<double>& nominal, std::optional<double> distance,
                                 std::optional<Angle> shaft_angle);

}  // namespace gearwright
