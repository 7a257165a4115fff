// [drive]: the graph that [planetary] or [[stage]] expands to, written as a spec.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

constexpr const char* kSpacings[] = {"nearest", "equal", "equal_clocked", "opposite"};

const char* word(Spacing spacing) { return kSpacings[static_cast<std::size_t>(spacing)]; }

// Degrees as given: 12, not 12° converted to radians and back.
double tidy(Angle angle) {
  const double deg = angle.deg();
  const double rounded = std::round(deg * 1e9) / 1e9;
  return Angle::degrees(rounded).rad() == angle.rad() ? rounded : deg;
}

Json names_of(const DriveGraph& graph, const std::vector<std::size_t>& bodies) {
  Json list = Json::array();
  for (const std::size_t b : bodies) list.push_back(graph.bodies[b].name);
  return list;
}

Json body_of(const DriveGraph& graph, const DriveBody& body) {
  Json j{{"name", body.name}};
  if (!body.carrier) return j;
  j["rides_on"] = graph.bodies[*body.carrier].name;
  j["count"] = body.count;
  if (!body.positions_deg.empty()) j["positions_deg"] = body.positions_deg;
  if (body.spacing) j["spacing"] = word(*body.spacing);
  return j;
}

Json gear_of(const DriveGraph& graph, const DriveGear& gear) {
  Json j{{"name", gear.name}, {"body", graph.body(gear).name}, {"teeth", gear.teeth}};
  if (gear.shift) j["profile_shift"] = *gear.shift;
  if (!gear.spec) return j;
  const CylindricalSpec& spec = *gear.spec;
  j["normal_module_mm"] = spec.normal_module;
  j["normal_pressure_angle_deg"] = tidy(spec.normal_pressure_angle);
  j["helix_angle_deg"] = tidy(spec.helix_angle);
  if (spec.face_width > 0.0) j["face_width_mm"] = spec.face_width;
  if (spec.thickness_allowance != 0.0) j["thickness_allowance_mm"] = spec.thickness_allowance;
  if (spec.tip_diameter) j["tip_diameter_mm"] = *spec.tip_diameter;
  return j;
}

Json mesh_of(const DriveGraph& graph, const DriveMesh& mesh) {
  Json j{{"name", mesh.name}, {"gears", {graph.gear(mesh, 0).name, graph.gear(mesh, 1).name}}};
  if (mesh.center_distance) j["center_distance_mm"] = *mesh.center_distance;
  if (mesh.efficiency) j["efficiency"] = *mesh.efficiency;
  if (mesh.friction) j["friction_coefficient"] = *mesh.friction;
  return j;
}

// The table of a gear that a stage gives in full, with all its keys; null if there is none.
Json whole_gear(const Json& tree, const std::string& name) {
  if (!tree.contains("stage")) return nullptr;
  for (std::size_t k = 0; k < tree["stage"].size(); ++k) {
    const Json& stage = tree["stage"][k];
    if (!stage.contains("gears")) continue;
    const Json both =
        inherit(Json{{"gear1", stage["gears"][0]}, {"gear2", stage["gears"][1]}}).tree;
    for (const char* gear : {"gear1", "gear2"})
      if (name == fmt::format("s{}_{}", k + 1, gear)) return both[gear];
  }
  return nullptr;
}

// The material of a gear of a set, or of a stage with one material for both gears; null for
// that of [rating].
Json material_of_gear(const Json& tree, const std::string& name) {
  const auto in_set = [](const Json& set, const std::string& member) -> Json {
    if (!set.contains("material")) return nullptr;
    const Json& material = set["material"];
    if (material.contains(member)) return material[member];
    const bool by_member = material.contains("sun") || material.contains("planet") ||
                           material.contains("ring") || material.contains("sun2") ||
                           material.contains("planet2") || material.contains("ring2") ||
                           material.contains("idler");
    return by_member ? Json(nullptr) : material;
  };
  if (tree.contains("planetary")) return in_set(tree["planetary"], name);
  if (!tree.contains("stage")) return nullptr;
  for (std::size_t k = 0; k < tree["stage"].size(); ++k) {
    const std::string prefix = fmt::format("s{}_", k + 1);
    if (!name.starts_with(prefix)) continue;
    const Json& stage = tree["stage"][k];
    Json set = stage.contains("planetary") ? stage["planetary"] : stage;
    if (!set.contains("material") && stage.contains("material"))
      set["material"] = stage["material"];
    return in_set(set, name.substr(prefix.size()));
  }
  return nullptr;
}

}  // namespace

Json expanded_spec(const Json& tree, const DriveInput& input) {
  if (tree.contains("drive")) return tree;
  const DriveGraph& graph = input.graph;
  Json drive;
  drive["fixed"] = names_of(graph, graph.fixed);
  drive["input"] = names_of(graph, graph.inputs);
  drive["output"] = graph.bodies[graph.output].name;
  if (!graph.speeds_rpm.empty()) drive["speed_rpm"] = graph.speeds_rpm;
  if (graph.torque_Nm) drive["torque_Nm"] = *graph.torque_Nm;
  drive["friction_coefficient"] = graph.friction;
  drive["spacing"] = word(graph.spacing);
  for (const DriveBody& body : graph.bodies) drive["body"].push_back(body_of(graph, body));
  for (const DriveGear& gear : graph.gears) {
    Json table = gear_of(graph, gear);
    if (const Json whole = whole_gear(tree, gear.name); !whole.is_null()) {
      table.update(whole);
    } else if (const Json material = material_of_gear(tree, gear.name); !material.is_null()) {
      table["material"] = material;
    }
    drive["gear"].push_back(std::move(table));
  }
  for (const DriveMesh& mesh : graph.meshes) drive["mesh"].push_back(mesh_of(graph, mesh));

  Json spec;
  for (const auto& [key, value] : tree.items())
    if (key != "planetary" && key != "stage") spec[key] = value;
  spec["drive"] = std::move(drive);
  return spec;
}

}  // namespace gearwright
