#include "gearwright/generation/rack_envelope.hpp"

#include <cmath>

#include "gearwright/math/involute.hpp"

namespace gearwright {

namespace {

double transverse(const RackMotion& motion, double tau) {
  return std::atan2(std::sin(tau), motion.cos_beta * std::cos(tau));
}

}  // namespace

RackTrochoid::RackTrochoid(const RackMotion& motion, const EdgeCircle& circle)
    : motion_(motion), circle_(circle) {
  circle_.center.x() += motion.shift;
}

std::vector<double> RackTrochoid::neck_angles(double tau_lo, double tau_hi) const {
  // r sin²τ_t + x = 0, multiplied by s² + cos²β (1 − s²), is a polynomial in s = sin τ.
  const double cos2 = motion_.cos_beta * motion_.cos_beta;
  const double sin2 = 1.0 - cos2;
  const double q = circle_.q;
  const double x_c = circle_.center.x();
  const double c[] = {x_c * cos2, q * cos2, motion_.pitch_radius + x_c * sin2, q * sin2};
  std::vector<double> angles;
  for (double s : polynomial_roots(c, std::sin(tau_lo), std::sin(tau_hi)))
    angles.push_back(std::asin(s));
  return angles;
}

Involute rack_involute(const RackMotion& motion, const EdgeLine& line) {
  const double alpha_t = transverse(motion, line.tau.rad());
  // The half thickness of the tooth on the pitch circle gives the half angle on the base circle.
  const double y_pitch = (line.y_datum + motion.shift * std::tan(line.tau.rad())) / motion.cos_beta;
  return {motion.pitch_radius * std::cos(alpha_t),
          y_pitch / motion.pitch_radius + involute(alpha_t)};
}

double rack_involute_roll(const RackMotion& motion, const EdgeLine& line, double x) {
  const double alpha_t = transverse(motion, line.tau.rad());
  const double s = std::sin(alpha_t);
  // ξ = (r sin α_t + x/sin α_t)/r_b, in a form that is exactly 0 at the cusp x = −r sin²α_t.
  return (motion.pitch_radius * s * s + x) / (motion.pitch_radius * s * std::cos(alpha_t));
}

}  // namespace gearwright
