// Finds gears for a given centre distance, shaft angle and ratio. This is the inverse problem of
// computing a pair from its gears.
//
//   H(β_w1) = σ z1/cos β_w1 + |z2|/cos β_w2, where β_w2 = σ (Σ − β_w1); H is the sum of the pitch
//        diameters (for an internal pair, their difference) in units of p_n/π; σ is −1 for an
//        internal pair, otherwise 1
//   T = 2 a cos α_wn/(m_n cos α_n), the required value of H
//                                              theory: docs/theory/04-conjugate-action.md, 4.9
//
// H is convex, so H = T has at most two solutions. If the gears are known, the file computes their
// position. If the position is known, it computes the gears. If a helix angle is unknown, only
// designs at their least centre distance are considered. In these designs, the pitch planes
// coincide (X = 0), so a small error of Σ changes the backlash-free centre distance only to second
// order. On parallel axes, every backlash-free pair is at its least centre distance.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The known values, lengths in mm. Absent values are computed. z2 is < 0 for an internal gear.
struct FitProblem {
  std::array<int, 2> teeth{};
  double normal_module = 0.0;                          ///< m_n, common to both gears
  Angle normal_pressure_angle{};                       ///< α_n
  std::array<std::optional<Angle>, 2> helix;           ///< β
  std::array<std::optional<double>, 2> shift;          ///< x
  std::optional<double> center_distance;               ///< a
  std::optional<Angle> shaft_angle;                    ///< Σ
  std::optional<Angle> working_normal_pressure_angle;  ///< α_wn
  /// Both gears, if their helix angles and shifts are known. The modules and pressure angles of
  /// these gears may differ from the values above.
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
  std::vector<FitBranch> branches;  ///< by ascending |β_1|, or by ascending α_wn for known gears
  std::string reason;               ///< reason why no solution exists; empty if a solution exists
  std::optional<double> nearest_distance;    ///< nearest possible a at the given Σ, mm
  std::optional<Angle> nearest_shaft_angle;  ///< nearest possible Σ at the given a
};

/// Computes the absent values.
///
///   known                      computed
///   gears and Σ                a
///   gears and a                both Σ
///   gears                      minimum centre distance and its Σ
///   gears and α_wn             a and Σ; only if the axes cross
///   helix angles, a and Σ      x1 + x2; if Σ is absent, it is the angle at which a is the minimum
///                              centre distance
///   a and Σ                    helix angles and x1 + x2 of the designs at their minimum centre
///                              distance, with the given α_wn, helix angle or shifts; if none of
///                              these is given, x1 + x2 = 0
///
/// Errors    the member that is missing, or the member that overdetermines the pair
Result<Fit> fit(const FitProblem& problem);

/// Returns the designs that meet the given condition. The condition is α_wn, a helix angle, or x1 +
/// x2. If none is given, it is x1 + x2 = 0.
///
/// Domain    a and Σ are given, and at least one helix angle is absent (contract)
/// Errors    the names of conditions that exclude each other
Result<Fit> min_distance_designs(const FitProblem& problem);

}  // namespace gearwright
