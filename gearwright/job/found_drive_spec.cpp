#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "gearwright/job/drive_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

std::string teeth_text(const DriveCandidate& c) {
  std::vector<std::string> list;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (c.teeth[m] > 0)
      list.push_back(fmt::format("{} {}", to_string(static_cast<SetMember>(m)), c.teeth[m]));
  for (std::size_t k = 0; k < c.stages.size(); ++k) {
    list.push_back(fmt::format("{}:{}", c.stages[k][0], c.stages[k][1]));
    if (!c.has_one_module()) list.back() += fmt::format(" (m {:g})", c.stage_modules[k]);
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

namespace {

// Adds the torque and the speed of [rating] to the keys of the drive if these have no load. A
// drive of several inputs needs a list of speeds, which [rating] cannot give.
void add_load(const Json& tree, const DriveSearchProblem& problem, Json& shared) {
  const bool several = problem.base.inputs.size() > 1;
  if (several || !tree.contains("rating") || shared.contains("torque_Nm") ||
      shared.contains("power_kW"))
    return;
  const Json& rating = tree["rating"];
  if (!rating.contains("torque_Nm") && !rating.contains("power_kW")) return;
  for (const char* key : {"torque_Nm", "power_kW", "speed_rpm"})
    if (rating.contains(key) && !shared.contains(key)) shared[key] = rating[key];
}

}  // namespace

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
  Json shared = shared_keys(search, train);
  add_load(tree, problem, shared);
  if (!problem.modules.empty()) shared["normal_module_mm"] = c.module;
  if (!problem.base.series.empty()) shared["thickness_series"] = problem.base.series;
  if (train) {
    for (std::size_t k = 0; k < c.stages.size(); ++k) {
      Json stage = shared;
      for (const char* key : {"speed_rpm", "torque_Nm", "power_kW"})
        if (k > 0) stage.erase(key);
      stage["teeth"] = c.stages[k];
      if (!problem.modules.empty()) stage["normal_module_mm"] = c.stage_module(k);
      if (!c.face_widths.empty()) stage["face_width_mm"] = c.face_widths[k];
      if (const double beta = stage_helix_deg(problem, k);
          beta != problem.base.helix_deg.all.value_or(0.0))
        stage["helix_angle_deg"] = beta;
      if (const auto x = c.stage_shifts(k)) stage["profile_shift"] = *x;
      made["stage"].push_back(std::move(stage));
    }
    if (is_coaxial(problem, c)) made["stage"].back()["angle_deg"] = "coaxial";
    return made;
  }
  const PerMember widths = member_face_widths(c);
  if (widths.any()) shared["face_width_mm"] = Json::object();
  for (std::size_t m = 0, g = 0; m < kSetMembers; ++m) {
    if (c.teeth[m] == 0) continue;
    const char* member = to_string(static_cast<SetMember>(m));
    shared[member] = c.teeth[m];
    if (widths.each[m]) shared["face_width_mm"][member] = *widths.each[m];
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

}  // namespace gearwright
