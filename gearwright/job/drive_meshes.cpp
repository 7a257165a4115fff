// The meshes of a drive as separate pairs: their specs, and the contact of each pair.
//
// In the contact analysis, gear 1 of a pair turns clockwise. If gear 1 of a mesh turns
// counter-clockwise, the spec of the mesh describes the gears as seen from the other face. Right
// and left flanks are then exchanged, and lengths and slopes along the axis have the opposite sign.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/drive/drive_phases.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

// Tables of the spec of a drive that also apply to each of its meshes.
constexpr const char* kShared[] = {"errors", "contact", "drawing", "scatter"};

// Returns the series of DIN 3967 whose mean allowance the gear has. Returns an empty text if there
// is no such series. `name` is the name of the gear in the graph, for example "s2_gear1" for a gear
// of stage 2.
std::string series_of(const Json& tables, const std::string& name, const CylindricalSpec& gear) {
  std::vector<const Json*> forms;
  const auto add = [&](const Json& table, const char* key) {
    if (table.contains(key) && table[key].is_object()) forms.push_back(&table[key]);
  };
  add(tables, "planetary");
  for (std::size_t k = 0; tables.contains("stage") && k < tables["stage"].size(); ++k) {
    if (!name.starts_with(fmt::format("s{}_", k + 1))) continue;
    forms.push_back(&tables["stage"][k]);
    add(tables["stage"][k], "planetary");
  }
  const double diameter =
      gear.normal_module * std::abs(gear.teeth) / std::cos(gear.helix_angle.rad());
  for (const Json* form : forms) {
    const std::string series = form->value("thickness_series", "");
    if (!series.empty() && series != kNoAllowances &&
        mean_allowance(series, diameter) == gear.thickness_allowance)
      return series;
  }
  return "";
}

Json gear_table(const DriveJob& job, const Json& expanded, std::size_t gear) {
  Json table = expanded["drive"]["gear"][gear];
  table.erase("name");
  table.erase("body");
  if (const auto& rack = job.drive.graph.gears[gear].rack) {
    Json bar = Json::object();  // the table of the pinion describes the teeth
    for (const auto& [key, value] : table.items())
      if (rack_bar_keys().find(key)) bar[key] = value;
    if (rack->thickness_allowance != 0.0) bar["thickness_allowance_mm"] = rack->thickness_allowance;
    return bar;
  }
  // Adding 0 replaces −0 by 0.
  if (table.contains("helix_angle_deg"))
    table["helix_angle_deg"] = table["helix_angle_deg"].get<double>() + 0.0;
  const auto& solved = job.drive.geometry.gears[gear];
  const auto& given = job.spec.drive->graph.gears[gear].spec;
  if (solved && solved->spec.thickness_allowance != given->thickness_allowance)
    table["thickness_allowance_mm"] = solved->spec.thickness_allowance;
  // If an allowance is the mean of a series, the name of the series replaces it. The drawing then
  // has the limits of the series.
  const std::string series =
      solved ? series_of(job.spec.tree->tables, job.drive.graph.gears[gear].name, solved->spec)
             : "";
  if (!series.empty()) {
    table.erase("thickness_allowance_mm");
    table["tolerance"]["thickness_series"] = series;
  }
  if (!solved || !solved->involute() || table.contains("basic")) return table;
  table.erase("profile_shift_pair");
  table["profile_shift"] = solved->spec.profile_shift;
  const bool round = solved->spec.root_fillet || solved->spec.tip_fillet;
  if (!round && !table.contains("tip_diameter_mm")) table["tip_diameter_mm"] = solved->tip_diameter;
  return table;
}

// The load of a mesh in the rating of a drive, and the number of engagements of its flanks.
struct RatedLoad {
  RatingInput input;
  std::array<FlankUse, 2> use;
};

// Returns the table [rating] for one mesh. The load is that of one copy of the mesh. life_h is
// multiplied by the number of engagements per turn of the gear that has more of them. The bending
// counts as reversed if it is reversed for at least one of the gears.
Json rating_table(const Json& of_drive, const RatedLoad& load) {
  Json table = of_drive;
  for (const char* key : {"power_kW", "speed_rpm", "mesh_load_factor", "spectrum"})
    table.erase(key);
  table["torque_Nm"] = load.input.torque;
  if (load.input.speed) table["speed_rpm"] = *load.input.speed;
  if (load.input.mesh_load_factor != 1.0) table["mesh_load_factor"] = load.input.mesh_load_factor;
  const int engagements = std::max(load.use[0].engagements, load.use[1].engagements);
  if (load.input.life_h && engagements > 1) table["life_h"] = *load.input.life_h * engagements;
  if (load.use[0].both || load.use[1].both) table["reversed"] = true;
  return table;
}

// Splits the key of a modification into the prefix of a flank, which may be empty, and the rest.
std::pair<std::string, std::string> split_flank(const std::string& key) {
  for (const std::string_view side : kFlankSides)
    if (key.starts_with(side)) return {std::string(side), key.substr(side.size())};
  return {"", key};
}

bool has_topography(const Json& spec) {
  for (const char* gear : {"gear1", "gear2"})
    if (spec[gear].contains("modifications"))
      for (const auto& [key, value] : spec[gear]["modifications"].items())
        if (split_flank(key).second == "topography") return true;
  return false;
}

// Describes the pair as seen from the other face. Returns true if this changes the spec.
bool turn_over(Json& spec, bool halves) {
  bool changed = false;
  const auto negate = [&](Json& number) {
    changed = changed || number != 0.0;
    number = 0.0 - number.get<double>();
  };
  for (const char* gear : {"gear1", "gear2"}) {
    if (!spec[gear].contains("modifications")) continue;
    Json turned = Json::object();
    for (const auto& [key, value] : spec[gear]["modifications"].items()) {
      const auto& [side, rest] = split_flank(key);
      const auto other =
          std::find(kFlankSides.begin(), kFlankSides.end(), side) == kFlankSides.begin()
              ? kFlankSides[1]
              : kFlankSides[0];
      changed = changed || !side.empty();
      Json& target = turned[side.empty() ? rest : std::string(other) + rest] = value;
      if (rest == "lead_slope_um" && !halves) negate(target);
    }
    spec[gear]["modifications"] = std::move(turned);
  }
  constexpr std::array kAlongAxis{"intersecting_deg", "axial_mm"};
  for (const char* error : kAlongAxis)
    if (spec.contains("errors") && spec["errors"].contains(error)) negate(spec["errors"][error]);
  for (const std::string axis : {"x", "y"}) {
    if (!spec.contains("contact") || !spec["contact"].contains("map")) break;
    Json& map = spec["contact"]["map"];
    if (!is_in(map[axis].get<std::string>(), kAlongAxis)) continue;
    Json& range = map[axis + "_range"];
    std::swap(range[0], range[1]);
    for (Json& end : range) negate(end);
  }
  // Seen from the other face, the half at z > 0 is the one that was at z < 0, which has the
  // opposite hand. Helix angles and the errors of the helix slope therefore change their sign. The
  // slopes of modifications keep their sign.
  if (halves && (changed || spec.contains("errors"))) {
    for (const char* gear : {"gear1", "gear2"})
      if (spec[gear].contains("helix_angle_deg")) negate(spec[gear]["helix_angle_deg"]);
    for (const char* error : {"helix_slope1_um", "helix_slope2_um"})
      if (spec.contains("errors") && spec["errors"].contains(error)) negate(spec["errors"][error]);
  }
  return changed;
}

}  // namespace

MeshSpec mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh) {
  const Drive& drive = job.drive;
  const DriveMesh& m = drive.graph.meshes[mesh];
  Json spec = Json::object();
  spec["title"] = job.spec.title.empty() ? m.name : fmt::format("{}, {}", job.spec.title, m.name);
  const bool rack = drive.graph.gear(m, 0).rack || drive.graph.gear(m, 1).rack;
  const std::size_t first = drive.graph.gear(m, 0).rack ? 1 : 0;
  spec["gear1"] = gear_table(job, expanded, m.gears[first]);
  spec["gear2"] = gear_table(job, expanded, m.gears[1 - first]);
  Json& pair = spec["pair"] = Json::object();
  if (const auto& distance = drive.geometry.distance[mesh]) pair["center_distance_mm"] = *distance;
  if (const double friction = m.friction.value_or(drive.graph.friction); friction > 0.0)
    pair["friction_coefficient"] = friction;
  const bool halves = drive.graph.gear(m, 0).double_helical.has_value();
  const bool locks = drive.flow && drive.flow->self_locking();
  const bool carries = drive.flow && !locks && drive.flow->driver[mesh] >= 0 && !rack;
  std::optional<double> torque = drive.graph.torque_Nm;
  if (!torque && job.spec.load.torques.size() == 1) torque = job.spec.load.torques.front();
  if (carries && torque.value_or(0.0) != 0.0) {
    const RatingInput load = mesh_load(
        drive, mesh, {std::abs(*torque), drive.speed_rpm(drive.graph.inputs.front()), {}});
    if (load.speed) pair["speed_rpm"] = *load.speed;
    spec["load"]["torque_Nm"] = load.torque;
    if (drive.flow->driver[mesh] == 1) spec["load"]["driver"] = 2;
    for (const char* key : {"positions", "slices", "accuracy"})
      if (expanded.contains("load") && expanded["load"].contains(key))
        spec["load"][key] = expanded["load"][key];
  }
  for (const std::string name : kShared)
    if (expanded.contains(name) && !(halves && name == "scatter")) spec[name] = expanded[name];
  const auto sense = detail::sense_of(drive, mesh);
  if (sense && spec.contains("contact")) spec["contact"].erase("driver");
  if (sense && !sense->first_drives) spec["contact"]["driver"] = 2;
  const bool turned = sense && sense->turned && !has_topography(spec) && turn_over(spec, halves);

  std::vector<std::string> notes{
      fmt::format("This pair is the mesh {} of the drive. All digits of the numbers are written, "
                  "so that the results of the pair and of the drive agree to the last bit.",
                  printable(m.name))};
  if (turned)
    notes.emplace_back(
        "In the drive, gear 1 of this mesh turns counter-clockwise. The pair is described as seen "
        "from the other face, from which gear 1 turns clockwise: right and left flanks are "
        "exchanged, and lengths and slopes along the axis have the opposite sign.");
  if (job.verdict.level == Level::red) notes.push_back(job.verdict.headline);
  if (locks) notes.emplace_back("The pair has no load, because the input cannot drive the output.");
  if (job.spec.rating.given) {
    const auto load = rating_load(job.spec, drive);
    if (carries && load) {
      const RatedLoad rated{mesh_load(drive, mesh, *load),
                            {flank_use(drive, mesh, 0), flank_use(drive, mesh, 1)}};
      spec["rating"] = rating_table(expanded["rating"], rated);
      add_grade(spec["gear1"], rated.input, 0);
      add_grade(spec["gear2"], rated.input, 1);
      if (rated.use[0].engagements != rated.use[1].engagements ||
          rated.use[0].both != rated.use[1].both)
        notes.push_back(
            fmt::format("The flanks of the gears engage {} and {} times per turn. The keys life_h "
                        "and reversed in [rating] apply to the gear with the more severe use.",
                        rated.use[0].engagements, rated.use[1].engagements));
      if (expanded["rating"].contains("spectrum"))
        notes.push_back(
            "The spectrum of [rating] is left out, because it applies to the whole drive.");
    } else {
      const std::string why = rack       ? "a rack is not rated"
                              : !carries ? "the mesh carries no load"
                              : load.error().kind == FailureKind::missing ? "the drive has no load"
                                                                          : load.error().message();
      notes.push_back(fmt::format("The table [rating] is left out, because {}.", why));
    }
  }
  // The reference `pair` may be dangling here, because tables were added to `spec` after it.
  if (spec["pair"].empty()) spec.erase("pair");
  return {std::move(spec), std::move(notes)};
}

Result<JobSpec> job_of_mesh(const Drive& drive, std::size_t mesh, Json tables) {
  for (const char* table : {"rating", "scatter", "drawing"}) tables.erase(table);
  // The names of the files of a topography are relative to the folder of the spec, which is not
  // known here. The graph has the content of these files.
  const bool topography = has_topography(tables);
  for (const char* gear : {"gear1", "gear2"})
    if (topography) tables[gear].erase("modifications");
  auto read = read_spec_tree(tables);
  if (!read) return read.error();
  JobSpec spec = std::move(read).take();
  for (const int side : {0, 1})
    if (auto& gear = spec.gears[static_cast<std::size_t>(side)]; topography && gear)
      gear->modifications = drive.graph.gear(drive.graph.meshes[mesh], side).modifications;
  return spec;
}

namespace {

// Returns the contact of a mesh. The result is none if no teeth touch. It is also none if gear 1
// turns counter-clockwise and a flank has a topography, because mesh_spec() cannot describe a
// topography as seen from the other face.
Result<std::optional<ContactView>> contact_of_mesh(const DriveJob& job, const Json& expanded,
                                                   std::size_t mesh, Progress* progress) {
  using None = std::optional<ContactView>;
  Json tables = mesh_spec(job, expanded, mesh).tables;
  const auto sense = detail::sense_of(job.drive, mesh);
  if (sense && sense->turned && has_topography(tables)) return None();
  tables.erase("load");
  const auto spec = job_of_mesh(job.drive, mesh, std::move(tables));
  if (!spec) return spec.error();
  auto solved = solve_any(*spec, Scope::pair);
  if (!solved) return solved.error();
  SolvedJob pair = std::move(solved).take();
  auto answer = answer_contact(pair, progress);
  if (answer) return None(std::move(answer).take());
  if (without_contact(answer.error())) return None();
  return answer.error();
}

}  // namespace

std::optional<Error> analyse_drive_contact(DriveJob& job, Progress* progress) {
  const Drive& drive = job.drive;
  const Json expanded = expanded_spec(job.spec.tree->tables, *job.spec.drive);
  std::vector<std::optional<ContactView>> found(drive.graph.meshes.size());
  for (std::size_t m = 0; m < found.size(); ++m) {
    if (!drive.geometry.pairs[m] && !drive.geometry.racks[m]) continue;
    auto contact = contact_of_mesh(job, expanded, m, progress);
    if (!contact) return of_mesh(drive, m, contact.error());
    found[m] = std::move(contact).take();
  }
  job.drive.analyses = std::move(found);
  return std::nullopt;
}

Error of_mesh(const Drive& drive, std::size_t mesh, Error error) {
  error.rule = fmt::format("{} (mesh {})", error.rule, printable(drive.graph.meshes[mesh].name));
  return error;
}

}  // namespace gearwright
