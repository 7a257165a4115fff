#include "gearwright/scatter/loosening.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/scatter/sample_points.hpp"

namespace gearwright {

namespace {

constexpr double kNarrow = 1.01;  // ratio of the ends of a bracket at which halving stops

class Loosener {
 public:
  Loosener(const ContactSetup& setup, const ScatterTask& task)
      : setup_(setup),
        task_(task),
        places_(SamplePoints(task).first(0, task.samples)),
        percent_(*std::max_element(task.percentiles.begin(), task.percentiles.end())) {}

  double percent() const { return percent_; }

  // Returns the percentile of the peak to peak for which the coordinates of one tolerance are
  // multiplied by `factor`. Returns none if the teeth are impossible at an end of the resulting
  // range.
  std::optional<double> percentile(std::size_t tolerance, double factor) const {
    ScatterTask changed = task_;
    changed.tolerances[tolerance].unit *= factor;
    if (check_ends(setup_, std::span(changed.tolerances).subspan(tolerance, 1)))
      return std::nullopt;
    std::vector<double> f = ranked(spans_at(setup_, changed, places_));
    std::sort(f.begin(), f.end());
    return quantile(f, percent_ / 100.0);
  }

  std::optional<double> factor(std::size_t tolerance, double limit) const {
    const auto over = [&](double s) {
      const auto p = percentile(tolerance, s);
      return p && *p > limit;
    };
    double lo = 1.0;
    double hi = std::numbers::sqrt2;
    while (hi < kMostFactor * kNarrow && !over(hi)) {
      lo = hi;
      hi *= std::numbers::sqrt2;
    }
    if (hi >= kMostFactor * kNarrow) return std::nullopt;
    while (hi > kNarrow * lo) {
      const double middle = std::sqrt(lo * hi);
      (over(middle) ? hi : lo) = middle;
    }
    return lo;
  }

 private:
  const ContactSetup& setup_;
  const ScatterTask& task_;
  std::vector<std::vector<double>> places_;
  double percent_;
};

}  // namespace

Loosening loosening_of(const ContactSetup& setup, const ScatterTask& task) {
  const Loosener loosener(setup, task);
  constexpr std::int64_t kUsual = 10;  // usual number of percentiles computed for a tolerance
  begin_stage(task.progress, "loosening the tolerances",
              kUsual * static_cast<std::int64_t>(task.tolerances.size()) * task.samples);
  Loosening found{loosener.percent(), loosener.percentile(0, 1.0).value(), {}, {}};
  double least = found.percentile - kSameError.rad();
  for (std::size_t i = 0; i < task.tolerances.size(); ++i) {
    if (!task.tolerances[i].moves_flanks()) {
      found.by_tolerance.push_back({{}, found.percentile});
      continue;
    }
    const double halved = loosener.percentile(i, 0.5).value();
    const auto factor = loosener.factor(
        i, std::max((1.0 + kLooser) * found.percentile, found.percentile + kSameError.rad()));
    found.by_tolerance.push_back({factor, halved});
    if (!(halved < least)) continue;
    least = halved;
    found.tighten_first = i;
  }
  return found;
}

}  // namespace gearwright
