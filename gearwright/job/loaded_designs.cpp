#include "gearwright/job/loaded_designs.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>
#include <tuple>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/load/load_summary.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// Returns the greatest peak-to-peak transmission error of a pair under the torques of its spec, µm
// along the line of action. The pair is computed in the same way as by the verb `load`. An error
// names keys of the spec of the pair.
Result<double> loaded_noise(const Json& tree, const std::filesystem::path& folder) {
  const auto spec = read_spec_tree(tree, folder, SpecUse::load);
  if (!spec) return spec.error();
  const auto named = [&](const Error& error) { return spelled(error, spec->given); };
  auto solved = solve(*spec, Scope::pair);
  if (!solved) return named(solved.error());
  SolvedJob job = std::move(solved).take();
  job.spec.load.rotations.clear();  // a peak to peak needs a whole pitch
  const auto answer = answer_load(job);
  if (!answer) return named(answer.error());
  if (!answer->contact)
    return Error{"load.torque_Nm", "", "is missing; [load] contains only probes",
                 FailureKind::not_under_load};
  double most = 0.0;
  for (const LoadedTorque& t : answer->contact->torques) {
    const auto solved_positions = std::count_if(t.positions.begin(), t.positions.end(),
                                                [](const LoadedPosition& p) { return p.solved(); });
    if (const auto all = static_cast<std::ptrdiff_t>(t.positions.size()); solved_positions < all)
      return Error{"", "",
                   fmt::format("at {} of {} positions the teeth do not touch, or the forces do not "
                               "converge",
                               all - solved_positions, all),
                   FailureKind::not_converged};
    most = std::max(most, peak_to_peak_on_line(t, job.gear(2)) * kUmPerMm);
  }
  return most;
}

}  // namespace

std::size_t designs_to_keep(const SearchProblem& problem, std::size_t top) {
  const auto loaded = static_cast<std::size_t>(problem.loaded_designs);
  return problem.loads_designs() ? std::max(top, loaded) : top;
}

std::size_t designs_to_load(const SearchProblem& problem, const SearchAnswer& answer) {
  const auto most = static_cast<std::size_t>(problem.loaded_designs);
  return problem.loads_designs() ? std::min(most, answer.designs.size()) : 0;
}

LoadedDesign loaded_design(const JobSpec& spec, const Search& search, const DesignRow& row) {
  LoadedDesign design{row.trial};
  const auto found = loaded_noise(pair_spec(spec, search, row), spec.folder);
  if (found)
    design.noise = *found;
  else
    design.reason = found.error().message();
  return design;
}

void rank_loaded(const SearchProblem& problem, std::vector<LoadedDesign> loaded, std::size_t top,
                 SearchAnswer& answer) {
  auto& designs = answer.designs;
  GW_EXPECTS(loaded.size() <= designs.size());
  for (std::size_t i = 0; i < loaded.size(); ++i) designs[i].loaded_noise = loaded[i].noise;
  if (problem.objectives.front() == Objective::noise) {
    // The Pareto front is at the beginning of the list.
    const auto key = [&](std::size_t i) {
      const DesignRow& row = designs[i];
      return std::tuple(i >= answer.pareto.size(), !cost(problem, row, Objective::noise),
                        !row.loaded_noise, row.loaded_noise.value_or(0.0), i);
    };
    std::vector<std::size_t> order(loaded.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<DesignRow> sorted;
    std::vector<LoadedDesign> results;
    for (const std::size_t i : order) {
      sorted.push_back(designs[i]);
      results.push_back(std::move(loaded[i]));
    }
    std::move(sorted.begin(), sorted.end(), designs.begin());
    loaded = std::move(results);
  }
  answer.loaded = std::move(loaded);
  if (designs.size() <= top) return;
  designs.resize(top);
  if (answer.pareto.size() > top) answer.pareto.resize(top);
  answer.cut = true;
}

std::string loaded_line(const SearchProblem& problem, const SearchAnswer& answer) {
  std::string line = fmt::format("The transmission error under load is computed for {}",
                                 answer.loaded.size() == 1
                                     ? "the first design"
                                     : fmt::format("the first {} designs", answer.loaded.size()));
  if (answer.loaded.size() > 1 && problem.objectives.front() == Objective::noise)
    line += ", and these designs are ordered by it";
  return line + ".";
}

std::vector<std::string> load_failures(const SearchAnswer& answer) {
  std::vector<std::string> lines;
  for (const LoadedDesign& design : answer.loaded)
    if (!design.noise)
      lines.push_back(fmt::format(
          "The analysis under load cannot be computed for module {:g}, {}:{} teeth: {}.",
          design.trial.module, design.trial.z1, design.trial.z2, design.reason));
  return lines;
}

bool load_designs(const JobSpec& spec, const Search& search, const SearchOptions& options,
                  SearchRun& run) {
  std::vector<LoadedDesign> loaded(designs_to_load(search.problem(), run.answer));
  std::mutex mutex;
  std::int64_t done = 0;
  const auto stopped = [&] { return options.stop && *options.stop; };
  const auto report = [&](std::int64_t more) {
    const std::lock_guard lock(mutex);
    done += more;
    if (options.progress)
      options.progress({.stage = SearchProgress::Stage::loads,
                        .done = done,
                        .of = static_cast<std::int64_t>(loaded.size())});
  };
  if (!loaded.empty()) report(0);
  parallel_for(
      loaded.size(),
      [&](std::size_t i) {
        if (stopped()) return;
        loaded[i] = loaded_design(spec, search, run.answer.designs[i]);
        report(1);
      },
      options.threads);
  run.stopped = run.stopped || stopped();
  if (!run.stopped)
    rank_loaded(search.problem(), std::move(loaded), options.top.value_or(kDefaultDesigns),
                run.answer);
  return !run.stopped;
}

}  // namespace gearwright
