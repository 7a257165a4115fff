#include "gearwright/load/point_hertz.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// Least b/a. It corresponds to k1/k2 = 1e-17, at which the contact is practically a line contact.
constexpr double kThinnest = 1e-9;
// K and D = (K − E)/e² for κ = b/a by Carlson's integrals, accurate for thin and round ellipses.
double elliptic_k(double axes) { return boost::math::ellint_rf(0.0, axes * axes, 1.0); }
double elliptic_d(double axes) { return boost::math::ellint_rd(0.0, axes * axes, 1.0) / 3.0; }

// Returns k1/k2 of an ellipse with b/a = `axes`. [T12.22]
double curvature_ratio(double axes) {
  const double d = elliptic_d(axes);
  return axes * axes * d / (elliptic_k(axes) - d);
}

double axes_of(double ratio) {
  if (ratio >= 1.0) return 1.0;
  const auto f = [&](double log_axes) {
    return std::log(curvature_ratio(std::exp(log_axes))) - std::log(ratio);
  };
  const double least = std::log(kThinnest);
  if (f(least) >= 0.0) return kThinnest;
  return std::exp(find_root(f, least, 0.0).x);
}

}  // namespace

HertzPoint::HertzPoint(const std::array<double, 2>& gap_curvature, double reduced_modulus) {
  GW_EXPECTS(gap_curvature[0] > 0.0 && gap_curvature[0] <= gap_curvature[1]);
  GW_EXPECTS(reduced_modulus > 0.0);
  axes_ = axes_of(gap_curvature[0] / gap_curvature[1]);
  const double of_force = 3.0 / (std::numbers::pi * reduced_modulus);
  semi_major_ = std::cbrt(of_force * elliptic_d(axes_) / gap_curvature[0]);
  softness_ = 0.5 * of_force * elliptic_k(axes_) / semi_major_;
}

HertzEllipse HertzPoint::under(double force) const {
  GW_EXPECTS(force >= 0.0);
  const double a = semi_major_ * std::cbrt(force);
  const double b = axes_ * a;
  const double root = std::cbrt(force);
  const double pressure = force > 0.0 ? 1.5 * force / (std::numbers::pi * a * b) : 0.0;
  return {a, b, pressure, softness_ * root * root};
}

}  // namespace gearwright
