#include "gearwright/generation/rack_envelope.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/math/involute.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// W = (r + x + ik) e^{iφ}
Vec2 point_of(const RackCut<double>& cut, double r) {
  const double u = r + cut.x;
  const double sin_phi = std::sin(cut.phi);
  const double cos_phi = std::cos(cut.phi);
  return {u * cos_phi - cut.k * sin_phi, u * sin_phi + cut.k * cos_phi};
}

// Returns the coefficients of F as a polynomial in s = sin τ. [T3.9]
std::array<double, 5> cusp_coefficients(const RackMotion& motion, const EdgeCircle& circle) {
  const double cos2 = motion.cos_beta * motion.cos_beta;
  const double sin2 = 1.0 - cos2;
  const double q = circle.q, x_c = circle.center.x();
  return {-cos2 * x_c * x_c, -cos2 * x_c * q, 0.0, q * (motion.pitch_radius + sin2 * x_c),
          sin2 * q * q};
}

double transverse(const RackMotion& motion, double tau) {
  return std::atan2(std::sin(tau), motion.cos_beta * std::cos(tau));
}

}  // namespace

RackTrochoid::RackTrochoid(const RackMotion& motion, const EdgeCircle& circle)
    : motion_(motion), circle_(circle) {
  circle_.center.x() += motion.shift;
}

Vec2 RackTrochoid::point(double tau) const {
  return point_of(cut(std::sin(tau), std::cos(tau)), motion_.pitch_radius);
}

double RackTrochoid::polar_angle(double tau) const {
  const auto [x, k, phi] = cut(std::sin(tau), std::cos(tau));
  return phi + std::atan2(k, motion_.pitch_radius + x);
}

RackTrochoid::LogRadius RackTrochoid::log_radius(double tau) const {
  const double x = circle_.center.x(), q = circle_.q;
  const double s = std::sin(tau);
  const double c = std::cos(tau);
  const double k = motion_.cos_beta * (x * c / s + q * c);
  const double k1 = -motion_.cos_beta * (x / (s * s) + q * s);
  const double a = motion_.pitch_radius + x + q * s;
  const double square = a * a + k * k;
  return {0.5 * std::log(square), (a * q * c + k * k1) / square};
}

CurvePoint RackTrochoid::at(double tau) const {
  const double r = motion_.pitch_radius;
  const double cb = motion_.cos_beta;
  const double s = std::sin(tau);
  const double c = std::cos(tau);
  const double q = circle_.q;
  const RackCut<double> here = cut(s, c);
  const double tau_t = std::atan2(s, cb * c);
  const double square = s * s + cb * cb * c * c;
  // dW/dτ = v e^{i(φ − τ_t)},  v = F √(s² + cos²β c²)/(s³ r cos β). [T3.9]
  const double f = evaluate_polynomial(cusp_coefficients(motion_, circle_), s);
  const double v = f * std::sqrt(square) / (s * s * s * r * cb);
  const double phi_1 = (-q * s / cb - (q * c * c * cb / s - here.x * cb / (s * s))) / r;
  const double turn = phi_1 - cb / square;
  return {point_of(here, r), here.phi - tau_t + (v < 0.0 ? std::numbers::pi : 0.0),
          turn / std::abs(v)};
}

std::vector<double> RackTrochoid::cusp_polynomial() const {
  const auto f = cusp_coefficients(motion_, circle_);
  return {f.begin(), f.end()};
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
