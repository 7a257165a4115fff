#include "gearwright/design/search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "gearwright/design/candidate.hpp"
#include "gearwright/design/design_strength.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

SearchCounts& SearchCounts::operator+=(const SearchCounts& other) {
  tested += other.tested;
  feasible += other.feasible;
  for (std::size_t i = 0; i < rejected.size(); ++i) rejected[i] += other.rejected[i];
  for (std::size_t i = 0; i < findings.size(); ++i) findings[i] += other.findings[i];
  points_tested += other.points_tested;
  points_feasible += other.points_feasible;
  return *this;
}

// Replaces an absent limit of a shift or a centre distance, modules. The value exceeds all shifts
// and distances that occur, and its square is finite.
constexpr double kNoLimit = 1e9;

Search::Search(SearchProblem problem) : problem_(std::move(problem)), space_(problem_) {
  if (problem_.rating && !problem_.rating->ring_cuts)
    problem_.rating->ring_cuts = std::make_shared<RingCuts>();
}

std::shared_ptr<const TrialGears> Search::gears(int which, int rack, Angle helix) const {
  const std::lock_guard lock(mutex_);
  const auto key = std::make_tuple(which, rack, helix);
  if (const auto found = tables_.find(key); found != tables_.end()) return found->second;
  // Trials are processed in the order of rack and helix angle, so it is sufficient to store a few
  // tables of gears.
  constexpr std::size_t kTables = 16;
  if (tables_.size() >= kTables) tables_.clear();
  const auto [least, most] = which == 0 ? problem_.pinion_teeth : space_.wheels();
  auto table = std::make_shared<const TrialGears>(problem_, least, most, helix, rack, which);
  tables_.emplace(key, table);
  return table;
}

ShiftGraph Search::graph(const Trial& trial) const {
  return ShiftGraph(problem_, trial, trial_gear(problem_, trial.z1, trial.helix[0], trial.rack, 0),
                    trial_gear(problem_, trial.z2, trial.helix[1], trial.rack, 1));
}

namespace {

// Evaluates the filter for all trials with the same rack and helix angle at once.
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
    constants_.tight = problem.tight();
    constants_.path = !constants_.tight && problem.kind() == PairKind::parallel_external;
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
    // Shortened tips are thicker, so the greatest shift may exceed x_max. In this case, the filter
    // uses only the limit given in the problem, and the graph computes the greatest shift later.
    const double hi_1 = shortened_ ? ceiling_ : g_1.x_max;
    const double hi_2 = shortened_ ? ceiling_ : g_2.x_max;
    const double values[] = {g_1.r, g_1.x_min, hi_1, g_2.r, g_2.x_min, hi_2, a_lo, a_hi};
    for (std::size_t k = 0; k < SieveBatch::kIn; ++k) batch_.in[k][i] = values[k];
  }
  std::size_t size() const { return trials_.size(); }
  /// `decide(trial, verdict)` returns true if the search shall continue.
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
void Search::sift(std::int64_t from, std::int64_t to, const SearchWatch& watch,
                  const F& decide) const {
  std::shared_ptr<const TrialGears> pinions;
  std::shared_ptr<const TrialGears> wheels;
  std::optional<Sieve> sieve;
  bool on = true;
  const auto flush = [&] {
    if (sieve && on) {
      const auto trials = static_cast<std::int64_t>(sieve->size());
      on = sieve->flush([&](const Trial& t, double verdict) {
        return decide(t, verdict, (*pinions)[t.z1], (*wheels)[t.z2]);
      });
      if (watch && !watch(trials)) on = false;
    }
  };
  space_.each(from, to, [&](const Trial& t) {
    if (!sieve || !sieve->takes(t)) {
      flush();
      if (!on || (watch && !watch(0))) return false;
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
                           const RangeOptions& wish) const {
  const bool grid = problem_.shift_step && wish.points;
  SearchCounts result;
  sift(from, to, wish.watch,
       [&](const Trial& t, double verdict, const TrialGear& g_1, const TrialGear& g_2) {
         ++result.tested;
         if (wish.sieve) ++(verdict == kSieveAsk ? wish.sieve->asked : wish.sieve->decided);
         if (verdict <= kSieveContactRatio) {
           ++result.rejected[static_cast<std::size_t>(verdict)];
           return true;
         }
         // The watch is called before each graph, because one graph may take as long as a thousand
         // verdicts of the filter.
         if (wish.watch && !wish.watch(0)) return false;
         const ShiftGraph graph(problem_, t, g_1, g_2);
         const auto keep = [&](const DesignRow& row) {
           if (const auto limit = short_of(problem_, row)) {
             ++result.rejected[static_cast<std::size_t>(*limit)];
             if (*limit == Limit::verdict && row.finding)
               ++result.findings[static_cast<std::size_t>(*row.finding)];
             return false;
           }
           ++result.feasible;
           rows.push_back(row);
           return true;
         };
         if (grid) {
           const auto region = shift_region(graph);
           if (const auto row = region ? design_row(graph, *region) : std::nullopt) {
             if (!keep(*row)) return true;
             const PointCounts n =
                 feasible_points(graph, *region, *problem_.shift_step, *wish.points);
             result.points_tested += n.tested;
             result.points_feasible += n.feasible;
             return true;
           }
         } else if (const auto row =
                        design_row(graph, problem_.rating || problem_.draw ? RegionDetail::point
                                                                           : wish.detail)) {
           // The values of the region are computed only for accepted designs, because this takes
           // longer than all other values.
           if (keep(*row) && !row->whole && wish.detail == RegionDetail::whole)
             rows.back() = *design_row(graph, wish.detail);
           return true;
         }
         // If no limit removes the whole region, the reason for the rejection is that the tips cut
         // into the fillets at all points that were tried.
         const Limit limit = graph.what_kills().value_or(Limit::interference);
         ++result.rejected[static_cast<std::size_t>(limit)];
         return true;
       });
  return result;
}

DesignRow Search::whole(const DesignRow& row) const {
  if (row.whole) return row;
  auto found = design_row(graph(row.trial));
  GW_ENSURES(found && found->shift == row.shift);
  found->loaded_noise = row.loaded_noise;
  return *found;
}

bool Search::exists(std::int64_t from, std::int64_t to) const {
  bool found = false;
  sift(from, to, {},
       [&](const Trial& t, double verdict, const TrialGear& g_1, const TrialGear& g_2) {
         found = verdict > kSieveContactRatio && has_design(ShiftGraph(problem_, t, g_1, g_2));
         return !found;
       });
  return found;
}

void Search::candidates(const std::function<bool(const Trial&)>& f,
                        const SearchWatch& watch) const {
  sift(0, *space_.size(), watch,
       [&](const Trial& t, double verdict, const TrialGear&, const TrialGear&) {
         return verdict <= kSieveContactRatio || f(t);
       });
}

BestDesigns::BestDesigns(const SearchProblem& problem, std::size_t most)
    : problem_(&problem), max_(most), front_(problem) {}

void BestDesigns::add(const DesignRow& row) {
  ++added_;
  if (problem_->objectives.size() > 1) front_.add(row);
  if (max_ == 0) return;
  const RankKey key = rank_key(*problem_, problem_->objectives.front(), row);
  if (heap_.size() < max_) {
    heap_.push_back({key, rows_.size()});
    rows_.push_back(row);
  } else {
    if (!(key < heap_.front().key)) return;
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.back().key = key;
    rows_[heap_.back().row] = row;
  }
  std::push_heap(heap_.begin(), heap_.end());
}

SearchAnswer BestDesigns::answer(const SearchCounts& counts) && {
  SearchAnswer answer;
  answer.counts = counts;
  std::sort_heap(heap_.begin(), heap_.end());
  std::vector<DesignRow> front = front_.rows();
  std::sort(front.begin(), front.end(), [&](const DesignRow& a, const DesignRow& b) {
    return ranks_before(*problem_, problem_->objectives.front(), a, b);
  });
  std::set<std::int64_t> on_front;
  for (std::size_t i = 0; i < front.size() && i < max_; ++i) {
    answer.pareto.push_back(i);
    on_front.insert(front[i].trial.index);
    answer.designs.push_back(front[i]);
  }
  for (const Place& place : heap_) {
    if (answer.designs.size() >= max_) break;
    const DesignRow& row = rows_[place.row];
    if (!on_front.contains(row.trial.index)) answer.designs.push_back(row);
  }
  answer.cut = static_cast<std::int64_t>(answer.designs.size()) < added_;
  return answer;
}

}  // namespace gearwright
