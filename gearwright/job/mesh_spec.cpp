#include "gearwright/job/mesh_spec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/pair_keys.hpp"
#include "gearwright/drive/drive_rating.hpp"

namespace gearwright {

namespace {

// Tables of a spec of a drive that apply to each of its meshes.
constexpr const char* kShared[] = {"errors", "contact", "drawing", "scatter"};

Json gear_table(const DriveJob& job, const Json& expanded, std::size_t gear) {
  Json table = expanded["drive"]["gear"][gear];
  table.erase("name");
  table.erase("body");
  if (job.drive.graph.gears[gear].rack) {  // its pinion gives the other data
    Json bar = Json::object();
    for (const auto& [key, value] : table.items())
      if (rack_bar_keys().find(key)) bar[key] = value;
    return bar;
  }
  // 0, and not −0.
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

}  // namespace

Json mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh) {
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
  const bool loaded = drive.flow && !drive.flow->self_locking() && drive.flow->driver[mesh] >= 0 &&
                      drive.graph.torque_Nm.value_or(0.0) != 0.0;
  if (loaded && !rack) {
    const RatingInput load = mesh_load(
        drive, mesh,
        {std::abs(*drive.graph.torque_Nm), drive.speed_rpm(drive.graph.inputs.front()), {}});
    if (load.speed) pair["speed_rpm"] = *load.speed;
    spec["load"]["torque_Nm"] = load.torque;
  }
  for (const char* name : kShared)
    if (expanded.contains(name)) spec[name] = expanded[name];
  if (loaded && !rack && drive.flow->driver[mesh] == 1) spec["contact"]["driver"] = 2;
  if (pair.empty()) spec.erase("pair");
  return spec;
}

}  // namespace gearwright
