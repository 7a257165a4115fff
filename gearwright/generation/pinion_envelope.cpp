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

double PinionMotion::cutter_pitch_radius() const {
  return side() * distance * cutter_teeth / (cutter_teeth + teeth);
}

double PinionMotion::pitch_radius() const {
  return side() * distance * teeth / (cutter_teeth + teeth);
}

CurvePoint CornerFan::at(double nu) const {
  return {point_, nu - kPi / 2, -std::numeric_limits<double>::infinity()};
}

// The angles are computed only on request, because most functions do not use them.
struct PinionEnvelope::Contact {
  double s, q, w;
  double curvature;  // k of the cutter's curve, followed from root to tip
  double lambda() const { return w - q; }
  double kappa() const { return std::atan2(s, w); }
};

// The point of the gear is (along + i across) e^{i turn}.
struct PinionEnvelope::Place {
  double along, across, turn;
  Vec2 point() const {
    const double cos_t = std::cos(turn);
    const double sin_t = std::sin(turn);
    return {along * cos_t - across * sin_t, along * sin_t + across * cos_t};
  }
};

PinionEnvelope::PinionEnvelope(const PinionMotion& motion, CurvePtr cutter, Walk walk,
                               Meeting meeting)
    : motion_(motion),
      cutter_(std::move(cutter)),
      walk_(walk == Walk::forward ? 1.0 : -1.0),
      meeting_(meeting == Meeting::ahead ? 1.0 : -1.0),
      r_p_(motion.cutter_pitch_radius()),
      r_g_(motion.pitch_radius()),
      m_(motion.ratio()) {
  GW_EXPECTS(motion.cutter_teeth >= 1 && r_p_ > 0.0);
}

PinionEnvelope::Contact PinionEnvelope::contact(double t) const {
  const CurvePoint p = cutter_->at(t);
  const double cos_t = walk_ * std::cos(p.tangent_angle);
  const double sin_t = walk_ * std::sin(p.tangent_angle);
  Contact c;
  c.s = std::max(0.0, p.point.x() * cos_t + p.point.y() * sin_t);  // never negative on an outline
  c.q = p.point.y() * cos_t - p.point.x() * sin_t;
  // At the limit of reach, s equals r_p within rounding, and the square root would lose half of the
  // digits. If w is set to 0, the paths ahead of and behind the tooth end in the same point.
  const bool at_limit = r_p_ - c.s < 4 * std::numeric_limits<double>::epsilon() * r_p_;
  c.w = at_limit ? 0.0 : meeting_ * std::sqrt(std::max(0.0, (r_p_ - c.s) * (r_p_ + c.s)));
  c.curvature = walk_ * p.curvature;
  return c;
}

PinionEnvelope::Place PinionEnvelope::place(double t, const Contact& c) const {
  // ν lies in the half turn that begins at the polar angle. The polar angle is continuous along the
  // curve.
  const double turned = cutter_->polar_angle(t) + std::atan2(c.s, c.q) - c.kappa();  // ϑ = ν − κ
  // r_g + λ e^{iκ} with e^{iκ} = (w + is)/r_p. On an internal gear, the negative of its conjugate
  // is used instead.
  return {motion_.side() * (r_g_ + c.lambda() * c.w / r_p_), c.lambda() * c.s / r_p_,
          kPi / std::abs(motion_.teeth) - std::abs(m_) * turned};
}

Vec2 PinionEnvelope::point(double t) const { return place(t, contact(t)).point(); }

double PinionEnvelope::polar_angle(double t) const {
  const Place here = place(t, contact(t));
  return here.turn + std::atan2(here.across, here.along);
}

CurvePoint PinionEnvelope::at(double t) const {
  const Contact c = contact(t);
  const double lambda = c.lambda();
  const double n = 1.0 + m_;
  // k_g = (k w + n (1 − kλ))/(w + nλ (1 − kλ)), [T6.9]. At a corner, where t is ν and k = −∞,
  // numerator and denominator are divided by k.
  double above, below;
  if (std::isinf(c.curvature)) {
    above = c.w - n * lambda;
    below = -n * lambda * lambda;
  } else {
    above = c.curvature * c.w + n * (1.0 - c.curvature * lambda);
    below = c.w + n * lambda * (1.0 - c.curvature * lambda);
  }
  const double side = motion_.side();
  const double direction = walk_ * meeting_ * below;  // > 0 if t grows along `tangent`
  const Place here = place(t, c);
  const double tangent = here.turn + side * (c.kappa() + kPi / 2) + (side > 0.0 ? 0.0 : kPi);
  return {here.point(), tangent + (direction < 0.0 ? kPi : 0.0),
          side * above / below * (direction < 0.0 ? -1.0 : 1.0)};
}

bool PinionEnvelope::reaches(double t) const { return contact(t).s < r_p_; }

bool PinionEnvelope::cuts(double t) const {
  const Contact c = contact(t);
  if (!(c.s < r_p_)) return false;
  if (std::isinf(c.curvature)) return true;  // for a corner, w G = n λ²/ρ with ρ → 0
  return c.w + (1.0 + m_) * c.lambda() * (1.0 - c.curvature * c.lambda()) > 0.0;
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
                             const bool hollow = walk_ > 0.0;
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
  const double n = 1.0 + m_;
  const auto ring = circle();
  std::vector<double> found;
  if (!ring) {
    const auto reach_and_w_g = [&](double t) {
      const Contact c = contact(t);
      return std::array{c.s - r_p_, c.w + n * c.lambda() * (1.0 - c.curvature * c.lambda())};
    };
    for (const auto& roots : sign_changes<2>(reach_and_w_g, a, b))
      found.insert(found.end(), roots.begin(), roots.end());
    return in_order(std::move(found), a, b);
  }
  const auto [d, gamma, rho, nu_to_t] = *ring;
  if (d > r_p_) {
    const double angle = std::asin(r_p_ / d);
    found = {gamma + angle + nu_to_t, gamma + kPi - angle + nu_to_t};
  }
  if (rho != 0.0) {
    // w G ρ = ρ w + n h (h − ρ), multiplied by 2h. [T6.9]
    const double k = (r_p_ - d) * (r_p_ + d);
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
  const double one = 1.0 + 1.0 / m_;
  if (!ring) {
    const auto f = [&](double t) {
      const Contact c = contact(t);
      return std::array{c.q - c.w * one};
    };
    return in_order(std::move(sign_changes<1>(f, a, b)[0]), a, b);
  }
  const auto [d, gamma, rho, nu_to_t] = *ring;
  // D cos(ν − γ) + ρ = w (1 + 1/m), multiplied by 2h.
  const double k = (r_p_ - d) * (r_p_ + d);
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
