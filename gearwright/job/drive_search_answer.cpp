#include "gearwright/job/drive_search_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/drive_search_quantities.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/value_json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive_search.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kListedDrives = 20;
/// Number of candidates that are computed for each requested drive, as some turn out to have no
/// teeth.
constexpr std::size_t kTries = 5;

std::string teeth_text(const DriveCandidate& c) {
  std::vector<std::string> list;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (c.teeth[m] > 0)
      list.push_back(fmt::format("{} {}", to_string(static_cast<SetMember>(m)), c.teeth[m]));
  for (const auto& [z1, z2] : c.stages) list.push_back(fmt::format("{}:{}", z1, z2));
  return fmt::format("{}", fmt::join(list, ", "));
}

// A candidate as a spec of the verb drive: the common keys of the search, and its numbers of teeth.
Json drive_spec(const JobSpec& spec, const DriveSearchProblem& problem, const DriveCandidate& c) {
  const Json& tree = spec.tree->tables;
  const Json& search = tree["search"];
  Json made;
  made["title"] = fmt::format("{}{}", spec.title.empty() ? "" : spec.title + ", ", teeth_text(c));
  for (const auto& [key, value] : tree.items())
    if (key != "title" && key != "search") made[key] = value;
  if (!c.stages.empty()) {
    Json shared = shared_keys(search, true);
    for (std::size_t k = 0; k < c.stages.size(); ++k) {
      Json stage = shared;
      for (const char* key : {"speed_rpm", "torque_Nm"})
        if (k > 0) stage.erase(key);
      stage["teeth"] = c.stages[k];
      made["stage"].push_back(std::move(stage));
    }
    return made;
  }
  Json set = shared_keys(search, false);
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (c.teeth[m] > 0) set[to_string(static_cast<SetMember>(m))] = c.teeth[m];
  set["planets"] = c.planets;
  const PlanetarySpec& base = problem.base;
  if (!set.contains("spacing")) set["spacing"] = "equal";
  if (base.fixed && !set.contains("fixed")) set["fixed"] = *base.fixed;
  if (!base.inputs.empty() && !set.contains("input")) set["input"] = base.inputs;
  if (!base.output.empty() && !set.contains("output")) set["output"] = base.output;
  made["planetary"] = std::move(set);
  return made;
}

bool has_gears(const Drive& drive) {
  return std::none_of(
      drive.geometry.faults.begin(), drive.geometry.faults.end(),
      [](const GeometryFault& f) { return f.kind == GeometryFault::Kind::not_coaxial; });
}

// The drive of a candidate; none: it has no teeth, or its planets are too close with their profile
// shifts.
std::optional<FoundDrive> computed_drive(const JobSpec& spec, const DriveSearchProblem& problem,
                                         const DriveCandidate& candidate) {
  const auto own = read_spec_tree(drive_spec(spec, problem, candidate), {}, SpecUse::geometry);
  if (!own) return std::nullopt;
  auto solved = solve_drive(*own);
  if (!solved || !has_gears(solved->drive)) return std::nullopt;
  DriveJob job = std::move(solved).take();
  FoundDrive found{candidate, std::move(job.drive), std::move(job.verdict)};
  if (!found.drive.sets.empty() && found.drive.sets.front().neighbours) {
    const double module = problem.base.normal_module.value_or(1.0);
    found.candidate.clearance = found.drive.sets.front().neighbours->clearance / module;
    if (found.candidate.clearance < problem.neighbour_clearance) return std::nullopt;
  }
  if (found.drive.flow) found.candidate.efficiency = found.drive.flow->efficiency;
  if (found.drive.backward) found.candidate.efficiency_backward = found.drive.backward->efficiency;
  return found;
}

// The candidates to compute: the best by the first objective, and the Pareto front.
std::vector<DriveCandidate> chosen_drives(const DriveSearchProblem& problem,
                                          const std::vector<DriveCandidate>& found,
                                          std::size_t top) {
  std::vector<bool> take(found.size());
  std::fill_n(take.begin(), std::min(found.size(), top), true);
  std::size_t more = 0;
  for (const std::size_t i : pareto_front(problem, found))
    if (!take[i] && more++ < top) take[i] = true;
  std::vector<DriveCandidate> list;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (take[i]) list.push_back(found[i]);
  return list;
}

struct FoundDrives {
  DriveSearchProblem problem;
  DriveSearchResult result;
  std::vector<FoundDrive> designs;
  std::vector<std::size_t> pareto;

  DriveSearchView view() const { return {&problem, &result, &designs, &pareto}; }
};

void compute_drives(const JobSpec& spec, std::size_t top, int threads, FoundDrives& found) {
  const std::vector<DriveCandidate> list =
      chosen_drives(found.problem, found.result.found, std::max(top, std::size_t{1}));
  std::size_t next = 0, wanted = list.size();
  const auto block = [&](const std::vector<DriveCandidate>& candidates) {
    std::vector<std::optional<FoundDrive>> made(candidates.size());
    parallel_for(
        made.size(),
        [&](std::size_t i) { made[i] = computed_drive(spec, found.problem, candidates[i]); },
        threads);
    for (auto& one : made)
      if (one) found.designs.push_back(std::move(*one));
  };
  block(list);
  // Replaces candidates without teeth by the next ones.
  next = std::min(top, found.result.found.size());
  const std::size_t last = std::min(found.result.found.size(), next + kTries * top);
  while (found.designs.size() < std::min(top, wanted) && next < last) {
    const std::size_t end = std::min(last, next + top - found.designs.size());
    block({found.result.found.begin() + static_cast<std::ptrdiff_t>(next),
           found.result.found.begin() + static_cast<std::ptrdiff_t>(end)});
    next = end;
  }
  const auto cost = [&](const FoundDrive& f) {
    return cost_of(found.problem, f.candidate, found.problem.objectives.front());
  };
  std::stable_sort(found.designs.begin(), found.designs.end(),
                   [&](const FoundDrive& a, const FoundDrive& b) { return cost(a) < cost(b); });
  std::vector<DriveCandidate> exact;
  for (const FoundDrive& f : found.designs) exact.push_back(f.candidate);
  found.pareto = pareto_front(found.problem, exact);
}

std::string drive_number(const std::optional<double>& x, int decimals) {
  return x && std::isfinite(*x) ? fixed_decimals(*x, decimals) : "-";
}

std::string drives_listing(const FoundDrives& f) {
  std::string text = fmt::format("{} sets of numbers of teeth, {} hold all limits\n",
                                 f.result.tested, f.result.found.size());
  constexpr const char* kWords[] = {"the ratio", "places at which the planets assemble",
                                    "the clearance of neighbouring planets",
                                    "the class of phasing"};
  for (std::size_t i = 0; i < std::size(kWords); ++i)
    if (f.result.rejected[i] > 0)
      text += fmt::format("  ruled out by {}: {}\n", kWords[i], f.result.rejected[i]);
  if (f.designs.empty())
    return text +
           "\nNo drive holds all limits. Widen the band of the ratio, the bands of teeth, or "
           "coaxial_teeth, or use spacing = \"nearest\".\n";
  text += fmt::format("\n{:>4}  {:<46} {:>2} {:>10} {:>8} {:>8} {:>9} {:>8} {:<10} {}\n", "rank",
                      "teeth", "N", "ratio", "η", "η back", "size mm", "c mm", "phases", "verdict");
  for (std::size_t i = 0; i < f.designs.size() && i < kListedDrives; ++i) {
    const FoundDrive& d = f.designs[i];
    std::optional<double> clearance;
    std::string phases = "-";
    if (!d.drive.sets.empty()) {
      const PlanetSet& set = d.drive.sets.front();
      if (set.neighbours) clearance = set.neighbours->clearance;
      constexpr const char* kClasses[] = {"in phase", "sequential", "counter", "mixed"};
      phases = kClasses[static_cast<std::size_t>(set.phasing.kind)];
    }
    constexpr const char* kLevels[] = {"green", "amber", "red"};
    const auto eta = [](const std::optional<PowerFlow>& flow) {
      return drive_number(flow ? std::optional(flow->efficiency) : std::nullopt, 5);
    };
    const bool front = std::find(f.pareto.begin(), f.pareto.end(), i) != f.pareto.end();
    text += fmt::format("{:>4}  {:<46} {:>2} {:>10} {:>8} {:>8} {:>9} {:>8} {:<10} {}{}\n", i + 1,
                        teeth_text(d.candidate), d.candidate.planets,
                        drive_number(d.drive.motion.ratio->value(), 5), eta(d.drive.flow),
                        eta(d.drive.backward), drive_number(d.candidate.size, 2),
                        drive_number(clearance, 3), phases,
                        kLevels[static_cast<std::size_t>(d.verdict.level)], front ? ", front" : "");
  }
  if (f.result.found.size() > kListedDrives)
    text +=
        fmt::format("  … {} more; --top N lists more in JSON, and --take N writes one as a spec\n",
                    f.result.found.size() - kListedDrives);
  return text;
}

std::string drives_csv(const FoundDrives& f) {
  std::string out = "teeth,planets,ratio,efficiency,efficiency_backward,size_mm,verdict\r\n";
  for (const FoundDrive& d : f.designs) {
    const Json row = to_json(found_drive_quantities().of(d));
    const auto cell = [&](const char* key) {
      return row[key].is_null() ? "" : json_text(row[key]);
    };
    out += fmt::format("{},{},{},{},{},{},{}\r\n", csv_cell(Value(teeth_text(d.candidate))),
                       d.candidate.planets, cell("ratio"), cell("efficiency"),
                       cell("efficiency_backward"), cell("size_mm"),
                       row["verdict"].get<std::string>());
  }
  return out;
}

}  // namespace

bool searches_drives(const JobSpec& spec) {
  const Json& tree = spec.tree->tables;
  return tree.contains("search") && is_drive_search(tree["search"]);
}

Result<Answer> answer_drive_search(const JobSpec& spec, std::size_t top, int threads) {
  GW_EXPECTS(searches_drives(spec));
  const DriveSearchProblem problem = read_drive_search(spec.tree->tables["search"]);
  auto result = search_drives(problem, threads);
  if (!result) {
    Error error = result.error();
    constexpr std::string_view kGraph = "drive.";
    if (error.field.starts_with(kGraph))
      error.field = "search." + error.field.substr(kGraph.size());
    return error;
  }
  const auto found =
      std::make_shared<FoundDrives>(FoundDrives{problem, std::move(result).take(), {}, {}});
  compute_drives(spec, top, threads, *found);
  Answer answer;
  answer.record["search"] = to_json(drive_search_quantities().of(found->view()));
  for (const FoundDrive& d : found->designs)
    answer.specs.push_back(drive_spec(spec, problem, d.candidate));
  answer.why_none = "no drive holds all limits";
  answer.listing = [found] { return drives_listing(*found); };
  answer.csv = [found] { return drives_csv(*found); };
  return answer;
}

}  // namespace gearwright
