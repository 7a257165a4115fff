#include "gearwright/design/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "gearwright/design/candidate.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

SearchCounts& SearchCounts::operator+=(const SearchCounts& other) {
  tested += other.tested;
  feasible += other.feasible;
  for (std::size_t i = 0; i < rejected.size(); ++i) rejected[i] += other.rejected[i];
  points_tested += other.points_tested;
  points_feasible += other.points_feasible;
  return *this;
}

// A shift or a distance that is not limited, modules: beyond any, and its square is no infinity.
constexpr double kNoLimit = 1e9;

Search::Search(SearchProblem problem) : problem_(std::move(problem)), space_(problem_) {}

std::shared_ptr<const TrialGears> Search::gears(int which, int rack, Angle helix) const {
  const std::lock_guard lock(mutex_);
  const auto key = std::make_tuple(which, rack, helix);
  if (const auto found = tables_.find(key); found != tables_.end()) return found->second;
  // Trials run through one rack and helix before the next: a few tables are enough.
  constexpr std::size_t kTables = 16;
  if (tables_.size() >= kTables) tables_.clear();
  const bool ring = problem_.internal();
  const int least = which == 0 ? problem_.pinion_teeth[0]
                    : ring     ? -space_.max_wheel()
                               : space_.min_wheel();
  const int most = which == 0 ? problem_.pinion_teeth[1]
                   : ring     ? -space_.min_wheel()
                              : space_.max_wheel();
  auto table = std::make_shared<const TrialGears>(problem_, least, most, helix, rack, which);
  tables_.emplace(key, table);
  return table;
}

ShiftGraph Search::graph(const Trial& trial) const {
  return ShiftGraph(problem_, trial, trial_gear(problem_, trial.z1, trial.helix[0], trial.rack, 0),
                    trial_gear(problem_, trial.z2, trial.helix[1], trial.rack, 1));
}

namespace {

constexpr std::size_t kBatch = 1024;

// The trials of one rack and helix on their way through the sieve.
class Sieve {
 public:
  Sieve(const SearchProblem& problem, const Trial& first, const TrialGear& pinion)
      : helix_(first.helix[0]), rack_(first.rack) {
    const double alpha_t = std::asin(pinion.sin_transverse);
    const double cos_beta = std::abs(pinion.teeth / (2.0 * pinion.r));
    const SearchRacks& racks = problem.racks[static_cast<std::size_t>(rack_)];
    constants_.cos_transverse = std::cos(alpha_t);
    constants_.involute_transverse = involute(alpha_t);
    constants_.sum_per_involute = cos_beta / std::tan(problem.normal_pressure_angle.rad());
    constants_.min_path =
        problem.limits.contact_ratio * std::numbers::pi * std::cos(alpha_t) / cos_beta;
    constants_.addendum = {racks.rack[0].addendum, racks.rack[1].addendum};
    constants_.internal = problem.internal();
    shortened_ = problem.shorten_tips;
    ceiling_ = problem.limits.max_shift.value_or(kNoLimit);
    constants_.tight = problem.mounting == Mounting::tight && !problem.crossed();
    constants_.path = !constants_.tight && !constants_.internal && !problem.crossed();
    trials_.reserve(kBatch);
    batch_.resize(kBatch);
  }

  bool takes(const Trial& t) const {
    return t.rack == rack_ && t.helix[0] == helix_ && trials_.size() < kBatch;
  }
  void add(const Trial& t, const std::optional<std::array<double, 2>>& distance,
           const TrialGear& g_1, const TrialGear& g_2) {
    const std::size_t i = trials_.size();
    trials_.push_back(t);
    double a_lo = 0.0;
    double a_hi = kNoLimit;
    if (distance) {
      a_lo = (*distance)[0] / t.module;
      a_hi = (*distance)[1] / t.module;
    }
    // Shortened tips are thicker: how far they may be shifted the graph knows.
    const double hi_1 = shortened_ ? ceiling_ : g_1.x_max;
    const double hi_2 = shortened_ ? ceiling_ : g_2.x_max;
    const double values[] = {g_1.r, g_1.x_min, hi_1, g_2.r, g_2.x_min, hi_2, a_lo, a_hi};
    for (std::size_t k = 0; k < SieveBatch::kIn; ++k) batch_.in[k][i] = values[k];
  }
  /// decide(trial, verdict) says whether to go on.
  template <class F>
  bool flush(const F& decide) {
    if (trials_.empty()) return true;
    batch_.resize(trials_.size());
    sieve(constants_, batch_);
    bool on = true;
    for (std::size_t i = 0; i < trials_.size() && on; ++i)
      on = decide(trials_[i], batch_.verdict[i]);
    trials_.clear();
    batch_.resize(kBatch);
    return on;
  }

 private:
  Angle helix_;
  int rack_;
  bool shortened_ = false;
  double ceiling_ = 0.0;
  SieveConstants constants_;
  SieveBatch batch_;
  std::vector<Trial> trials_;
};

}  // namespace

template <class F>
void Search::sift(std::int64_t from, std::int64_t to, const F& decide) const {
  std::shared_ptr<const TrialGears> pinions;
  std::shared_ptr<const TrialGears> wheels;
  std::optional<Sieve> sieve;
  bool on = true;
  const auto flush = [&] {
    if (sieve && on) {
      on = sieve->flush([&](const Trial& t, double verdict) {
        return decide(t, verdict, (*pinions)[t.z1], (*wheels)[t.z2]);
      });
    }
  };
  space_.each(from, to, [&](const Trial& t) {
    if (!sieve || !sieve->takes(t)) {
      flush();
      if (!on) return false;
      pinions = gears(0, t.rack, t.helix[0]);
      wheels = gears(1, t.rack, t.helix[1]);
      sieve.emplace(problem_, t, (*pinions)[t.z1]);
    }
    sieve->add(t, problem_.center_distance, (*pinions)[t.z1], (*wheels)[t.z2]);
    return true;
  });
  flush();
}

SearchCounts Search::range(std::int64_t from, std::int64_t to, std::vector<DesignRow>& rows,
                           SieveCounts* counts, std::vector<ShiftPoint>* points) const {
  SearchCounts result;
  sift(from, to, [&](const Trial& t, double verdict, const TrialGear& g_1, const TrialGear& g_2) {
    ++result.tested;
    if (counts) ++(verdict == kSieveAsk ? counts->asked : counts->decided);
    if (verdict <= kSieveContactRatio) {
      ++result.rejected[static_cast<std::size_t>(verdict)];
      return true;
    }
    const ShiftGraph graph(problem_, t, g_1, g_2);
    if (const auto region = shift_region(graph)) {
      ++result.feasible;
      rows.push_back(design_row(graph, *region));
      if (problem_.shift_step && points) {
        const PointCounts n = feasible_points(graph, *region, *problem_.shift_step, *points);
        result.points_tested += n.tested;
        result.points_feasible += n.feasible;
      }
      return true;
    }
    const auto limit = graph.what_kills();
    GW_ENSURES(limit.has_value());
    ++result.rejected[static_cast<std::size_t>(*limit)];
    return true;
  });
  return result;
}

bool Search::exists(std::int64_t from, std::int64_t to) const {
  bool found = false;
  sift(from, to, [&](const Trial& t, double verdict, const TrialGear& g_1, const TrialGear& g_2) {
    found = verdict > kSieveContactRatio && !ShiftGraph(problem_, t, g_1, g_2).what_kills();
    return !found;
  });
  return found;
}

BestDesigns::BestDesigns(const SearchProblem& problem, std::size_t most)
    : problem_(&problem), max_(most), front_(problem) {}

void BestDesigns::add(const DesignRow& row) {
  ++added_;
  if (problem_->objectives.size() > 1) front_.add(row);
  const auto before = [&](const DesignRow& a, const DesignRow& b) {
    return ranks_before(*problem_, problem_->objectives.front(), a, b);
  };
  if (heap_.size() < max_) {
    heap_.push_back(row);
    std::push_heap(heap_.begin(), heap_.end(), before);
  } else if (max_ > 0 && before(row, heap_.front())) {
    std::pop_heap(heap_.begin(), heap_.end(), before);
    heap_.back() = row;
    std::push_heap(heap_.begin(), heap_.end(), before);
  }
}

SearchAnswer BestDesigns::answer(const SearchCounts& counts) && {
  const auto before = [&](const DesignRow& a, const DesignRow& b) {
    return ranks_before(*problem_, problem_->objectives.front(), a, b);
  };
  SearchAnswer answer;
  answer.counts = counts;
  std::sort(heap_.begin(), heap_.end(), before);
  std::vector<DesignRow> front = front_.rows();
  std::sort(front.begin(), front.end(), before);
  for (std::size_t i = 0; i < front.size() && i < max_; ++i) {
    answer.pareto.push_back(i);
    answer.designs.push_back(front[i]);
  }
  const auto on_front = [&](const DesignRow& row) {
    return std::any_of(front.begin(), front.end(),
                       [&](const DesignRow& f) { return f.trial.index == row.trial.index; });
  };
  for (const DesignRow& row : heap_) {
    if (answer.designs.size() >= max_) break;
    if (front.empty() || !on_front(row)) answer.designs.push_back(row);
  }
  answer.cut = static_cast<std::int64_t>(answer.designs.size()) < added_;
  return answer;
}

}  // namespace gearwright
