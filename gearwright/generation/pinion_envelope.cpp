#include "gearwright/generation/pinion_envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/overloaded.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// Returns, for each of several functions that are computed together, the roots between a and b. For
// the curves of a tooth, the cells are so narrow that each contains at most one root.
template <std::size_t n, class F>
std::array<std::vector<double>, n> sign_changes(const F& f, double a, double b) {
  constexpr int kCells = 256;
  std::array<std::vector<double>, n> roots;
  double t = a;
  std::array<double, n> values = f(a);
  for (int i = 1; i <= kCells; ++i) {
    const double next = i == kCells ? b : a + (b - a) * i / kCells;
    const std::array<double, n> there = f(next);
    for (std::size_t k = 0; k < n; ++k) {
      if ((values[k] < 0.0) == (there[k] < 0.0)) continue;
      const auto of_k = [&](double at) { return f(at)[k]; };
      roots[k].push_back(find_root(of_k, std::min(t, next), std::max(t, next)).x);
    }
    t = next;
    values = there;
  }
  return roots;
}

}  // namespace

PinionEnvelope::PinionEnvelope(const PinionMotion& motion, CurvePtr cutter, Walk walk,
                               Meeting meeting)
    : cutter_(std::move(cutter)), way_(motion, walk, meeting) {
  GW_EXPECTS(motion.cutter_teeth >= 1 && way_.r_p > 0.0);
}

jets::PinionContact<double> PinionEnvelope::contact(double t) const {
  const CurvePoint p = cutter_->at(t);
  return {way_, {p.point.x(), p.point.y()}, p.tangent_angle, p.curvature};
}

bool PinionEnvelope::reaches(double t) const { return contact(t).s < way_.r_p; }

bool PinionEnvelope::cuts(double t) const {
  const auto c = contact(t);
  if (!(c.s < way_.r_p)) return false;
  if (std::isinf(c.curvature)) return true;  // for a corner, w G = n λ²/ρ with ρ → 0
  return c.w_g(way_.m) > 0.0;
}

// The cutter's curve as a circle of radius ρ about a centre at the distance D and the polar angle
// γ; ρ < 0 if the curve is concave. h = λ + ρ is the distance from the centre to the pitch point.
// With K = r_p² − D², all terms are rational in h:  D cos(ν − γ) = (K − h²)/(2h),
// w = (K + h²)/(2h).
struct PinionEnvelope::Circle {
  double distance, direction, rho;
  double nu_to_t;  // t − ν
};

std::optional<PinionEnvelope::Circle> PinionEnvelope::circle() const {
  using None = std::optional<Circle>;
  return visit_curve<CornerFan, OffsetCircle>(
      *cutter_, Overloaded{[](const CornerFan* corner) -> None {
                             const Vec2 p = corner->point(0.0);
                             return Circle{p.norm(), std::atan2(p.y(), p.x()), 0.0, 0.0};
                           },
                           [&](const OffsetCircle* c) -> None {
                             // along a concave curve, the parameter grows from root to tip
                             const bool hollow = way_.walk > 0.0;
                             return Circle{c->distance(), c->direction(),
                                           hollow ? -c->radius() : c->radius(),
                                           hollow ? -kPi : 0.0};
                           },
                           [](const auto*) -> None { return std::nullopt; }});
}

namespace {

// Keeps the values between a and b, ordered in the direction from a to b.
std::vector<double> in_order(std::vector<double> t, double a, double b) {
  const auto [lo, hi] = std::minmax(a, b);
  t.erase(std::remove_if(t.begin(), t.end(),
                         [lo = lo, hi = hi](double v) { return !(v > lo && v < hi); }),
          t.end());
  std::sort(t.begin(), t.end());
  if (b < a) std::reverse(t.begin(), t.end());
  return t;
}

}  // namespace

std::vector<double> PinionEnvelope::breaks(double a, double b) const {
  const double n = 1.0 + way_.m;
  const auto ring = circle();
  std::vector<double> found;
  if (!ring) {
    const auto reach_and_w_g = [&](double t) {
      const auto c = contact(t);
      return std::array{c.s - way_.r_p, c.w_g(way_.m)};
    };
    for (const auto& roots : sign_changes<2>(reach_and_w_g, a, b))
      found.insert(found.end(), roots.begin(), roots.end());
    return in_order(std::move(found), a, b);
  }
  const auto [d, gamma, rho, nu_to_t] = *ring;
  if (d > way_.r_p) {
    const double angle = std::asin(way_.r_p / d);
    found = {gamma + angle + nu_to_t, gamma + kPi - angle + nu_to_t};
  }
  if (rho != 0.0) {
    // w G ρ = ρ w + n h (h − ρ), multiplied by 2h. [T6.9]
    const double k = (way_.r_p - d) * (way_.r_p + d);
    const double cubic[] = {rho * k, 0.0, rho * (1.0 - 2.0 * n), 2.0 * n};
    for (double h : centre_ways(cubic, a, b)) {
      const double c = std::clamp((k - h * h) / (2.0 * h * d), -1.0, 1.0);
      found.push_back(gamma + std::acos(c) + nu_to_t);
    }
  }
  return in_order(std::move(found), a, b);
}

// Returns those roots of a polynomial in h that lie between the values of h at the ends a and b of
// a piece. h is monotone along the piece if the normal meets the centrode everywhere.
std::vector<double> PinionEnvelope::centre_ways(std::span<const double> polynomial, double a,
                                                double b) const {
  const double rho = circle()->rho;
  const double h_a = contact(a).lambda() + rho;
  const double h_b = contact(b).lambda() + rho;
  std::vector<double> roots = polynomial_roots(polynomial, std::min(h_a, h_b), std::max(h_a, h_b));
  roots.erase(std::remove(roots.begin(), roots.end(), 0.0), roots.end());
  return roots;
}

std::vector<double> PinionEnvelope::turns(double a, double b) const {
  const auto ring = circle();
  const double one = 1.0 + 1.0 / way_.m;
  if (!ring) {
    const auto f = [&](double t) {
      const auto c = contact(t);
      return std::array{c.q - c.w * one};
    };
    return in_order(std::move(sign_changes<1>(f, a, b)[0]), a, b);
  }
  const auto [d, gamma, rho, nu_to_t] = *ring;
  // D cos(ν − γ) + ρ = w (1 + 1/m), multiplied by 2h.
  const double k = (way_.r_p - d) * (way_.r_p + d);
  const double quadratic[] = {k - one * k, 2.0 * rho, -1.0 - one};
  std::vector<double> found;
  for (double h : centre_ways(quadratic, a, b)) {
    const double c = std::clamp((k - h * h) / (2.0 * h * d), -1.0, 1.0);
    found.push_back(gamma + std::acos(c) + nu_to_t);
  }
  return in_order(std::move(found), a, b);
}

std::optional<PinionInvolute> pinion_involute(const PinionMotion& motion, const Involute& cutter,
                                              Meeting meeting) {
  const double r_p = motion.cutter_pitch_radius();
  const double r_b = cutter.base_radius();
  if (!(r_b < r_p)) return std::nullopt;
  const double way = meeting == Meeting::ahead ? 1.0 : -1.0;
  const double tan_w = way * std::sqrt((r_p - r_b) * (r_p + r_b)) / r_b;
  const double n = motion.side() * (1.0 + motion.ratio());
  const double m = std::abs(motion.ratio());
  const double psi =
      kPi / std::abs(motion.teeth) + n * involute_of_roll(tan_w) - m * cutter.base_half_angle();
  return PinionInvolute{Involute(r_b / m, psi), n * tan_w, -m};
}

}  // namespace gearwright
