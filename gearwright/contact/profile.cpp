#include "gearwright/contact/profile.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

constexpr double kRounding = 4e-16;  // rounding error, absolute for ln ρ, relative for a parameter
// On the base circle, θ″ = −(1 + ξ²)/ξ of an involute is infinite. Below kMinRollSquare, the slopes
// are therefore computed at ξ² = kMinRollSquare. The radius there is greater than r_b by 5e-13 r_b.
constexpr double kMinRollSquare = 1e-12;  // rad²

Complex with_side(const Complex& w, double side) { return {w.real(), side * w.imag()}; }

// Converts ℓ′ and ℓ″, the derivatives with respect to the parameter, to θ′ and θ″, the
// derivatives with respect to u. [T8.5]
void slopes(const Complex& d1, const Complex& d2, double& theta1, double& theta2) {
  const double inverse = 1.0 / d1.real();
  theta1 = d1.imag() * inverse;
  theta2 = (d2.imag() - theta1 * d2.real()) * inverse * inverse;
}

}  // namespace

Profile::Profile(const Arc& arc, double side, double twist)
    : curve_(arc.curve),
      involute_(curve_if<Involute>(*curve_)),
      circle_(curve_if<RackTrochoid>(*curve_)),
      side_(side),
      s_lo_(std::min(arc.begin, arc.end)),
      s_hi_(std::max(arc.begin, arc.end)) {
  const double u_begin = std::log(arc.begin_point.norm());
  const double u_end = std::log(arc.end_point.norm());
  u_lo_ = std::min(u_begin, u_end);
  u_hi_ = std::max(u_begin, u_end);
  if (involute_) {
    xi_sign_ = arc.begin + arc.end < 0.0 ? -1.0 : 1.0;
    grows_ = xi_sign_ > 0.0;
    arm_per_cos_ = involute_->base_radius() / std::hypot(1.0, involute_->base_radius() * twist);
  } else if (circle_) {
    grows_ = (u_end > u_begin) == (arc.end > arc.begin);
    arm_per_cos_ = circle_->motion().pitch_radius * circle_->motion().cos_beta;
  } else {
    t_lo_ = u_begin < u_end ? arc.begin : arc.end;
    t_hi_ = u_begin < u_end ? arc.end : arc.begin;
    s_lo_ = u_lo_;
    s_hi_ = u_hi_;
    grows_ = true;
    arm_per_cos_ = twist;  // not constant; turn_per_removal() computes it from the twist
  }
}

Profile::Profile(const RackFlank& flank, double side)
    : side_(side),
      s_lo_(flank.u_lo),
      s_hi_(flank.u_hi),
      u_lo_(flank.u_lo),
      u_hi_(flank.u_hi),
      grows_(true),
      half_(flank.half),
      slope_(flank.slope) {}

PolarJet Profile::at(double s) const {
  if (involute_) return involute_->polar_jet(s).on_side(side_);
  if (circle_) return circle_->polar_jet(s).on_side(side_);
  const RadialJet r = curve_at_radius(s);
  return {std::exp(s) * r.factor / std::abs(r.factor), r.phase, Complex{1.0, r.d1},
          Complex{0.0, r.d2}};
}

RadialJet Profile::involute_at_radius(double u) const {
  const double ratio = std::exp(u) / involute_->base_radius();
  const double xi = xi_sign_ * std::sqrt(std::max(kMinRollSquare, (ratio - 1.0) * (ratio + 1.0)));
  RadialJet r;
  r.factor = Complex{1.0, side_ * xi};
  r.phase = side_ * (involute_->base_half_angle() - xi);
  r.d1 = -side_ * xi;
  r.d2 = -side_ * (1.0 + xi * xi) / xi;
  return r;
}

RadialJet Profile::circle_at_radius(double u, double& s) const {
  // Iterates from the last solution with steps of second order. The steps are limited to a
  // bracket, because otherwise a step may jump to the other end of the circle. The squares of
  // the radii are compared, so that no logarithm is needed near the solution.
  constexpr int kMax = 60;
  constexpr double kClose = 1e-8;  // in u; the series covers a smaller remainder
  // Below this limit of |x|, three terms of the logarithm have an error of x⁴/8 ≤ 1.3e-17.
  // Here, x = (ρ/ρ_s)² − 1, and ρ_s is the radius at s.
  constexpr double kSmall = 1e-4;
  const double square = std::exp(2.0 * u);
  double lo = s_lo_;
  double hi = s_hi_;
  if (!(s > lo && s < hi)) s = 0.5 * (lo + hi);
  PolarJet j;
  double rest = 0.0;
  for (int i = 0; i < kMax; ++i) {
    j = circle_->polar_jet(s);
    const double here = std::norm(j.factor);
    const double x = (square - here) / here;
    rest = std::abs(x) < kSmall ? x * (0.5 - x * (0.25 - x / 6.0)) : 0.5 * std::log1p(x);
    if (std::abs(rest) < kClose) break;
    ((rest > 0.0) == grows_ ? lo : hi) = s;
    const double step = rest / j.d1.real();
    double next = s + step * (1.0 - 0.5 * step * j.d2.real() / j.d1.real());
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (next == s) break;
    s = next;
  }
  j = j.on_side(side_);
  RadialJet r;
  slopes(j.d1, j.d2, r.d1, r.d2);
  r.factor = j.factor;
  r.phase = j.phase + (r.d1 + 0.5 * r.d2 * rest) * rest;
  r.d1 += r.d2 * rest;
  return r;
}

RadialJet Profile::curve_at_radius(double u) const {
  GW_EXPECTS(curve_ != nullptr);
  const double rho = std::exp(u);
  const CurvePoint p = curve_->at(curve_->parameter_at_radius(rho, t_lo_, t_hi_));
  const double theta = std::atan2(p.point.y(), p.point.x());
  const double chi = p.tangent_angle - theta;
  const double c = std::cos(chi);
  RadialJet r;
  r.factor = with_side({p.point.x(), p.point.y()}, side_);
  r.phase = 0.0;
  r.d1 = side_ * std::tan(chi);
  // dχ/du = (κρ − sin χ)/cos χ, the same for either direction of the curve. [T8.5]
  r.d2 = side_ * (p.curvature * rho - std::sin(chi)) / (c * c * c);
  return r;
}

RadialJet Profile::at_radius(double u, double& s) const {
  if (!curve_) return {1.0, side_ * (half_ - slope_ * u), -side_ * slope_, 0.0};
  const double inside = std::clamp(u, u_lo_, u_hi_);
  RadialJet r = involute_ ? involute_at_radius(inside)
                : circle_ ? circle_at_radius(inside, s)
                          : curve_at_radius(inside);
  if (const double beyond = u - inside; beyond != 0.0) {
    r.phase += (r.d1 + 0.5 * r.d2 * beyond) * beyond;
    r.d1 += r.d2 * beyond;
  }
  return r;
}

TurnPerRemoval Profile::turn_per_removal(double s) const {
  if (involute_) return {1.0 / arm_per_cos_, 0.0, 0.0};
  if (circle_) {
    // k = 1/(r cos β cos τ), because the rack moves along the datum line, and the component of its
    // normal along that line is cos τ cos β.
    const PolarJet j = circle_->polar_jet(s);
    const double k = 1.0 / (arm_per_cos_ * std::cos(s));
    const double t = std::tan(s);
    const double k_s = k * t;
    const double k_ss = k * (1.0 + 2.0 * t * t);
    const double s_u = 1.0 / j.d1.real();
    const double s_uu = -j.d2.real() * s_u * s_u * s_u;
    return {k, k_s * s_u, k_ss * s_u * s_u + k_s * s_uu};
  }
  const RadialJet r = curve_at_radius(s);
  return {std::sqrt((1.0 + r.d1 * r.d1) * std::exp(-2.0 * s) + arm_per_cos_ * arm_per_cos_), 0.0,
          0.0};
}

double Profile::s_of(double u) const { return s_of(u, 0.5 * (s_lo_ + s_hi_)); }

double Profile::s_of(double u, double start) const {
  const double inside = std::clamp(u, u_lo_, u_hi_);
  if (!involute_ && !circle_) return inside;
  if (involute_) {
    const double ratio = std::exp(inside) / involute_->base_radius();
    const double xi = xi_sign_ * std::sqrt(std::max(0.0, (ratio - 1.0) * (ratio + 1.0)));
    return std::clamp(xi, s_lo_, s_hi_);
  }
  double lo = s_lo_;
  double hi = s_hi_;
  double s = std::clamp(start, lo, hi);
  for (int i = 0; i < 200; ++i) {
    const auto [u_here, slope] = circle_->log_radius(s);
    const double rest = inside - u_here;
    if (std::abs(rest) <= kRounding) break;
    ((rest > 0.0) == grows_ ? lo : hi) = s;
    double next = s + rest / slope;
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - s) <= kRounding * std::abs(s)) break;
    s = next;
  }
  return s;
}

std::optional<double> Profile::rack_angle(double s) const {
  if (circle_) return s;
  return std::nullopt;
}

}  // namespace gearwright
