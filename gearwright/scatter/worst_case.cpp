#include "gearwright/scatter/worst_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/base/parallel.hpp"
#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/play_bound.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMostCorners = 1024;  // if a box has more, kChosenCorners are used
constexpr std::size_t kChosenCorners = 256;
constexpr std::size_t kStartCorners = 8;   // number of the worst corners at which a search starts
constexpr std::size_t kStartSamples = 16;  // number of the worst samples at which a search starts
constexpr int kDirections = 8;       // positions of a bore on its circle that count as corners
constexpr double kFirstStep = 0.25;  // relative to the range of a coordinate
constexpr double kLastStep = 1e-4;   // relative to the range of a coordinate
constexpr int kStepLengths = 12;     // each length is half of the previous one
// All searches use the steps down to kCoarseStep. Only the kFineSearches worst results are then
// improved with smaller steps.
constexpr double kCoarseStep = 1.0 / 32;
constexpr std::size_t kFineSearches = 8;
static_assert(kFirstStep / (1 << (kStepLengths - 1)) >= kLastStep &&
              kFirstStep / (1 << kStepLengths) < kLastStep);
constexpr double kAtEnd = 1e-9;  // relative to a range; a nearer point counts as at the end

class Box {
 public:
  Box(const ContactSetup& setup, const ScatterTask& task, ScatterQuantity quantity)
      : setup_(setup), task_(task), quantity_(quantity) {
    for (const ScatterTolerance& t : task.tolerances) {
      // Tolerances without effect on the quantity stay as near to the nominal value as possible.
      // The thickness affects the play only, and pitches affect the long period only.
      const bool affects = quantity == ScatterQuantity::peak_to_peak
                               ? t.moves_flanks()
                               : !std::holds_alternative<VaryingPitch>(t.of);
      for (int k = 0; k < t.coordinates(); ++k) {
        const auto [lo, hi] = t.side(k);
        const double fixed = std::clamp(0.0, lo, hi);
        sides_.push_back(affects ? std::array{lo, hi} : std::array{fixed, fixed});
      }
      choices_.push_back(!affects || !t.distribution.varies() ? 1 : t.bore() ? kDirections : 2);
    }
  }

  std::size_t dimensions() const { return sides_.size(); }
  double width(std::size_t i) const { return sides_[i][1] - sides_[i][0]; }

  // Returns the quantity to maximise. It is the peak-to-peak value of the member at x, or the
  // negative of its least play. The result is minus infinity if the member has no such value.
  double badness(const std::vector<double>& x) const {
    const Deviation d = deviation_at(setup_, task_.tolerances, x);
    const auto found = quantity_ == ScatterQuantity::peak_to_peak
                           ? continuous_peak_to_peak(setup_, d, task_.member).value
                           : member_at(setup_, d, task_.member)[quantity_];
    count_step(task_.progress);
    return found ? value(*found) : -std::numeric_limits<double>::infinity();
  }
  // Converts the maximised number to the quantity, or the quantity to the maximised number.
  double value(double badness) const {
    return quantity_ == ScatterQuantity::peak_to_peak ? badness : -badness;
  }

  // Returns the nearest point inside the box and inside the circles of the bores.
  std::vector<double> inside(std::vector<double> x) const {
    std::size_t at = 0;
    for (const ScatterTolerance& t : task_.tolerances) {
      if (t.bore()) {
        const double away = std::hypot(x[at], x[at + 1]);
        const double radius = t.distribution.greatest();
        if (away > radius) {
          x[at] *= radius / away;
          x[at + 1] *= radius / away;
        }
      } else {
        for (std::size_t i = at; i < at + static_cast<std::size_t>(t.coordinates()); ++i)
          x[i] = std::clamp(x[i], sides_[i][0], sides_[i][1]);
      }
      at += static_cast<std::size_t>(t.coordinates());
    }
    return x;
  }

  // True if the points differ only in wave counts that are rounded to the same number.
  bool same_member(const std::vector<double>& x, const std::vector<double>& y) const {
    std::size_t at = 0;
    for (const ScatterTolerance& t : task_.tolerances) {
      const bool wave = std::holds_alternative<VaryingWave>(t.of);
      for (int k = 0; k < t.coordinates(); ++k, ++at) {
        if (x[at] == y[at]) continue;
        if (!wave || k > 0 || std::lround(x[at]) != std::lround(y[at])) return false;
      }
    }
    return true;
  }

  bool is_corner(const std::vector<double>& x) const {
    std::size_t at = 0;
    for (const ScatterTolerance& t : task_.tolerances) {
      const double slack = kAtEnd * width(at);
      const bool end = t.bore() ? std::hypot(x[at], x[at + 1]) >= t.distribution.greatest() - slack
                                : x[at] <= sides_[at][0] + slack || x[at] >= sides_[at][1] - slack;
      if (!end) return false;
      at += static_cast<std::size_t>(t.coordinates());
    }
    return true;
  }

  // Returns the point x with rounded wave counts. It describes the same member as x, because
  // deviation_at() also rounds wave counts.
  std::vector<double> with_whole_waves(std::vector<double> x) const {
    std::size_t at = 0;
    for (const ScatterTolerance& t : task_.tolerances) {
      if (std::holds_alternative<VaryingWave>(t.of)) x[at] = std::round(x[at]);
      at += static_cast<std::size_t>(t.coordinates());
    }
    return x;
  }

  // Returns all corners, or none if there are more than kMostCorners. The corners of a bore lie on
  // a circle whose radius is `reach` times the radius of the bore.
  std::vector<std::vector<double>> all_corners(double reach = 1.0) const {
    std::size_t count = 1;
    for (const int c : choices_)
      count = std::min(kMostCorners + 1, count * static_cast<std::size_t>(c));
    std::vector<std::vector<double>> all;
    if (count > kMostCorners) return all;
    for (std::size_t n = 0; n < count; ++n) {
      std::size_t rest = n;
      const auto choice = [&](std::size_t t) {
        const auto choices = static_cast<std::size_t>(choices_[t]);
        const std::size_t which = rest % choices;
        rest /= choices;
        return static_cast<int>(which);
      };
      all.push_back(corner(choice, reach));
    }
    return all;
  }

  std::vector<std::vector<double>> corners() const {
    std::vector<std::vector<double>> all = all_corners();
    if (!all.empty()) return all;
    const SobolPoints points(static_cast<int>(choices_.size()));
    for (std::uint32_t n = 0; n < kChosenCorners; ++n) {
      all.push_back(corner([&](std::size_t t) {
        return static_cast<int>(choices_[t] * unit_interval(points.bits(n, static_cast<int>(t))));
      }));
    }
    return all;
  }

 private:
  template <class Choice>
  std::vector<double> corner(const Choice& choice, double reach = 1.0) const {
    std::vector<double> x;
    for (std::size_t t = 0; t < task_.tolerances.size(); ++t) {
      const ScatterTolerance& tolerance = task_.tolerances[t];
      const int which = choice(t);
      if (tolerance.bore()) {
        const double angle = 2 * std::numbers::pi * which / kDirections;
        const double radius = reach * tolerance.distribution.greatest();
        x.push_back(radius * std::cos(angle));
        x.push_back(radius * std::sin(angle));
      } else {
        for (int k = 0; k < tolerance.coordinates(); ++k)
          x.push_back(sides_[x.size()][which == 0 ? 0 : 1]);
      }
    }
    return x;
  }

  const ContactSetup& setup_;
  const ScatterTask& task_;
  ScatterQuantity quantity_;
  std::vector<std::array<double, 2>> sides_;  // range of each coordinate
  std::vector<int> choices_;                  // number of values of each tolerance at corners
};

struct Place {
  std::vector<double> x;
  double badness = -std::numeric_limits<double>::infinity();
};

// Improves a point by the method of Hooke and Jeeves, with steps along each coordinate and then
// along the sum of these steps. The first steps have the length `first`, and the last steps have at
// least the length `last`.
Place climb(const Box& box, Place place, double first, double last) {
  for (double step = first; step >= last;) {
    Place best = place;
    for (std::size_t i = 0; i < box.dimensions(); ++i) {
      if (!(box.width(i) > 0.0)) continue;
      for (const double way : {1.0, -1.0}) {
        Place next{best.x};
        next.x[i] += way * step * box.width(i);
        next.x = box.inside(std::move(next.x));
        if (box.same_member(next.x, best.x)) continue;
        next.badness = box.badness(next.x);
        if (!(next.badness > best.badness)) continue;
        best = std::move(next);
        break;
      }
    }
    if (!(best.badness > place.badness)) {
      step *= 0.5;
      continue;
    }
    Place farther{best.x};
    for (std::size_t i = 0; i < farther.x.size(); ++i) farther.x[i] += best.x[i] - place.x[i];
    farther.x = box.inside(std::move(farther.x));
    farther.badness = box.badness(farther.x);
    place = farther.badness > best.badness ? std::move(farther) : std::move(best);
  }
  return place;
}

// Keeps the `count` worst points, without duplicates.
void keep_worst(std::vector<Place>& places, std::size_t count) {
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.badness > b.badness; });
  const auto same = [](const Place& a, const Place& b) { return a.x == b.x; };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  if (places.size() > count) places.resize(count);
}

}  // namespace

std::optional<WorstMember> worst_member(const ContactSetup& setup, const ScatterTask& task,
                                        const std::vector<ScatterSample>& samples,
                                        ScatterQuantity quantity) {
  const Box box(setup, task, quantity);
  std::vector<Place> starts;
  for (auto& corner : box.corners()) starts.push_back({std::move(corner)});
  begin_stage(task.progress, "searching for the worst case at corners of the ranges",
              static_cast<std::int64_t>(starts.size()));
  parallel_for(
      starts.size(), [&](std::size_t i) { starts[i].badness = box.badness(starts[i].x); },
      task.threads);
  keep_worst(starts, kStartCorners);
  std::vector<Place> worst_samples;
  for (const ScatterSample& s : samples) {
    if (const auto value = s.member[quantity])
      worst_samples.push_back({box.inside(s.x), box.value(*value)});
  }
  keep_worst(worst_samples, kStartSamples);
  starts.insert(starts.end(), worst_samples.begin(), worst_samples.end());
  // A search that starts at the worst place evaluates at most two values of each coordinate for
  // each length of step. Other searches evaluate more, but most of them end after a few lengths, so
  // this number of steps is an estimate.
  begin_stage(task.progress, "searching for the worst case",
              static_cast<std::int64_t>(starts.size() * box.dimensions()) * kStepLengths);
  const auto climb_all = [&](double first, double last) {
    parallel_for(
        starts.size(),
        [&](std::size_t i) { starts[i] = climb(box, std::move(starts[i]), first, last); },
        task.threads);
  };
  climb_all(kFirstStep, kCoarseStep);
  keep_worst(starts, kFineSearches);
  climb_all(kCoarseStep / 2, kLastStep);
  keep_worst(starts, 1);
  if (starts.empty() || !std::isfinite(starts[0].badness)) return std::nullopt;
  const std::vector<double> x = box.with_whole_waves(std::move(starts[0].x));
  WorstMember worst{box.value(starts[0].badness), x, box.is_corner(x), {}};
  // The circle in which a bore can lie is replaced by a polygon. The corners of the polygon lie
  // outside the circle, because the bound is valid only if the polygon contains the circle.
  if (quantity == ScatterQuantity::least_play)
    worst.bound = least_play_bound(setup, task,
                                   box.all_corners(1 / std::cos(std::numbers::pi / kDirections)));
  return worst;
}

std::optional<std::vector<double>> worse_inside(const ContactSetup& setup,
                                                std::vector<ScatterTolerance> tolerances,
                                                bool gear2_drives, Angle known,
                                                Progress* progress) {
  constexpr double kWorse = 1.02;
  constexpr Angle kLeastWorse = Angle::arcseconds(0.01);
  constexpr int kSamples = 64;  // the search starts at the worst samples and at the worst corners
  ScatterTask task;
  task.tolerances = std::move(tolerances);
  task.member.gear2_drives = gear2_drives;
  task.samples = kSamples;
  task.replicates = 1;
  task.worst_case = true;
  task.progress = progress;
  const auto scatter = scatter_of(setup, task);
  if (!scatter || !scatter->worst_peak_to_peak) return std::nullopt;
  const WorstMember& worst = *scatter->worst_peak_to_peak;
  const double limit = std::max(kWorse * known.rad(), (known + kLeastWorse).rad());
  return worst.corner || !(worst.value > limit) ? std::nullopt : std::optional(worst.x);
}

}  // namespace gearwright
