#include "gearwright/contact/profile.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/overloaded.hpp"

namespace gearwright {

namespace {

constexpr double kRounding = 4e-16;  // rounding error, absolute for ln ρ, relative for a parameter
// |θ″| = (1 + ξ²)/ξ of an involute is infinite on the base circle (ξ = 0). If ξ² is less than
// kMinRollSquare, the polar angle and the slopes are therefore computed at ξ² = kMinRollSquare,
// where the radius is r_b (1 + 5e-13).
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
      side_(side),
      s_lo_(std::min(arc.begin, arc.end)),
      s_hi_(std::max(arc.begin, arc.end)) {
  const double u_begin = std::log(arc.begin_point.norm());
  const double u_end = std::log(arc.end_point.norm());
  u_lo_ = std::min(u_begin, u_end);
  u_hi_ = std::max(u_begin, u_end);
  const auto involute = [&](const Involute* curve) -> Piece {
    const double sign = arc.begin + arc.end < 0.0 ? -1.0 : 1.0;
    const double r_b = curve->base_radius();
    grows_ = sign > 0.0;
    return InvolutePiece{curve, sign, r_b / std::hypot(1.0, r_b * twist)};
  };
  const auto trochoid = [&](const RackTrochoid* curve) -> Piece {
    grows_ = (u_end > u_begin) == (arc.end > arc.begin);
    return TrochoidPiece{curve, curve->motion().pitch_radius * curve->motion().cos_beta};
  };
  const auto other = [&](const Curve* curve) -> Piece {
    grows_ = true;
    s_lo_ = u_lo_;
    s_hi_ = u_hi_;
    const bool rises = u_begin < u_end;
    return RadialPiece{curve, rises ? arc.begin : arc.end, rises ? arc.end : arc.begin, twist};
  };
  piece_ = visit_curve<Involute, RackTrochoid>(*curve_, Overloaded{involute, trochoid, other});
}

Profile::Profile(const RackFlank& flank, double side)
    : side_(side),
      s_lo_(flank.u_lo),
      s_hi_(flank.u_hi),
      u_lo_(flank.u_lo),
      u_hi_(flank.u_hi),
      grows_(true),
      piece_(flank) {}

PolarJet Profile::at(double s) const {
  GW_EXPECTS(curve_ != nullptr);
  const auto jet = [&](const auto& piece) {
    if constexpr (requires { piece.curve->jet(s); }) {
      return polar_jet(piece.curve->jet(s)).on_side(side_);
    } else {
      double unused = s;
      const RadialJet r = between_ends(piece, s, unused);
      return PolarJet{std::exp(s) * r.factor / std::abs(r.factor), r.phase, Complex{1.0, r.d1},
                      Complex{0.0, r.d2}};
    }
  };
  return std::visit(jet, piece_);
}

RadialJet Profile::between_ends(const InvolutePiece& piece, double u, double&) const {
  const double ratio = std::exp(u) / piece.curve->base_radius();
  const double xi = piece.sign * std::sqrt(std::max(kMinRollSquare, (ratio - 1.0) * (ratio + 1.0)));
  const jets::Involute<double> j = piece.curve->jet(xi);
  return {{1.0, side_ * xi}, side_ * j.phase(), side_ * j.theta1(), side_ * j.theta2()};
}

RadialJet Profile::between_ends(const TrochoidPiece& piece, double u, double& s) const {
  // The iteration starts at the last solution and uses steps of second order. A bracket limits the
  // steps, because otherwise a step may jump to the other end of the circle. The squares of the
  // radii are compared, so that no logarithm is needed near the solution.
  constexpr int kMax = 60;
  constexpr double kClose = 1e-8;  // greatest remainder of u for which the series is used
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
    j = polar_jet(piece.curve->jet(s));
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

RadialJet Profile::between_ends(const RadialPiece& piece, double u, double&) const {
  const double rho = std::exp(u);
  const CurvePoint p =
      piece.curve->at(piece.curve->parameter_at_radius(rho, piece.t_lo, piece.t_hi));
  const double theta = std::atan2(p.point.y(), p.point.x());
  const double chi = p.tangent_angle - theta;
  const double c = std::cos(chi);
  RadialJet r;
  r.factor = with_side({p.point.x(), p.point.y()}, side_);
  r.phase = 0.0;
  r.d1 = side_ * std::tan(chi);
  // dχ/du = (κρ − sin χ)/cos χ for the angle χ from the radius to the tangent. The formula is the
  // same for either direction of the curve. [T8.5]
  r.d2 = side_ * (p.curvature * rho - std::sin(chi)) / (c * c * c);
  return r;
}

RadialJet Profile::between_ends(const RackFlank& piece, double u, double&) const {
  return {1.0, side_ * (piece.half - piece.slope * u), -side_ * piece.slope, 0.0};
}

RadialJet Profile::at_radius(double u, double& s) const {
  // The straight flank of a rack continues beyond its ends, so no series is needed.
  const double inside = curve_ ? std::clamp(u, u_lo_, u_hi_) : u;
  RadialJet r =
      std::visit([&](const auto& piece) { return between_ends(piece, inside, s); }, piece_);
  if (const double beyond = u - inside; beyond != 0.0) {
    r.phase += (r.d1 + 0.5 * r.d2 * beyond) * beyond;
    r.d1 += r.d2 * beyond;
  }
  return r;
}

TurnPerRemoval Profile::turn_per_removal(double s) const {
  GW_EXPECTS(curve_ != nullptr);
  const auto involute = [](const InvolutePiece& piece) {
    return TurnPerRemoval{1.0 / piece.arm, 0.0, 0.0};
  };
  const auto trochoid = [s](const TrochoidPiece& piece) {
    // k = 1/(r cos β cos τ). The rack moves along the datum line, and the component of the normal
    // along that line is cos τ cos β.
    const PolarJet j = polar_jet(piece.curve->jet(s));
    const double k = 1.0 / (piece.arm_per_cos * std::cos(s));
    const double t = std::tan(s);
    const double k_s = k * t;
    const double k_ss = k * (1.0 + 2.0 * t * t);
    const double s_u = 1.0 / j.d1.real();
    const double s_uu = -j.d2.real() * s_u * s_u * s_u;
    return TurnPerRemoval{k, k_s * s_u, k_ss * s_u * s_u + k_s * s_uu};
  };
  const auto radial = [&](const RadialPiece& piece) {
    double unused = s;
    const double d1 = between_ends(piece, s, unused).d1;
    return TurnPerRemoval{
        std::sqrt((1.0 + d1 * d1) * std::exp(-2.0 * s) + piece.twist * piece.twist), 0.0, 0.0};
  };
  const auto rack = [](const RackFlank&) { return TurnPerRemoval{}; };  // excluded above
  return std::visit(Overloaded{involute, trochoid, radial, rack}, piece_);
}

double Profile::s_of(double u) const { return s_of(u, 0.5 * (s_lo_ + s_hi_)); }

double Profile::s_of(double u, double start) const {
  const double inside = std::clamp(u, u_lo_, u_hi_);
  const auto involute = [&](const InvolutePiece& piece) {
    const double ratio = std::exp(inside) / piece.curve->base_radius();
    const double xi = piece.sign * std::sqrt(std::max(0.0, (ratio - 1.0) * (ratio + 1.0)));
    return std::clamp(xi, s_lo_, s_hi_);
  };
  const auto trochoid = [&](const TrochoidPiece& piece) {
    double lo = s_lo_;
    double hi = s_hi_;
    double s = std::clamp(start, lo, hi);
    for (int i = 0; i < 200; ++i) {
      const PolarJet j = polar_jet(piece.curve->jet(s));
      const double rest = inside - 0.5 * std::log(std::norm(j.factor));
      if (std::abs(rest) <= kRounding) break;
      ((rest > 0.0) == grows_ ? lo : hi) = s;
      double next = s + rest / j.d1.real();
      if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
      if (std::abs(next - s) <= kRounding * std::abs(s)) break;
      s = next;
    }
    return s;
  };
  const auto by_radius = [inside](const auto&) { return inside; };
  return std::visit(Overloaded{involute, trochoid, by_radius}, piece_);
}

std::optional<double> Profile::rack_angle(double s) const {
  if (std::holds_alternative<TrochoidPiece>(piece_)) return s;
  return std::nullopt;
}

}  // namespace gearwright
