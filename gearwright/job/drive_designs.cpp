#include "gearwright/job/drive_designs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "gearwright/arrange/judge_drive.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/design/train_strength.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/drive/windup.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

namespace {

bool has_gears(const Drive& drive) {
  return std::none_of(
      drive.geometry.faults.begin(), drive.geometry.faults.end(),
      [](const GeometryFault& f) { return f.kind == GeometryFault::Kind::not_coaxial; });
}

bool is_safe(const Drive& drive, const WantedSafety& wanted) {
  const auto holds = [&](FactorPair Rating::*safety, double least) {
    const auto own = least_safety(drive, safety);
    return !own || *own >= least;
  };
  return holds(&Rating::S_H, wanted.flank) && holds(&Rating::S_F, wanted.root);
}

// A design, the reason why a candidate is left out, or an error of the spec.
using Outcome = std::variant<FoundDrive, DriveFault, Error>;

class Designer {
 public:
  Designer(const JobSpec& spec, const DriveSearchProblem& problem)
      : spec_(spec), problem_(problem), rates_(rates_drives(spec, problem)) {}

  // If the search gives no profile shifts, several are tried, and the best design by the objectives
  // is returned.
  Outcome operator()(DriveCandidate candidate) const {
    const bool same_cost = !problem_.asks(DriveObjective::efficiency) &&
                           !problem_.asks(DriveObjective::efficiency_backward) &&
                           !problem_.asks(DriveObjective::clearance) &&
                           !problem_.asks(DriveObjective::noise);
    std::optional<Outcome> best;
    for (GearShifts& shifts : trials(candidate)) {
      if (best && same_cost && std::holds_alternative<FoundDrive>(*best)) break;
      candidate.shifts = std::move(shifts);
      Outcome other = sized(candidate);
      if (!best || is_better(other, *best)) best = std::move(other);
    }
    return best ? std::move(*best) : DriveFault::no_teeth;
  }

  // A train with its greatest face width and, for each stage, the greatest safeties over all trials
  // of profile shifts. None if the train cannot be rated.
  std::optional<RatedTrain> rated(DriveCandidate candidate) const {
    if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
    RatedTrain best{candidate, std::vector<StageSafety>(candidate.stages.size())};
    bool any = false;
    for (GearShifts& shifts : trials(candidate)) {
      candidate.shifts = std::move(shifts);
      auto made = made_from(candidate);
      if (!made || rate_drive(made->spec, made->drive)) continue;
      const auto& ratings = made->drive.ratings;
      if (!std::all_of(ratings.begin(), ratings.end(), [](const auto& r) { return r.has_value(); }))
        continue;
      any = true;
      for (std::size_t k = 0; k < best.stages.size(); ++k) {
        const Rating& r = ratings[k]->rating;
        best.stages[k].flank =
            std::max(best.stages[k].flank, std::min(r.S_H[0].value, r.S_H[1].value));
        best.stages[k].root =
            std::max(best.stages[k].root, std::min(r.S_F[0].value, r.S_F[1].value));
      }
    }
    return any ? std::optional(std::move(best)) : std::nullopt;
  }

  // The safeties that every design must have.
  StageSafety required() const {
    return {problem_.safety_flank.value_or(spec_.rating.safety_flank_min.value_or(1.0)),
            problem_.safety_root.value_or(spec_.rating.safety_root_min.value_or(1.0))};
  }

  bool rates() const { return rates_; }

 private:
  // The profile shifts to be tried. If the search gives shifts, only these are tried. The list is
  // empty if the teeth of the candidate are impossible. The shifts do not depend on the face width.
  std::vector<GearShifts> trials(DriveCandidate candidate) const {
    if (spec_.tree->tables["search"].contains("profile_shift")) return {candidate.shifts};
    if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
    const auto own = read_spec_tree(drive_spec(spec_, problem_, candidate), {}, SpecUse::geometry);
    return own ? shift_trials(own->drive->graph) : std::vector<GearShifts>();
  }

  // Compares two designs by the objectives in their order.
  bool is_better(const Outcome& a, const Outcome& b) const {
    const auto costs = [&](const Outcome& outcome) {
      const auto* found = std::get_if<FoundDrive>(&outcome);
      std::vector<double> list;
      for (const DriveObjective o : problem_.objectives)
        list.push_back(found ? cost_of(problem_, found->candidate, o) : kInfinity);
      return list;
    };
    return costs(a) < costs(b);
  }

  Outcome sized(DriveCandidate candidate) const {
    if (!problem_.face_width) return with_width(std::move(candidate));
    // The least sufficient width in whole steps is found by bisection, because the safeties grow
    // with the width. A limit that is meant as a whole number of steps may differ from this
    // multiple by rounding.
    constexpr double kRounding = 1e-9;
    const double step = default_face_step(spec_.units());
    // 33 steps of 1.27 mm are 41.91 mm, without the rounding error of the product.
    constexpr double kPlaces = 1e6;
    const auto whole_steps = [&](double steps) {
      return std::round(steps * step * kPlaces) / kPlaces;
    };
    double low = std::ceil((*problem_.face_width)[0] / step - kRounding) - 1.0;
    double high = std::floor(greatest_face_width(problem_, candidate) / step + kRounding);
    if (high <= low) return DriveFault::safety;
    candidate.face_width = whole_steps(high);
    Outcome best = with_width(candidate);
    if (!std::holds_alternative<FoundDrive>(best)) return best;
    while (high - low > 1.0) {
      const double middle = std::floor((low + high) / 2);
      candidate.face_width = whole_steps(middle);
      Outcome narrower = with_width(candidate);
      if (std::holds_alternative<FoundDrive>(narrower)) {
        best = std::move(narrower);
        high = middle;
      } else {
        low = middle;
      }
    }
    return best;
  }

  struct MadeDrive {
    JobSpec spec;
    Drive drive;
  };
  // Makes the drive of the candidate. None if its spec or its drive is impossible.
  std::optional<MadeDrive> made_from(const DriveCandidate& candidate) const {
    auto own = read_spec_tree(drive_spec(spec_, problem_, candidate), {}, SpecUse::geometry);
    if (!own) return std::nullopt;
    auto made = make_drive(*own->drive);
    if (!made) return std::nullopt;
    return MadeDrive{std::move(own).take(), std::move(made).take()};
  }

  Outcome with_width(DriveCandidate candidate) const {
    auto made = made_from(candidate);
    if (!made || !has_gears(made->drive)) return DriveFault::no_teeth;
    auto& [own, drive] = *made;
    if (!drive.sets.empty() && drive.sets.front().neighbours) {
      candidate.clearance = drive.sets.front().neighbours->clearance / candidate.module;
      if (candidate.clearance < problem_.neighbour_clearance) return DriveFault::neighbours;
    }
    if (greatest_sliding(drive.geometry).value_or(0.0) > problem_.sliding)
      return DriveFault::sliding;
    const WantedSafety wanted = wanted_safety(own);
    if (rates_) {
      if (drive.flow && drive.flow->self_locking()) return DriveFault::safety;
      if (auto error = rate_drive(own, drive)) return *error;
      if (!is_safe(drive, wanted)) return DriveFault::safety;
    }
    const bool any_spacing = problem_.base.spacing == Spacing::nearest;
    if (drive_level(drive, wanted, !any_spacing) != Level::green) return DriveFault::verdict;
    if (drive.flow) candidate.efficiency = drive.flow->efficiency;
    if (drive.backward) candidate.efficiency_backward = drive.backward->efficiency;
    if (problem_.asks(DriveObjective::noise) && !problem_.modules.empty())
      candidate.noise = windup_variation(drive);
    return FoundDrive{std::move(candidate), std::move(drive)};
  }

  const JobSpec& spec_;
  const DriveSearchProblem& problem_;
  bool rates_;
};

// kEstimateTrains is the number of trains of each module that are rated for the estimate. A module
// with fewer trains than kLeastForEstimate has no estimate, because the estimate would not save
// time.
constexpr std::size_t kEstimateTrains = 64, kLeastForEstimate = 1000;

// The candidates of a search. They are computed in several steps. Each module has its own estimate
// and its own number of computed candidates. So a search over a list of modules treats the
// candidates of a module like a search with this module alone.
class Candidates {
 public:
  Candidates(const JobSpec& spec, const DriveSearchProblem& problem,
             const std::vector<DriveCandidate>& all, int threads)
      : designer_(spec, problem),
        problem_(problem),
        all_(all),
        made_(all.size()),
        threads_(threads) {}

  // Leaves out the trains that by an estimate cannot have the required safeties, and returns their
  // number. The estimate for a module is made from trains of this module that are evenly
  // distributed over the order of the candidates.
  std::size_t leave_out_hopeless() {
    if (problem_.kind != DriveKind::train || !designer_.rates()) return 0;
    std::map<double, std::vector<std::size_t>> of_module;
    for (std::size_t i = 0; i < all_.size(); ++i) of_module[all_[i].module].push_back(i);
    std::size_t hopeless = 0;
    for (const auto& [module, which] : of_module) {
      if (which.size() < kLeastForEstimate) continue;
      std::vector<std::optional<RatedTrain>> trains(kEstimateTrains);
      parallel_for(
          trains.size(),
          [&, &list = which](std::size_t i) {
            trains[i] =
                designer_.rated(all_[list[(2 * i + 1) * list.size() / (2 * trains.size())]]);
          },
          threads_);
      std::vector<RatedTrain> rated;
      for (auto& train : trains)
        if (train) rated.push_back(std::move(*train));
      is_rated_ = is_rated_ || !rated.empty();
      const TrainStrength strength(rated);
      for (const std::size_t i : which) {
        DriveCandidate widest = all_[i];
        if (problem_.face_width) widest.face_width = greatest_face_width(problem_, widest);
        if (!strength.is_hopeless(widest, designer_.required())) continue;
        made_[i] = State::left_out;
        ++hopeless;
      }
    }
    return hopeless;
  }

  // Computes the candidates with these indices. An error of the spec is the same for all
  // candidates.
  std::optional<Error> compute(const std::vector<std::size_t>& which, DriveDesigns& designs) {
    std::vector<std::optional<Outcome>> outcomes(which.size());
    parallel_for(
        which.size(), [&](std::size_t i) { outcomes[i] = designer_(all_[which[i]]); }, threads_);
    for (std::size_t i = 0; i < which.size(); ++i) {
      ++designs.computed;
      // Until a drive has been rated, an error is attributed to the spec. Afterwards, it concerns
      // only the candidate, which is left out.
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
        designs.list.push_back(std::get<FoundDrive>(std::move(*outcomes[i])));
      }
    }
    return std::nullopt;
  }

  // The next candidates that have not been computed, in the order of the first objective.
  std::vector<std::size_t> next(std::size_t count) {
    std::vector<std::size_t> which;
    for (; first_ < all_.size() && which.size() < count; ++first_)
      if (made_[first_] == State::open && take(first_)) which.push_back(first_);
    return which;
  }

  // The candidates on the Pareto front that have not been computed. The front is determined without
  // the candidates that were left out.
  std::vector<std::size_t> next_of_front(std::size_t count) {
    std::vector<std::size_t> places, which;
    std::vector<DriveCandidate> left;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (made_[i] == State::left_out) continue;
      left.push_back(all_[i]);
      places.push_back(i);
    }
    for (const std::size_t i : pareto_front(problem_, left))
      if (made_[places[i]] == State::open && which.size() < count && take(places[i]))
        which.push_back(places[i]);
    return which;
  }

  // Number of candidates that have neither been computed nor left out.
  std::size_t open() const {
    return static_cast<std::size_t>(std::count(made_.begin(), made_.end(), State::open));
  }

 private:
  enum class State { open, listed, left_out };

  // Counts a candidate that will be computed. False if the limit of its module is reached.
  bool take(std::size_t i) {
    std::size_t& computed = computed_[all_[i].module];
    if (computed == kMostComputedDrives) return false;
    ++computed;
    return true;
  }

  Designer designer_;
  const DriveSearchProblem& problem_;
  const std::vector<DriveCandidate>& all_;
  std::vector<State> made_;
  std::map<double, std::size_t> computed_;  // number of computed candidates, by module
  std::size_t first_ = 0;
  bool is_rated_ = false;
  int threads_;
};

}  // namespace

Result<DriveDesigns> drive_designs(const JobSpec& spec, const DriveSearchProblem& problem,
                                   const DriveSearchResult& result, std::size_t top, int threads) {
  if (rates_drives(spec, problem) && problem.modules.empty())
    return absent_input(
        "search.normal_module_mm",
        "; drives can be rated only with a module, for example normal_module_mm = [1, 1.5, 2]");
  DriveDesigns designs;
  Candidates candidates(spec, problem, result.found, threads);
  designs.hopeless = candidates.leave_out_hopeless();
  while (designs.list.size() < top) {
    const auto which = candidates.next(top - designs.list.size());
    if (which.empty()) break;
    if (auto error = candidates.compute(which, designs)) return *error;
  }
  const bool is_short = designs.list.size() < top;
  for (std::size_t more = top; more > 0;) {
    const auto which = candidates.next_of_front(more);
    if (which.empty()) break;
    const std::size_t before = designs.list.size();
    if (auto error = candidates.compute(which, designs)) return *error;
    more -= designs.list.size() - before;
  }
  if (is_short) designs.beyond_limit = candidates.open();
  const auto cost = [&](const FoundDrive& f) {
    return cost_of(problem, f.candidate, problem.objectives.front());
  };
  std::stable_sort(designs.list.begin(), designs.list.end(),
                   [&](const FoundDrive& a, const FoundDrive& b) { return cost(a) < cost(b); });
  std::vector<DriveCandidate> exact;
  for (const FoundDrive& f : designs.list) exact.push_back(f.candidate);
  designs.pareto = pareto_front(problem, exact);
  return designs;
}

}  // namespace gearwright
