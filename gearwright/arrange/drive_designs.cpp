#include "gearwright/arrange/drive_designs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>

#include "gearwright/base/parallel.hpp"

namespace gearwright {

namespace {

// kEstimateTrains is the number of trains of each module that are rated for the estimate. A module
// with fewer trains than kLeastForEstimate has no estimate, because the estimate would not save
// time.
constexpr std::size_t kEstimateTrains = 64, kLeastForEstimate = 1000;
// Margin of the estimated mass of a train, relative to this mass. In three searches with 1321
// trains, no train was lighter than estimated by more than 0.054 of the estimated mass.
constexpr double kMassMargin = 0.08;

// The candidates of a search, which are computed in several steps. Estimates and the number of
// computed candidates are kept separately for each module. The candidates of a module are therefore
// treated in the same way in a search over a list of modules and in a search with this module
// alone.
class Candidates {
 public:
  Candidates(const DriveDesignTask& task, const std::vector<DriveCandidate>& all, int threads)
      : designer_(task),
        task_(task),
        problem_(task.problem),
        all_(&all),
        made_(all.size()),
        threads_(threads) {}

  // Leaves out the trains that, according to an estimate, cannot have the required safeties,
  // and returns their number. The estimate for a module is made from trains of this module that
  // are evenly distributed over the order of the candidates.
  std::size_t leave_out_hopeless() {
    if (problem_.kind != DriveKind::train || !task_.rate) return 0;
    // The estimate assumes usual profile shifts. A given centre distance may require others.
    if (problem_.center_distance) return 0;
    // If the trains are sorted by mass, the estimate also gives the mass of each train before the
    // train is computed.
    if (problem_.module_per_stage && sorts_by_mass() && all_->size() > kRankedDrives)
      return choose_first_modules();
    std::map<double, std::vector<std::size_t>> of_module;
    for (std::size_t i = 0; i < all_->size(); ++i) of_module[(*all_)[i].module].push_back(i);
    std::size_t hopeless = 0;
    for (const auto& [module, which] : of_module) {
      if (which.size() < kLeastForEstimate) continue;
      if (problem_.module_per_stage) {
        hopeless += choose_first_modules();
        break;
      }
      const TrainStrength strength = strength_of(which, module);
      for (const std::size_t i : which) {
        if (!strength.is_hopeless(widest(problem_, (*all_)[i]), task_.required)) continue;
        made_[i] = State::left_out;
        ++hopeless;
      }
    }
    return hopeless;
  }

  // Computes the candidates with these indices. Returns an error only if it concerns the spec and
  // is therefore the same for all candidates.
  std::optional<Error> compute(const std::vector<std::size_t>& which, DriveDesigns& designs) {
    std::vector<std::optional<DriveOutcome>> outcomes(which.size());
    begin_stage(task_.progress, "computing the next drives",
                static_cast<std::int64_t>(which.size()));
    parallel_for(
        which.size(),
        [&](std::size_t i) {
          outcomes[i] = designer_((*all_)[which[i]]);
          count_step(task_.progress);
        },
        threads_);
    for (std::size_t i = 0; i < which.size(); ++i) {
      ++designs.computed;
      // Before the first drive has been rated, an error is attributed to the spec. Later, an error
      // concerns only the candidate, which is then left out.
      if (auto* error = std::get_if<Error>(&*outcomes[i])) {
        if (!is_rated_) return *error;
        outcomes[i] = DriveFault::safety;
      }
      if (const auto* fault = std::get_if<DriveFault>(&*outcomes[i])) {
        is_rated_ = is_rated_ || *fault == DriveFault::safety || *fault == DriveFault::verdict;
        ++designs.left_out[static_cast<std::size_t>(*fault)];
        made_[which[i]] = State::left_out;
      } else {
        is_rated_ = true;
        made_[which[i]] = State::listed;
        ++designs.green;
        designs.list.push_back(std::get<FoundDrive>(std::move(*outcomes[i])));
      }
    }
    return std::nullopt;
  }

  // Returns the next candidates that have not been computed, in the order of the first objective.
  // Leaves out the trains in which the sliding of a stage exceeds the limit.
  std::vector<std::size_t> next(std::size_t count, DriveDesigns& designs) {
    std::vector<std::size_t> which;
    for (; first_ < all_->size() && which.size() < count; ++first_) {
      if (made_[first_] != State::open) continue;
      if (slides_too_much((*all_)[first_])) {
        made_[first_] = State::left_out;
        ++designs.left_out[static_cast<std::size_t>(DriveFault::sliding)];
      } else if (take(first_)) {
        which.push_back(first_);
      }
    }
    return which;
  }

  // True if the next candidate that has not been computed may be better by the first objective than
  // a design of this group. False if all stages of a train have the same module. For the objective
  // size, a candidate may be better if it is smaller than the last design of the group. For the
  // objective mass, it may be better if its estimated mass, less a margin, is below the mass of the
  // first design. Masses are compared with the first design only, because estimated masses are
  // inexact and nearly all candidates might be lighter than the last design.
  bool may_improve(std::span<const FoundDrive> group) {
    while (first_ < all_->size() && made_[first_] != State::open) ++first_;
    if (!problem_.module_per_stage || first_ == all_->size()) return false;
    const DriveCandidate& next = (*all_)[first_];
    if (sorts_by_mass())
      return !chosen_.empty() && *next.mass * (1.0 - kMassMargin) < *group.front().candidate.mass;
    return problem_.objectives.front() == DriveObjective::size &&
           next.size < group.back().candidate.size;
  }

  // Returns the candidates on the Pareto front that have not been computed. The front is determined
  // without the candidates that were left out.
  std::vector<std::size_t> next_of_front(std::size_t count) {
    std::vector<std::size_t> places, which;
    std::vector<DriveCandidate> left;
    for (std::size_t i = 0; i < all_->size(); ++i) {
      if (made_[i] == State::left_out) continue;
      left.push_back((*all_)[i]);
      places.push_back(i);
    }
    for (const std::size_t i : pareto_front(problem_, left))
      if (made_[places[i]] == State::open && which.size() < count && take(places[i]))
        which.push_back(places[i]);
    return which;
  }

  std::size_t open() const {
    return static_cast<std::size_t>(std::count(made_.begin(), made_.end(), State::open));
  }

 private:
  enum class State { open, listed, left_out };

  bool sorts_by_mass() const { return problem_.objectives.front() == DriveObjective::mass; }

  // Estimates the strength of trains with this module in all stages, from a few candidates that are
  // rated. Without earlier estimates, the candidates are rated with their greatest face widths. If
  // `earlier` contains an estimate for each module, they are rated with the least face widths that
  // are sufficient according to these estimates.
  TrainStrength strength_of(const std::vector<std::size_t>& which, double module,
                            const std::vector<TrainStrength>& earlier = {}) {
    std::vector<std::optional<RatedTrain>> trains(kEstimateTrains);
    begin_stage(task_.progress, "rating trains for an estimate of their strength", kEstimateTrains);
    parallel_for(
        trains.size(),
        [&](std::size_t i) {
          DriveCandidate train = (*all_)[which[(2 * i + 1) * which.size() / (2 * trains.size())]];
          train.module = module;
          train.stage_modules.clear();
          if (!earlier.empty()) set_least_widths(earlier, train);
          trains[i] = designer_.rated(std::move(train));
          count_step(task_.progress);
        },
        threads_);
    std::vector<RatedTrain> rated;
    for (auto& train : trains)
      if (train) rated.push_back(std::move(*train));
    is_rated_ = is_rated_ || !rated.empty();
    return TrainStrength(rated);
  }

  // Gives each stage the least module with which, according to the estimate, the stage may have the
  // required safeties. A train is left out if a stage has no such module or if the train is too
  // large. The other trains are sorted by the first objective. Their sizes are estimated without
  // margins, and their masses with the least face widths. Returns the number of trains that are
  // left out.
  std::size_t choose_first_modules() {
    std::vector<std::size_t> which(all_->size());
    std::iota(which.begin(), which.end(), std::size_t{0});
    std::vector<TrainStrength> strengths;
    for (const double m : problem_.modules) strengths.push_back(strength_of(which, m));
    // The least face widths are estimated with a second fit. Its trains are rated with the least
    // widths of the first fit, because a fit that covers a wide range of loads is less accurate.
    std::vector<TrainStrength> narrow;
    if (problem_.face_width && sorts_by_mass())
      for (const double m : problem_.modules) narrow.push_back(strength_of(which, m, strengths));
    const Safeties& least = task_.required;
    const Safeties probable{least.flank * std::exp(kFlankMargin),
                            least.root * std::exp(kRootMargin)};
    const auto modules_of = [&](const DriveCandidate& train, const Safeties& required) {
      std::vector<double> modules;
      DriveCandidate whole;  // with one module in all stages
      whole.stages = train.stages;
      for (std::size_t k = 0; k < train.stages.size(); ++k)
        for (std::size_t j = 0; j < strengths.size() && modules.size() == k; ++j) {
          whole.module = problem_.modules[j];
          if (strengths[j].may_hold(widest(problem_, whole), k, required))
            modules.push_back(whole.module);
        }
      return modules;
    };
    std::vector<DriveCandidate> kept;
    for (const DriveCandidate& train : *all_) {
      const std::vector<double> modules = modules_of(train, least);
      if (modules.size() < train.stages.size()) continue;
      DriveCandidate chosen = with_modules(problem_, train, modules);
      if (chosen.size > problem_.size_max) continue;
      std::vector<double> other = modules_of(train, probable);
      other.resize(modules.size(), problem_.modules.back());
      DriveCandidate probable_train = with_modules(problem_, train, other);
      if (!narrow.empty()) set_least_widths(narrow, probable_train);
      const DriveCandidate estimated = with_modules(problem_, probable_train, other);
      chosen.size = estimated.size;
      chosen.mass = estimated.mass;
      kept.push_back(std::move(chosen));
    }
    const std::size_t hopeless = all_->size() - kept.size();
    sort_by_objective<DriveCandidate>(
        problem_, kept, [](const auto& c) -> const auto& { return c; });
    chosen_ = std::move(kept);
    all_ = &chosen_;
    made_.assign(chosen_.size(), State::open);
    return hopeless;
  }

  // Gives each stage of a train the least face width with which it probably has the required
  // safeties. The width is a whole number of steps and within the limits of the search.
  void set_least_widths(const std::vector<TrainStrength>& strengths, DriveCandidate& train) const {
    std::vector<double> widths = widest(problem_, train).face_widths;
    for (std::size_t k = 0; k < widths.size(); ++k) {
      const auto module =
          std::find(problem_.modules.begin(), problem_.modules.end(), train.stage_module(k));
      const TrainStrength& strength =
          strengths[static_cast<std::size_t>(module - problem_.modules.begin())];
      if (!strength.estimates(train.stages.size())) continue;
      const double least =
          std::max((*problem_.face_width)[0], strength.least_width(train, k, task_.required));
      widths[k] = std::min(widths[k], std::ceil(least / task_.face_step) * task_.face_step);
    }
    train.face_widths = std::move(widths);
  }

  // True if the sliding of one stage of a train exceeds the limit. The sliding of a stage
  // depends neither on the other stages nor on the load, so it is computed once for each stage.
  bool slides_too_much(const DriveCandidate& train) {
    if (problem_.kind != DriveKind::train || problem_.sliding == kInfinity) return false;
    for (std::size_t k = 0; k < train.stages.size(); ++k) {
      const double module = train.stage_module(k);
      const auto [place, is_new] =
          sliding_.try_emplace({module, train.stages[k][0], train.stages[k][1]}, 0.0);
      if (is_new) {
        // A stage may get a greater module later. The shifts that avoid undercut depend slightly
        // on the module, because the thickness allowances are not proportional to it. The sliding
        // is therefore computed for the present and for the greatest module. The train is left out
        // only if both values exceed the limit.
        DriveCandidate alone = train;
        alone.stages = {train.stages[k]};
        alone.stage_modules.clear();
        alone.module = module;
        place->second = designer_.least_sliding(alone);
        alone.module = problem_.module_per_stage ? problem_.modules.back() : module;
        if (alone.module != module)
          place->second = std::min(place->second, designer_.least_sliding(alone));
      }
      if (place->second > problem_.sliding) return true;
    }
    return false;
  }

  // Counts the candidate as computed and returns true. If kMostComputedDrives candidates of the
  // same module are already counted, only returns false.
  bool take(std::size_t i) {
    std::size_t& computed = computed_[(*all_)[i].module];
    if (computed == kMostComputedDrives) return false;
    ++computed;
    return true;
  }

  DriveDesigner designer_;
  const DriveDesignTask& task_;
  const DriveSearchProblem& problem_;
  std::vector<DriveCandidate> chosen_;  // the candidates, if their first modules were chosen
  const std::vector<DriveCandidate>* all_;
  std::vector<State> made_;
  std::map<std::tuple<double, int, int>, double> sliding_;  // |ζ| by m_n, z_1 and z_2 of a stage
  std::map<double, std::size_t> computed_;  // number of computed candidates, by module
  std::size_t first_ = 0;
  bool is_rated_ = false;
  int threads_;
};

void sort_designs(const DriveSearchProblem& problem, std::span<FoundDrive> list) {
  sort_by_objective(
      problem, list, [](const FoundDrive& f) -> const auto& { return f.candidate; });
}

// True if the values of the first objective, and the sizes of candidates with equal values, are
// exact before the teeth are computed.
bool has_exact_order(const DriveSearchProblem& problem) {
  const DriveObjective first = problem.objectives.front();
  return !problem.module_per_stage &&
         (first == DriveObjective::ratio || first == DriveObjective::planets ||
          first == DriveObjective::size);
}

std::vector<std::size_t> front_of(const DriveSearchProblem& problem,
                                  const std::vector<FoundDrive>& list) {
  std::vector<DriveCandidate> exact;
  for (const FoundDrive& f : list) exact.push_back(f.candidate);
  return pareto_front(problem, exact);
}

// Keeps the `top` best designs of a sorted list and up to `top` more from its Pareto front.
void keep_best(const DriveSearchProblem& problem, std::size_t top, std::vector<FoundDrive>& list) {
  std::size_t kept = top;
  for (const std::size_t i : front_of(problem, list))
    if (i >= top && kept < 2 * top) std::swap(list[kept++], list[i]);
  list.resize(kept);
}

}  // namespace

Result<DriveDesigns> drive_designs(const DriveDesignTask& task, const DriveSearchResult& result,
                                   std::size_t top, int threads) {
  const DriveSearchProblem& problem = task.problem;
  DriveDesigns designs;
  Candidates candidates(task, result.found, threads);
  designs.hopeless = candidates.leave_out_hopeless();
  const std::size_t group = has_exact_order(problem) ? top : kRankedDrives;
  bool is_open = true;
  for (std::size_t begin = 0; begin < top && is_open; begin += group) {
    constexpr std::size_t kBatch = 64;
    const std::size_t end = begin + group;
    while (is_open && (designs.list.size() < end ||
                       candidates.may_improve(std::span(designs.list).subspan(begin, group)))) {
      const std::size_t own = designs.list.size();
      const auto which = candidates.next(own < end ? end - own : kBatch, designs);
      is_open = !which.empty();
      if (auto error = candidates.compute(which, designs)) return *error;
      sort_designs(problem, std::span(designs.list).subspan(begin));
    }
  }
  const bool is_short = designs.list.size() < top;
  std::size_t more = top;  // greatest number of further designs from the Pareto front
  if (!is_short) {
    keep_best(problem, top, designs.list);
    more -= designs.list.size() - top;
  }
  while (more > 0) {
    const auto which = candidates.next_of_front(more);
    if (which.empty()) break;
    const std::size_t before = designs.list.size();
    if (auto error = candidates.compute(which, designs)) return *error;
    more -= designs.list.size() - before;
  }
  if (is_short) designs.beyond_limit = candidates.open();
  if (!is_short) sort_designs(problem, std::span(designs.list).subspan(top));
  designs.pareto = front_of(problem, designs.list);
  return designs;
}

}  // namespace gearwright
