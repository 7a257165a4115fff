#include "gearwright/job/drive_designs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "gearwright/arrange/judge_drive.hpp"
#include "gearwright/base/parallel.hpp"
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

  // If the search gives no profile shifts, those with the better design by the objectives are chosen.
  Outcome operator()(DriveCandidate candidate) const {
    if (spec_.tree->tables["search"].contains("profile_shift")) return sized(std::move(candidate));
    // The shifts do not depend on the face width.
    if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
    const auto own = read_spec_tree(drive_spec(spec_, problem_, candidate), {}, SpecUse::geometry);
    if (!own) return DriveFault::no_teeth;
    const bool same_cost = !problem_.asks(DriveObjective::efficiency) &&
                           !problem_.asks(DriveObjective::efficiency_backward) &&
                           !problem_.asks(DriveObjective::clearance) &&
                           !problem_.asks(DriveObjective::noise);
    std::optional<Outcome> best;
    for (GearShifts& shifts : shift_trials(own->drive->graph)) {
      if (best && same_cost && std::holds_alternative<FoundDrive>(*best)) break;
      candidate.shifts = std::move(shifts);
      Outcome other = sized(candidate);
      if (!best || is_better(other, *best)) best = std::move(other);
    }
    return std::move(*best);
  }

 private:
  // Compares two designs by the objectives, the first one first.
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
    // with the width. A limit that is a whole number of steps may differ from it by rounding.
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

  Outcome with_width(DriveCandidate candidate) const {
    const auto own = read_spec_tree(drive_spec(spec_, problem_, candidate), {}, SpecUse::geometry);
    if (!own) return DriveFault::no_teeth;
    auto made = make_drive(*own->drive);
    if (!made || !has_gears(*made)) return DriveFault::no_teeth;
    Drive drive = std::move(made).take();
    if (!drive.sets.empty() && drive.sets.front().neighbours) {
      candidate.clearance = drive.sets.front().neighbours->clearance / candidate.module;
      if (candidate.clearance < problem_.neighbour_clearance) return DriveFault::neighbours;
    }
    const WantedSafety wanted = wanted_safety(*own);
    if (rates_) {
      if (drive.flow && drive.flow->self_locking()) return DriveFault::safety;
      if (auto error = rate_drive(*own, drive)) return *error;
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

// The candidates of a search. They are computed in several steps.
class Candidates {
 public:
  Candidates(const JobSpec& spec, const DriveSearchProblem& problem,
             const std::vector<DriveCandidate>& all, int threads)
      : designer_(spec, problem),
        problem_(problem),
        all_(all),
        made_(all.size()),
        threads_(threads) {}

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

  // The next candidates by the first objective that have not been computed.
  std::vector<std::size_t> next(std::size_t count) {
    std::vector<std::size_t> which;
    for (; first_ < all_.size() && which.size() < count; ++first_)
      if (made_[first_] == State::open) which.push_back(first_);
    return which;
  }

  // The candidates on the Pareto front that have not been computed. Candidates that were left out
  // do not count.
  std::vector<std::size_t> next_of_front(std::size_t count) const {
    std::vector<std::size_t> places, which;
    std::vector<DriveCandidate> left;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (made_[i] == State::left_out) continue;
      left.push_back(all_[i]);
      places.push_back(i);
    }
    for (const std::size_t i : pareto_front(problem_, left))
      if (made_[places[i]] == State::open && which.size() < count) which.push_back(places[i]);
    return which;
  }

 private:
  enum class State { open, listed, left_out };
  Designer designer_;
  const DriveSearchProblem& problem_;
  const std::vector<DriveCandidate>& all_;
  std::vector<State> made_;
  std::size_t first_ = 0;
  bool is_rated_ = false;
  int threads_;
};

}  // namespace

bool rates_drives(const JobSpec& spec, const DriveSearchProblem& problem) {
  return spec.rating.given || problem.safety_flank || problem.safety_root || problem.face_width;
}

std::string teeth_text(const DriveCandidate& c) {
  std::vector<std::string> list;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (c.teeth[m] > 0)
      list.push_back(fmt::format("{} {}", to_string(static_cast<SetMember>(m)), c.teeth[m]));
  for (const auto& [z1, z2] : c.stages) list.push_back(fmt::format("{}:{}", z1, z2));
  return fmt::format("{}", fmt::join(list, ", "));
}

Json drive_spec(const JobSpec& spec, const DriveSearchProblem& problem, const DriveCandidate& c) {
  const Json& tree = spec.tree->tables;
  const Json& search = tree["search"];
  Json made;
  made["title"] = fmt::format("{}{}", spec.title.empty() ? "" : spec.title + ", ", teeth_text(c));
  for (const auto& [key, value] : tree.items())
    if (key != "title" && key != "search") made[key] = value;
  if (problem.safety_flank) made["rating"]["safety_flank_min"] = *problem.safety_flank;
  if (problem.safety_root) made["rating"]["safety_root_min"] = *problem.safety_root;
  const bool train = !c.stages.empty();
  const auto allowance = [&](int teeth) { return mean_allowance(problem, c, teeth); };
  Json shared = shared_keys(search, train);
  if (!problem.modules.empty()) shared["normal_module_mm"] = c.module;
  if (c.face_width) shared["face_width_mm"] = *c.face_width;
  if (train) {
    for (std::size_t k = 0; k < c.stages.size(); ++k) {
      Json stage = shared;
      for (const char* key : {"speed_rpm", "torque_Nm"})
        if (k > 0) stage.erase(key);
      stage["teeth"] = c.stages[k];
      if (!problem.series.empty())
        stage["thickness_allowance_mm"] = {allowance(c.stages[k][0]), allowance(c.stages[k][1])};
      if (const auto& x = c.shifts; !x.empty() && x[2 * k] && x[2 * k + 1])
        stage["profile_shift"] = {*x[2 * k], *x[2 * k + 1]};
      made["stage"].push_back(std::move(stage));
    }
    return made;
  }
  for (std::size_t m = 0, g = 0; m < kSetMembers; ++m) {
    if (c.teeth[m] == 0) continue;
    const char* member = to_string(static_cast<SetMember>(m));
    shared[member] = c.teeth[m];
    if (!problem.series.empty()) shared["thickness_allowance_mm"][member] = allowance(c.teeth[m]);
    if (g < c.shifts.size() && c.shifts[g]) shared["profile_shift"][member] = *c.shifts[g];
    ++g;
  }
  shared["planets"] = c.planets;
  const PlanetarySpec& base = problem.base;
  if (!shared.contains("spacing")) shared["spacing"] = "equal";
  if (base.fixed && !shared.contains("fixed")) shared["fixed"] = *base.fixed;
  if (!base.inputs.empty() && !shared.contains("input")) shared["input"] = base.inputs;
  if (!base.output.empty() && !shared.contains("output")) shared["output"] = base.output;
  made["planetary"] = std::move(shared);
  return made;
}

Result<DriveDesigns> drive_designs(const JobSpec& spec, const DriveSearchProblem& problem,
                                   const DriveSearchResult& result, std::size_t top, int threads) {
  if (rates_drives(spec, problem) && problem.modules.empty())
    return absent_input(
        "search.normal_module_mm",
        "; drives can be rated only with a module, for example normal_module_mm = [1, 1.5, 2]");
  DriveDesigns designs;
  Candidates candidates(spec, problem, result.found, threads);
  const auto may_compute = [&](std::size_t count) {
    return std::min(count, kMostComputedDrives - designs.computed);
  };
  while (designs.list.size() < top) {
    const auto which = candidates.next(may_compute(top - designs.list.size()));
    if (which.empty()) break;
    if (auto error = candidates.compute(which, designs)) return *error;
  }
  for (std::size_t more = top; more > 0;) {
    const auto which = candidates.next_of_front(may_compute(more));
    if (which.empty()) break;
    const std::size_t before = designs.list.size();
    if (auto error = candidates.compute(which, designs)) return *error;
    more -= designs.list.size() - before;
  }
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
