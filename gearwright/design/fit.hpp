// Inverse design: gears for a given centre distance, shaft angle and ratio.
//
//   H(β_w1) = z1/cos β_w1 + z2/cos β_w2, β_w2 = Σ − β_w1: the pitch diameters' sum in units of
//        p_n/π; convex, so that H = T has no, one or two answers
//   T = 2 a cos α_wn/(m_n cos α_n)
//                                              theory: docs/theory/04-conjugate-action.md, 4.9
//
// For known gears, their positions are computed, and for a known position the gears. Designs with a
// free helix angle are those at their minimum centre distance, where the pitch planes coincide (X =
// 0) and an error of Σ has no effect of first order. On parallel axes every backlash-free pair is
// such a design.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The known values; absent values are the unknowns. Lengths in mm; z2 < 0 for an internal gear.
struct FitProblem {
  std::array<int, 2> teeth{};
  double normal_module = 0.0;                          ///< m_n, common to both gears
  Angle normal_pressure_angle{};                       ///< α_n
  std::array<std::optional<Angle>, 2> helix;           ///< β
  std::array<std::optional<double>, 2> shift;          ///< x
  std::optional<double> center_distance;               ///< a
  std::optional<Angle> shaft_angle;                    ///< Σ
  std::optional<Angle> working_normal_pressure_angle;  ///< α_wn
  /// Both gears when helices and shifts are known: their racks may differ, and need not be the one
  /// above.
  std::optional<std::array<CylindricalSpec, 2>> known;
};

/// One solution: a pair without backlash.
struct FitBranch {
  std::array<Angle, 2> helix;
  std::array<double, 2> shift;
  double center_distance;
  Angle shaft_angle, working_normal_pressure_angle;
};

struct Fit {
  std::vector<FitBranch> branches;         ///< in the order of |β_1|, or for known gears of α_wn
  std::string reason;                      ///< the reason if there is no solution
  std::optional<double> nearest_distance;  ///< mm, at the given shaft angle
  std::optional<Angle> nearest_shaft_angle;  ///< at the given centre distance
};

/// Computes the absent values.
///
///   gears known                a of Σ; both Σ of a; without either, the minimum distance
///   helices and place known    x1 + x2
///   place known                helices and x1 + x2 of the designs at their minimum centre
///                              distance: with the given α_wn, helix or shifts; else with
///                              x1 + x2 = 0
///
/// Errors    the member that is missing, or that makes one condition too many
Result<Fit> fit(const FitProblem& problem);

}  // namespace gearwright
