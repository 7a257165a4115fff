#include "gearwright/job/drive_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/design/search_problem.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kListedDrives = 20;

bool rates_drives(const JobSpec& spec, const DriveSearchProblem& problem) {
  return spec.rating.given || problem.safety_flank || problem.safety_root || problem.face_width;
}

// Returns a change that the user may try if the search finds no drive.
std::string advice(const FoundDrives& f) {
  auto left_out = f.designs.left_out;
  left_out[static_cast<std::size_t>(DriveFault::safety)] += f.designs.hopeless;
  if (f.designs.beyond_limit > 0)
    return fmt::format(
        "No drive was found among the {} computed sets, but {} sets were not computed, so a drive "
        "may exist. Narrow the band of the ratio or the bands of numbers of teeth.",
        f.designs.computed, f.designs.beyond_limit);
  if (const auto [least, most] = f.problem.stages;
      f.problem.kind == DriveKind::train && least == most && f.result.found.empty() &&
      (least % 2 == 0 ? f.problem.ratio[1] < 0.0 : f.problem.ratio[0] > 0.0))
    return fmt::format(
        "The ratio of a train of {} external stage{} is {}. Give a ratio with the other sign, or "
        "another number of stages.",
        least, least == 1 ? "" : "s", least % 2 == 0 ? "positive" : "negative");
  const auto most = std::max_element(left_out.begin(), left_out.end());
  // The size is the last limit that is checked, so these drives satisfy all other limits.
  if (f.result.found.empty() && f.result.rejected[static_cast<std::size_t>(DriveLimit::size)] > 0)
    return "All drives that satisfy the other limits are greater than size_max_mm. Give a greater "
           "size_max_mm, smaller numbers of teeth or a smaller module.";
  if (f.result.found.empty() && f.problem.center_distance)
    return "No drive satisfies all limits. Widen the band center_distance_mm, the bands of numbers "
           "of teeth or of the ratio, or give other modules.";
  if (f.result.found.empty() && f.problem.coprime)
    return "No drive satisfies all limits. Widen the bands of numbers of teeth or of the ratio, or "
           "leave out the key coprime.";
  if (f.result.found.empty() || *most == 0)
    return fmt::format(
        "No drive satisfies all limits. Widen the band of the ratio, the bands of numbers of "
        "teeth, or {}.",
        f.problem.kind == DriveKind::train ? "the band of the numbers of stages"
                                           : "coaxial_teeth, or use spacing = \"nearest\"");
  switch (static_cast<DriveFault>(most - left_out.begin())) {
    case DriveFault::safety:
      return fmt::format(
          "No drive has the required safeties. Try greater modules, a greater face_width_mm, {} or "
          "a stronger material.",
          f.problem.kind == DriveKind::train ? "greater pinion_teeth" : "more planets");
    case DriveFault::neighbours:
      return "In every set the planets are too close to each other. Try fewer planets or a smaller "
             "neighbour_clearance_min.";
    case DriveFault::sliding:
      return "No drive has a specific sliding below sliding_max. Try greater numbers of teeth, or "
             "give profile_shift.";
    case DriveFault::overlap:
      return "No drive reaches the overlap ratio overlap_ratio_min. Try a greater helix_angle_deg "
             "or a greater face_width_mm.";
    case DriveFault::no_teeth:
    case DriveFault::verdict: break;
  }
  return fmt::format(
      "No drive has a green verdict. Try {}greater numbers of teeth, or give profile_shift or "
      "another coaxial_teeth. The command `gearwright drive` shows why a given set has no green "
      "verdict.",
      f.problem.base.backlash.all ? "a smaller backlash_mm or " : "");
}

std::string drives_listing(const FoundDrives& f, UnitSystem units) {
  const DriveDesigns& designs = f.designs;
  std::string text =
      fmt::format("{} sets of numbers of teeth were tested, and {} satisfy all limits\n",
                  f.result.tested, f.result.found.size());
  constexpr const char* kWords[] = {"the ratio", "the places at which planets can be assembled",
                                    "the clearance of neighbouring planets", "the class of phasing",
                                    "the greatest size"};
  for (std::size_t i = 0; i < std::size(kWords); ++i)
    if (f.result.rejected[i] > 0)
      text += fmt::format("  ruled out by {}: {}\n", kWords[i], f.result.rejected[i]);
  if (designs.computed > 0)
    text += fmt::format("The teeth of {} sets were computed, and {} of these sets can be used.\n",
                        designs.computed, designs.green);
  constexpr const char* kFaults[] = {
      "teeth that cannot be made or mounted",
      "planets that are too close to each other with their profile shifts",
      "the greatest specific sliding",
      "the least overlap ratio",
      "the safeties",
      "the verdict"};
  for (std::size_t i = 0; i < std::size(kFaults); ++i)
    if (designs.left_out[i] > 0)
      text += fmt::format("  ruled out by {}: {}\n", kFaults[i], designs.left_out[i]);
  if (designs.hopeless > 0)
    text += fmt::format(
        "{} trains were ruled out, because their safeties, estimated from rated trains, are too "
        "small.\n",
        designs.hopeless);
  if (designs.beyond_limit > 0)
    text += fmt::format(
        "{} sets were not computed, because at most {} sets are computed for each module.\n",
        designs.beyond_limit, kMostComputedDrives);
  if (designs.list.empty()) return text + "\n" + wrapped(sentence_in(units, advice(f)));
  const auto first = static_cast<std::size_t>(f.problem.objectives.front());
  text += fmt::format("Designs are ranked by {}{}.\n", kDriveObjectiveNames[first],
                      designs.pareto.empty() ? "" : "; designs on the Pareto front come first");
  if (!f.problem.base.series.empty())
    text += fmt::format("All gears have the mean thickness allowances of series {} (DIN 3967).\n",
                        f.problem.base.series);
  if (const auto& backlash = f.problem.base.backlash.all)
    text += wrapped(sentence_in(
        units,
        fmt::format("The teeth are thinned for a backlash of {:g} mm in every mesh.", *backlash)));
  if (f.default_face_load)
    text += wrapped(fmt::format(
        "All meshes are rated with K_Hβ = {:g} (the default; to change it, give face_load_factor "
        "in [rating]).",
        *f.default_face_load));
  ListingColumn teeth{"numbers of teeth", "numbers of teeth", "", {}, true};
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < designs.list.size() && i < kListedDrives; ++i) {
    teeth.cells.push_back(teeth_text(designs.list[i].candidate));
    records.push_back(found_drive_quantities().of(designs.list[i]));
  }
  text += ranked_listing(
      units, designs.pareto, std::move(teeth), records,
      {"planets", "normal_module_mm", "face_width_mm", "ratio", "efficiency", "efficiency_backward",
       "noise", "size_mm", "size_modules", "mass_kg", "neighbour_clearance_mm", "safety_flank",
       "safety_root", "phasing", "profile_shift"});
  if (designs.list.size() > kListedDrives)
    text += wrapped(fmt::format(
        "  … {} more designs; --json lists all of them, --top N computes more, --take N "
        "writes the spec of one design",
        designs.list.size() - kListedDrives));
  else
    text += "\nThe option --take NUMBER > drive.toml writes the spec of a design.\n";
  return text;
}

// True if `search.material` is a table of members that contains this member.
bool has_own_material(const JobSpec& spec, SetMember member) {
  const Json& search = spec.tree->tables["search"];
  return search.contains("material") && search["material"].contains(to_string(member));
}

// Sets the densities of the gears if the search needs them.
std::optional<Error> set_densities(const JobSpec& spec, DriveSearchProblem& problem) {
  if (!problem.asks(DriveObjective::mass)) return std::nullopt;
  const auto materials = drive_materials(spec.tree->tables);
  const bool train = problem.kind == DriveKind::train;
  for (const SetMember member : train ? std::vector{SetMember::sun} : members_of(problem)) {
    const auto own = materials.find(train ? "s1_gear1" : to_string(member));
    if (own == materials.end() && !spec.rating.material) continue;
    const auto density = density_of(own != materials.end() ? own->second : *spec.rating.material);
    if (!density)
      return absent_input(fmt::format("{}.density_kg_per_m3",
                                      own == materials.end() ? "rating.material"
                                      : has_own_material(spec, member)
                                          ? fmt::format("search.material.{}", to_string(member))
                                          : "search.material"),
                          fmt::format("; the mass of a plastic gear ({}) needs its density",
                                      train ? "of the train" : to_string(member)));
    problem.density[static_cast<std::size_t>(member)] = *density;
  }
  return std::nullopt;
}

}  // namespace

bool searches_drives(const JobSpec& spec) {
  const Json& tree = spec.tree->tables;
  return tree.contains("search") && is_drive_search(tree["search"]);
}

Result<Answer> answer_drive_search(const JobSpec& spec, std::size_t top, int threads,
                                   Progress* progress) {
  GW_EXPECTS(searches_drives(spec));
  DriveDesignTask task{read_drive_search(spec.tree->tables["search"]),
                       default_face_step(spec.units())};
  DriveSearchProblem& problem = task.problem;
  const bool rated = rates_drives(spec, problem);
  if (auto error = set_densities(spec, problem)) return *error;
  // If the search chooses the profile shifts of rated trains, their sliding has the same limit as
  // that of rated pairs. Planetary sets have no such limit, because small sets cannot satisfy it
  // with any shifts.
  const PerMember& shift = problem.base.profile_shift;
  if (rated && problem.kind == DriveKind::train && problem.sliding == kInfinity && !shift.all &&
      !shift.any())
    problem.sliding = kDrawnSliding;
  // Each stage of a rated train may have its own module if the spec permits several modules, or if
  // the drives are sorted by mass and the search chooses their face widths. If the centre distance
  // is limited, every choice of modules is a separate candidate instead.
  problem.module_per_stage =
      problem.kind == DriveKind::train && rated && !problem.center_distance &&
      (problem.modules.size() > 1 ||
       (problem.face_width && problem.objectives.front() == DriveObjective::mass));
  auto result = search_drives(problem, threads);
  if (!result) return of_drive_table(result.error(), spec.tree->tables);
  if (!result->is_complete)
    return Error{
        "search.stages", std::to_string(problem.stages[1]),
        fmt::format("gives too many trains; a search finds at most {} trains and tries at most {} "
                    "combinations of the numbers of teeth of all gears except the last. Narrow the "
                    "band of ratio, pinion_teeth or wheel_teeth, or give coaxial_teeth",
                    kMostTrains, kMostTrainTrials)};
  if (rated && problem.modules.empty())
    return absent_input(
        "search.normal_module_mm",
        "; drives can be rated only with a module, for example normal_module_mm = [1, 1.5, 2]");
  const Safeties of_rating = wanted_safety(spec);
  task.required = {problem.safety_flank.value_or(of_rating.flank),
                   problem.safety_root.value_or(of_rating.root)};
  if (rated) task.rate = drive_rater(spec);
  task.progress = progress;
  auto designs = drive_designs(task, *result, top, threads);
  if (!designs) return designs.error();
  const auto face_load =
      rated && has_default_face_load(spec) ? spec.rating.input.face_load_factor : std::nullopt;
  const auto found = std::make_shared<FoundDrives>(
      FoundDrives{problem, std::move(result).take(), std::move(designs).take(), face_load});
  Answer answer;
  answer.record["search"] = to_json(drive_search_quantities().of(*found));
  for (const FoundDrive& d : found->designs.list)
    answer.specs.push_back(drive_spec(spec, problem, d.candidate));
  answer.why_none = "no drive satisfies all limits";
  answer.listing = [found, units = spec.units()] { return drives_listing(*found, units); };
  return answer;
}

}  // namespace gearwright
