#include "gearwright/pair/shift.hpp"

#include <fmt/format.h>

#include <numbers>

#include "gearwright/gear/reference.hpp"
#include "gearwright/pair/working_angles.hpp"

namespace gearwright {

namespace {

Error no_working_angle(double a, double least, bool external, double a_d) {
  return refused(
      "pair.center_distance", a, {least, kMaxDistance * least},
      fmt::format("at this centre distance there is no working pressure angle; the centre distance "
                  "must be greater than {{}} mm (the {} of the base radii) and at most {{}} mm ({} "
                  "times the lower limit); the reference centre distance is {} mm",
                  external ? "sum" : "difference", kMaxDistance, format_number(a_d)));
}

// Divides the sum into two shifts. A shift that is given in the problem is not changed.
ShiftSolution divided(const ShiftProblem& p, double sum, double a) {
  ShiftSolution s{p.x1.value_or(0.0), p.x2.value_or(0.0), a};
  if (p.x1) {
    s.x2 = sum - *p.x1;
  } else if (p.x2) {
    s.x1 = sum - *p.x2;
  } else {
    const auto [x1, x2] = divided_shift_sum(p.z1, p.z2, sum, p.lambda);
    s.x1 = x1;
    s.x2 = x2;
  }
  return s;
}

Result<ShiftSolution> complete_crossed(const ShiftProblem& p) {
  const double side = side_of(p.z2);
  double a_d = 0.0;
  a_d += side * p.z1 * p.normal_module / (2 * std::cos(p.helix_angle[0].rad()));
  a_d += side * p.z2 * p.normal_module / (2 * std::cos(p.helix_angle[1].rad()));
  const double given = p.x1.value_or(0.0) + p.x2.value_or(0.0);
  if (!p.center_distance) {
    // The shifts alone determine the extended centre distance. The backlash-free distance also
    // depends on the teeth, so it cannot be computed here.
    GW_EXPECTS(p.mounting == Mounting::extended);
    return ShiftSolution{p.x1.value_or(0.0), p.x2.value_or(0.0),
                         a_d + side * p.normal_module * given};
  }
  const double a = *p.center_distance;
  if (p.x1 && p.x2) return ShiftSolution{*p.x1, *p.x2, a};
  const double sum = p.mounting == Mounting::extended ? side * (a - a_d) / p.normal_module
                                                      : crossed_shift_sum(p, a);
  return divided(p, sum, a);
}

}  // namespace

std::array<double, 2> divided_shift_sum(int z1, int z2, double sum, double lambda) {
  if (z2 < 0) return {sum, 0.0};
  // If the sum is less than 2 λ (ShiftProblem), the gear with fewer teeth gets the larger shift.
  const double x1 = (lambda * z2 + (sum - lambda) * z1) / (z1 + z2);
  return {x1, sum - x1};
}

double crossed_shift_sum(const ShiftProblem& p, double a) {
  GW_EXPECTS(p.shaft_angle.has_value());
  BasePair<double> unshifted;
  for (int i : {0, 1}) {
    const int z = i == 0 ? p.z1 : p.z2;
    unshifted[i] =
        base_gear(z, reference_geometry<double>({z, p.normal_module, p.normal_pressure_angle.rad(),
                                                 p.helix_angle[i].rad(), 0.0, 0.0}));
  }
  const auto rack = common_rack(unshifted, angles_at_shaft_angle(unshifted, p.shaft_angle->rad()));
  const double X =
      side_of(unshifted) * (a - rack.sides[1].pitch_radius) - rack.sides[0].pitch_radius;
  return (2 * X * rack.angles.sin_alpha - rack.excess) * std::numbers::pi /
         (2 * normal_base_pitch(unshifted[0]) * std::tan(p.normal_pressure_angle.rad()));
}

Result<ShiftSolution> complete_shifts(const ShiftProblem& p) {
  if (p.shaft_angle) return complete_crossed(p);
  const bool external = p.z2 > 0;
  const double cos_beta = std::cos(p.helix_angle[0].rad());
  const double alpha_n = p.normal_pressure_angle.rad();
  const double alpha_t = cos_beta == 1.0 ? alpha_n : std::atan(std::tan(alpha_n) / cos_beta);
  const double a_d = reference_center_distance(p.z1, p.z2, p.normal_module, cos_beta);
  const double least = a_d * std::cos(alpha_t);
  if (p.center_distance) {
    const double a = *p.center_distance;
    if (!(a > least && a <= kMaxDistance * least)) return no_working_angle(a, least, external, a_d);
    if (p.x1 && p.x2) return ShiftSolution{*p.x1, *p.x2, a};
    const double sum =
        p.mounting == Mounting::extended
            ? (side_of(p.z2) * (a - a_d) + 0.0) / p.normal_module  // without −0
            : tight_shift_sum(p.z1, p.z2, p.normal_module, alpha_n, alpha_t, cos_beta, a);
    return divided(p, sum, a);
  }
  ShiftSolution s{p.x1.value_or(0.0), p.x2.value_or(0.0), 0.0};
  const double sum = s.x1 + s.x2;
  if (p.mounting == Mounting::extended) {
    s.center_distance = extended_center_distance(p.z1, p.z2, p.normal_module, cos_beta, sum);
    if (s.center_distance > least) return s;
    return Error{
        "profile_shift", format_number(sum),
        fmt::format("the sum of both profile shifts, {}, gives the extended centre distance {} mm, "
                    "at which there is no working pressure angle; this distance must exceed {} mm",
                    format_number(sum), format_number(s.center_distance, least),
                    format_number(least, s.center_distance))};
  }
  if (!(nominal_working_involute(p.z1, p.z2, alpha_n, alpha_t, sum) >= 0.0)) {
    const double limit = -involute(alpha_t) * (p.z1 + p.z2) / (2 * std::tan(alpha_n));
    return refused("profile_shift", sum, {limit},
                   fmt::format("if the sum of both profile shifts is {}, the teeth are too {} for "
                               "any backlash-free centre distance; the sum must be {} than {{}}",
                               format_number(sum, limit), external ? "thin" : "thick",
                               external ? "greater" : "less"));
  }
  s.center_distance =
      tight_center_distance(p.z1, p.z2, p.normal_module, alpha_n, alpha_t, cos_beta, sum);
  return s;
}

}  // namespace gearwright
