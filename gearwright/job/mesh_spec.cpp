#include "gearwright/job/mesh_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/pair_keys.hpp"
#include "gearwright/drive/drive_rating.hpp"

namespace gearwright {

namespace {

// The tables of a drive's spec that also apply to each of its meshes.
constexpr const char* kShared[] = {"errors", "contact", "drawing", "scatter"};

Json gear_table(const DriveJob& job, const Json& expanded, std::size_t gear) {
  Json table = expanded["drive"]["gear"][gear];
  table.erase("name");
  table.erase("body");
  if (job.drive.graph.gears[gear].rack) {  // the pinion of the rack contains the other data
    Json bar = Json::object();
    for (const auto& [key, value] : table.items())
      if (rack_bar_keys().find(key)) bar[key] = value;
    return bar;
  }
  // The addition replaces −0 by 0.
  if (table.contains("helix_angle_deg"))
    table["helix_angle_deg"] = table["helix_angle_deg"].get<double>() + 0.0;
  const auto& solved = job.drive.geometry.gears[gear];
  if (!solved || !solved->involute() || table.contains("basic")) return table;
  table.erase("profile_shift_pair");
  table["profile_shift"] = solved->spec.profile_shift;
  const bool round = solved->spec.root_fillet || solved->spec.tip_fillet;
  if (!round && !table.contains("tip_diameter_mm")) table["tip_diameter_mm"] = solved->tip_diameter;
  return table;
}

// The load of a mesh in the rating of a drive, and the use of its flanks.
struct RatedLoad {
  RatingInput input;
  std::array<FlankUse, 2> use;
};

// The table [rating] for one mesh. Its load is that of one copy of the mesh. Its life and bending are those of
// the gear that engages more often.
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
  if (!rack && drive.graph.friction > 0.0) pair["friction_coefficient"] = drive.graph.friction;
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
  if (spec.contains("load") && drive.flow->driver[mesh] == 1) spec["contact"]["driver"] = 2;

  std::vector<std::string> notes{
      fmt::format("This pair is the mesh {} of the drive. Numbers have all their digits, so that "
                  "the results of the pair and of the drive agree to the last bit.",
                  printable(m.name))};
  if (job.verdict.level == Level::red) notes.push_back(job.verdict.headline);
  if (locks) {
    for (const Warning& w : drive.findings)
      if (w.code == WarningCode::self_locking && notes.back() != w.message) {
        notes.push_back(w.message + " The pair has no load.");
        break;
      }
  }
  if (job.spec.rating.given) {
    const auto load = rating_load(job.spec, drive);
    if (carries && load) {
      const RatedLoad rated{mesh_load(drive, mesh, *load),
                            {flank_use(drive, mesh, 0), flank_use(drive, mesh, 1)}};
      spec["rating"] = rating_table(expanded["rating"], rated);
      if (rated.use[0].engagements != rated.use[1].engagements ||
          rated.use[0].both != rated.use[1].both)
        notes.push_back(fmt::format(
            "The flanks of the gears engage {} and {} times per turn; life_h and reversed of "
            "[rating] are those of the gear with the more severe use.",
            rated.use[0].engagements, rated.use[1].engagements));
      if (expanded["rating"].contains("spectrum"))
        notes.push_back(
            "The spectrum of [rating] is left out, because it applies to the whole drive.");
    } else {
      const char* why = rack      ? "a rack is not rated"
                        : carries ? "the drive has no load"
                                  : "the mesh carries no load";
      notes.push_back(fmt::format("The table [rating] is left out, because {}.", why));
    }
  }
  if (pair.empty()) spec.erase("pair");
  return {std::move(spec), std::move(notes)};
}

}  // namespace gearwright
