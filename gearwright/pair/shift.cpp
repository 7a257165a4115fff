#include "gearwright/pair/shift.hpp"

#include <fmt/format.h>

namespace gearwright {

namespace {

// The pinion, which has fewer teeth, gets the larger shift.                            [T2.18a]
double eq11_pinion_shift(int z1, int z2, double sum, double lambda) {
  return (lambda * z2 + (sum - lambda) * z1) / (z1 + z2);
}

}  // namespace

Result<ShiftSolution> complete_shifts(const ShiftProblem& p) {
  const bool external = p.z2 > 0;
  ShiftSolution s{p.x1.value_or(0.0), p.x2.value_or(0.0), 0.0};
  const double a_d = reference_center_distance(p.z1, p.z2, p.normal_module, p.cos_beta);
  const double least = a_d * std::cos(p.transverse_pressure_angle);
  if (p.center_distance) {
    const double a = *p.center_distance;
    if (!(a > least && a <= kGreatestDistance * least)) {
      return Error{
          "pair.center_distance_mm", fmt::format("{}", a),
          fmt::format("pair.center_distance_mm = {}: there is no working pressure angle; it must "
                      "be greater than {} mm, the {} of the base radii, and at most {} times that "
                      "(reference centre distance: {} mm)",
                      a, least, external ? "sum" : "difference", kGreatestDistance, a_d)};
    }
    s.center_distance = a;
    if (p.x1 && p.x2) return s;
    const double sum = p.mounting == Mounting::extended
                           ? (external ? a - a_d : a_d - a) / p.normal_module
                           : tight_shift_sum(p.z1, p.z2, p.normal_module, p.normal_pressure_angle,
                                             p.transverse_pressure_angle, p.cos_beta, a);
    if (p.x1) {
      s.x2 = sum - *p.x1;
    } else if (p.x2) {
      s.x1 = sum - *p.x2;
    } else if (external) {
      s.x1 = eq11_pinion_shift(p.z1, p.z2, sum, p.lambda);
      s.x2 = sum - s.x1;
    } else {
      s.x1 = sum;
      s.x2 = 0.0;
    }
    return s;
  }
  const double sum = s.x1 + s.x2;
  const double inv_wt = nominal_working_involute(p.z1, p.z2, p.normal_pressure_angle,
                                                 p.transverse_pressure_angle, sum);
  if (p.mounting == Mounting::extended) {
    s.center_distance = extended_center_distance(p.z1, p.z2, p.normal_module, p.cos_beta, sum);
    if (s.center_distance > least) return s;
    return Error{
        "profile_shift", fmt::format("{}", sum),
        fmt::format("gear1.profile_shift + gear2.profile_shift = {}: at the extended centre "
                    "distance {} mm there is no working pressure angle; it must exceed {} mm",
                    sum, s.center_distance, least)};
  }
  if (!(inv_wt >= 0.0)) {
    const double limit = -involute(p.transverse_pressure_angle) * (p.z1 + p.z2) /
                         (2 * std::tan(p.normal_pressure_angle));
    return Error{
        "profile_shift", fmt::format("{}", sum),
        fmt::format("gear1.profile_shift + gear2.profile_shift = {}: the teeth are too {} for any "
                    "backlash-free centre distance; the sum must be {} than {}",
                    sum, external ? "thin" : "thick", external ? "greater" : "less", limit)};
  }
  s.center_distance = tight_center_distance(p.z1, p.z2, p.normal_module, p.normal_pressure_angle,
                                            p.transverse_pressure_angle, p.cos_beta, sum);
  return s;
}

}  // namespace gearwright
