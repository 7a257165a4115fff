#include "gearwright/scatter/robust_search.hpp"

#include <algorithm>
#include <functional>

#include "gearwright/math/minimise.hpp"
#include "gearwright/math/statistics.hpp"

namespace gearwright {

namespace {

constexpr double kFirstRadius = 0.25;  // first trust radius, relative to the width of the box
constexpr double kLastRadius = 1e-3;   // the descent ends below this radius
constexpr int kMostSteps = 20;         // greatest number of steps of a descent

// The mean of f over the worst fraction 1 − p of the samples. If a sample belongs only partly to
// this fraction, it is weighted with that part.   [T14.17]
double mean_of_worst(std::vector<double> f, double p) {
  const double worst = (1.0 - p) * static_cast<double>(f.size());
  const auto whole = std::min(static_cast<std::size_t>(worst), f.size() - 1);
  std::nth_element(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(whole), f.end(),
                   std::greater<>());
  std::sort(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(whole));
  double sum = (worst - static_cast<double>(whole)) * f[whole];
  for (std::size_t i = 0; i < whole; ++i) sum += f[i];
  return sum / worst;
}

MinimiserTask task_of(const RobustSearch& s, int evaluations, double step,
                      std::function<double(const std::vector<double>&)> f) {
  MinimiserTask search{.evaluations = evaluations, .gain = s.gain, .f = std::move(f)};
  for (const Correction& c : s.box) {
    search.lo.push_back(c.lo);
    search.hi.push_back(c.hi);
    search.step.push_back(step * (c.hi - c.lo));
  }
  return search;
}

// Minimises the CVaR by descent. Each step goes to the minimum of the linearised problem within a
// radius, which grows after a success and shrinks after a failure.   [T14.18]
std::vector<double> descend(const RobustSearch& s, std::vector<double> v) {
  double radius = kFirstRadius;
  CorrectedFamily::Values here = s.fine.at(v, true);
  double worth = mean_of_worst(here.f, s.p);
  for (int step = 0; step < kMostSteps && radius >= kLastRadius; ++step) {
    MinimiserTask model = task_of(s, 200 * static_cast<int>(v.size()), 0.5 * radius,
                                  [&](const std::vector<double>& w) {
                                    std::vector<double> f = here.f;
                                    for (std::size_t k = 0; k < f.size(); ++k)
                                      for (std::size_t i = 0; i < v.size(); ++i)
                                        f[k] += here.slope[k][i] * (w[i] - v[i]);
                                    return mean_of_worst(std::move(f), s.p);
                                  });
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double reach = radius * (model.hi[i] - model.lo[i]);
      model.lo[i] = std::max(model.lo[i], v[i] - reach);
      model.hi[i] = std::min(model.hi[i], v[i] + reach);
    }
    const std::vector<double> next = minimise(Minimiser::downhill, model, v);
    const double promised = worth - model.f(next);
    if (!(promised > s.gain)) break;
    const double gained = worth - mean_of_worst(s.fine.at(next, false).f, s.p);
    if (gained < 0.25 * promised) radius *= 0.35;
    if (gained > 0.75 * promised) radius = std::min(1.0, 2.0 * radius);
    if (!(gained > 0.0)) continue;
    v = next;
    here = s.fine.at(v, true);
    worth = mean_of_worst(here.f, s.p);
  }
  return v;
}

}  // namespace

double CorrectedFamily::percentile(const std::vector<double>& v, double p) const {
  std::vector<double> f = at(v, false).f;
  std::sort(f.begin(), f.end());
  return quantile(f, p);
}

void add_difference(CorrectedFamily::Values& values, const CorrectedFamily& family,
                    const std::vector<double>& v, std::size_t i, const Correction& bounds) {
  const double step = bounds.step / kRobustParts;
  std::vector<double> w = v;
  w[i] += v[i] + step <= bounds.hi ? step : -step;
  const std::vector<double> moved = family.at(w, false).f;
  for (std::size_t k = 0; k < values.f.size(); ++k)
    values.slope[k][i] = (moved[k] - values.f[k]) / (w[i] - v[i]);
}

std::vector<double> lowest_percentile(const RobustSearch& s, const std::vector<double>& start) {
  const int n = static_cast<int>(start.size());
  std::vector<double> best = start;
  double least = s.fine.percentile(start, s.p);
  const auto take = [&](const std::vector<double>& v) {
    const double f = s.fine.percentile(v, s.p);
    if (!(f < least)) return;
    least = f;
    best = v;
  };
  take(descend(s, start));
  if (s.whole_box) {
    const auto box = task_of(s, 40 * n, kFirstRadius, [&](const std::vector<double>& v) {
      return s.coarse.percentile(v, s.p);
    });
    const std::vector<double> of_box = minimise(Minimiser::whole_box, box, start);
    take(of_box);
    take(descend(s, of_box));
  }
  const auto polish = task_of(
      s, 15 * n, 0.02, [&](const std::vector<double>& v) { return s.fine.percentile(v, s.p); });
  take(minimise(Minimiser::downhill, polish, best));
  return best;
}

}  // namespace gearwright
