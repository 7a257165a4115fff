#include "gearwright/cad/screw_spline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/curve/arc_length.hpp"

namespace gearwright {
namespace {

constexpr int kDegree = 5;
constexpr int kChecksPerSpan = 24;
constexpr double kShortestSpan = 1e-9;
// Least permitted speed along the curve with respect to the curve's own parameter, relative to the
// mean speed.
constexpr double kSlowest = 0.01;

using ParameterAt = std::function<double(double)>;  // maps u in [0, 1] to the curve's parameter

Complex value(const BSplineBasis& basis, const std::vector<Complex>& poles, double u) {
  const BSplineBasis::Local local = basis.local(u);
  Complex sum = 0.0;
  for (std::size_t j = 0; j < local.values.size(); ++j) {
    sum += local.values[j] * poles[static_cast<std::size_t>(local.first) + j];
  }
  return sum;
}

std::vector<Complex> interpolate(const BSplineBasis& basis, const std::vector<Complex>& samples) {
  Eigen::MatrixXd xy(basis.poles(), 2);
  for (int i = 0; i < basis.poles(); ++i) {
    const Complex& w = samples[static_cast<std::size_t>(i)];
    xy.row(i) << w.real(), w.imag();
  }
  const Eigen::MatrixXd p = basis.interpolate(xy);
  std::vector<Complex> poles;
  poles.reserve(samples.size());
  for (int i = 0; i < basis.poles(); ++i) poles.emplace_back(p(i, 0), p(i, 1));
  return poles;
}

// Returns the normal distance from q to the curve near the parameter t. The result is the distance
// from q to the tangent at t, minus the sagitta κ s²/2 of the osculating circle. s is the offset of
// q along the tangent, and the error is of third order in s. If |κ s| ≥ 0.01, the function returns
// the distance from q to the point at t instead, which is larger than the normal distance.
double normal_distance(const Curve& curve, double t, Complex q) {
  const CurvePoint w = curve.at(t);
  const Vec2 d = Vec2(q.real(), q.imag()) - w.point;
  const double c = std::cos(w.tangent_angle);
  const double s = std::sin(w.tangent_angle);
  const double along = c * d.x() + s * d.y();
  const double bend = w.curvature * along;
  if (!(std::abs(bend) < 0.01)) return d.norm();
  return std::abs(-s * d.x() + c * d.y() - 0.5 * bend * along);
}

struct Candidate {
  BSplineBasis basis;
  std::vector<Complex> poles;
  std::vector<double> span_deviation;
  double deviation;
};

Candidate fit(BSplineBasis basis, const Curve& curve, const ParameterAt& t_at, Complex begin,
              Complex end) {
  std::vector<Complex> samples;
  for (const double g : basis.greville()) {
    const Vec2 w = curve.point(t_at(g));
    samples.emplace_back(w.x(), w.y());
  }
  samples.front() = begin;
  samples.back() = end;
  std::vector<Complex> poles = interpolate(basis, samples);
  std::vector<double> spans = worst_by_span(basis, kChecksPerSpan, [&](double u) {
    return normal_distance(curve, t_at(u), value(basis, poles, u));
  });
  const double worst = *std::max_element(spans.begin(), spans.end());
  return {std::move(basis), std::move(poles), std::move(spans), worst};
}

// Tries uniform knots first, from the fewest poles to 40. If no such spline reaches the target, the
// function begins with 16 uniform spans and repeatedly halves the spans that miss the target.
Candidate fit_to(const Curve& curve, const ParameterAt& t_at, Complex begin, Complex end,
                 double target) {
  std::optional<Candidate> best;
  const auto good = [&](Candidate candidate) {
    if (!best || candidate.deviation < best->deviation) best = std::move(candidate);
    return best->deviation <= target;
  };
  for (int poles = kDegree + 1; poles <= 40; poles += 1 + poles / 10) {
    if (good(fit(BSplineBasis(kDegree, poles), curve, t_at, begin, end))) return *best;
  }
  Candidate current = fit(BSplineBasis(kDegree, kDegree + 16), curve, t_at, begin, end);
  while (true) {
    std::optional<BSplineBasis> next = refined(current.basis, current.span_deviation, target);
    if (!next || next->poles() > kMaxPoles) return *best;
    current = fit(*std::move(next), curve, t_at, begin, end);
    if (good(current)) return *best;
  }
}

// True if the slowest speed exceeds kSlowest times the mean speed, measured over equal steps of the
// curve's own parameter.
bool runs_evenly(const Arc& arc) {
  constexpr int kSteps = 64;
  double slowest = 0.0;
  double sum = 0.0;
  Vec2 last = arc.point(0.0);
  for (int i = 1; i <= kSteps; ++i) {
    const Vec2 next = arc.point(static_cast<double>(i) / kSteps);
    const double step = (next - last).norm();
    slowest = i == 1 ? step : std::min(slowest, step);
    sum += step;
    last = next;
  }
  return slowest * kSteps > kSlowest * sum;
}

}  // namespace

std::vector<double> places_between_knots(const BSplineBasis& basis, int n) {
  const std::vector<double> knots = basis.distinct_knots();
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int k = 0; k < n; ++k)
      places.push_back(knots[i] + (knots[i + 1] - knots[i]) * (k + 0.5) / n);
  return places;
}

std::vector<double> worst_by_span(const BSplineBasis& basis, int n,
                                  const std::function<double(double)>& error) {
  const std::vector<double> places = places_between_knots(basis, n);
  std::vector<double> worst(places.size() / static_cast<std::size_t>(n), 0.0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    double& span = worst[i / static_cast<std::size_t>(n)];
    span = std::max(span, error(places[i]));
  }
  return worst;
}

std::optional<BSplineBasis> refined(const BSplineBasis& basis,
                                    const std::vector<double>& span_deviation, double target) {
  std::vector<double> knots = basis.knots();
  const std::size_t before = knots.size();
  const std::vector<double> at = basis.distinct_knots();
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    if (span_deviation[i] > target && at[i + 1] - at[i] > kShortestSpan)
      knots.push_back(0.5 * (at[i] + at[i + 1]));
  if (knots.size() == before) return std::nullopt;
  std::sort(knots.begin(), knots.end());
  return BSplineBasis(basis.degree(), std::move(knots));
}

Complex SectionSpline::at(double u) const { return value(basis, poles, u); }
Complex HelixSpline::at(double v) const { return value(basis, poles, v); }

SectionSpline fit_section(const Arc& arc, double target_mm) {
  const Complex begin(arc.begin_point.x(), arc.begin_point.y());
  const Complex end(arc.end_point.x(), arc.end_point.y());
  const Curve& curve = *arc.curve;
  const ArcLength length(curve, arc.begin, arc.end);
  const Candidate by_length = fit_to(
      curve, [&](double u) { return length.parameter(u * length.length()); }, begin, end,
      target_mm);
  if (runs_evenly(arc)) {
    const Candidate own = fit_to(
        curve, [&](double u) { return arc.begin + u * (arc.end - arc.begin); }, begin, end,
        target_mm);
    const bool own_good = own.deviation <= target_mm;
    const bool length_good = by_length.deviation <= target_mm;
    const bool own_wins = own_good && length_good ? own.basis.poles() < by_length.basis.poles()
                                                  : own.deviation < by_length.deviation;
    if (own_wins) return {own.basis, own.poles, own.deviation, false};
  }
  return {by_length.basis, by_length.poles, by_length.deviation, true};
}

HelixSpline fit_helix(double delta, double radius) {
  GW_EXPECTS(std::abs(delta) <= std::numbers::pi);
  GW_EXPECTS(radius > 0.0);
  if (delta == 0.0) return {BSplineBasis(1, 2), {1.0, 1.0}, 0.0};
  const double target = std::max(kHelixTarget_mm / radius, 1e-14);
  for (int poles = kDegree + 1;; ++poles) {
    GW_ENSURES(poles <= kMaxPoles);
    BSplineBasis basis(kDegree, poles);
    std::vector<Complex> samples;
    for (const double g : basis.greville()) samples.push_back(std::polar(1.0, delta * (g - 0.5)));
    std::vector<Complex> h = interpolate(basis, samples);
    const std::vector<double> spans = worst_by_span(basis, kChecksPerSpan, [&](double v) {
      return std::abs(value(basis, h, v) - std::polar(1.0, delta * (v - 0.5)));
    });
    const double worst = *std::max_element(spans.begin(), spans.end());
    if (worst <= target) return {std::move(basis), std::move(h), worst};
  }
}

}  // namespace gearwright
