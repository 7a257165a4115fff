// Functions for the tree of the spec of a drive. They read the materials of the gears, copy the
// speed of the input to [rating], and replace [planetary] or [[stage]] by a table [drive].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// A function that is called for each material. Its arguments are the name of a gear in the graph,
// the key of the material and the table of the material.
using MaterialVisit =
    std::function<void(const std::string& gear, const std::string& key, const Json& material)>;

void visit_material(const Json& owner, const std::string& path,
                    const std::vector<std::string>& gears, const MaterialVisit& visit) {
  if (!owner.is_object() || !owner.contains("material")) return;
  const Json& node = owner["material"];
  const std::string key = path + ".material";
  if (!node.is_object())
    throw SpecError{{key, shown(node), fmt::format("must be a table, [{}]", key)}};
  for (const std::string& gear : gears) visit(gear, key, node);
}

// Visits the material of each member of a set. `material` is either a table of materials by member,
// or one material for all members.
void visit_set(const Json& set, const std::string& path, const std::string& prefix,
               const MaterialVisit& visit) {
  if (!set.is_object() || !set.contains("material")) return;
  const Json& node = set["material"];
  const std::vector<std::string> names = set_member_names();
  const auto named = [&](const auto& item) { return is_in(item.key(), names); };
  const auto items = node.items();
  if (node.is_object() && !node.empty() && std::all_of(items.begin(), items.end(), named)) {
    for (const auto& [member, material] : items)
      visit_material(Json{{"material", material}}, path + ".material." + member, {prefix + member},
                     visit);
    return;
  }
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(prefix + name);
  visit_material(set, path, all, visit);
}

void visit_stage(const Json& stage, const std::string& path, const std::string& prefix,
                 const MaterialVisit& visit) {
  if (!stage.is_object()) return;
  if (stage.contains("planetary")) {
    visit_set(stage, path, prefix, visit);
    visit_set(stage["planetary"], path + ".planetary", prefix, visit);
    return;
  }
  visit_material(stage, path, {prefix + "gear1", prefix + "gear2"}, visit);
  if (!stage.contains("gears") || !stage["gears"].is_array() || stage["gears"].size() != 2) return;
  const Json both = inherit(Json{{"gear1", stage["gears"][0]}, {"gear2", stage["gears"][1]}}).tree;
  for (const std::string gear : {"gear1", "gear2"})
    visit_material(both[gear], fmt::format("{}.gears[{}]", path, gear.back()), {prefix + gear},
                   visit);
}

// Visits every gear for which its own table or the table of its stage or set has a material. If a
// gear is visited again, the later visit takes precedence.
void visit_materials(const Json& tree, const MaterialVisit& visit) {
  if (tree.contains("planetary")) visit_set(tree["planetary"], "planetary", "", visit);
  if (tree.contains("stage") && tree["stage"].is_array())
    for (std::size_t i = 0; i < tree["stage"].size(); ++i)
      visit_stage(tree["stage"][i], fmt::format("stage[{}]", i + 1), fmt::format("s{}_", i + 1),
                  visit);
  if (const Json search = tree.value("search", Json()); is_drive_search(search)) {
    if (search["kind"] != "train") visit_set(search, "search", "", visit);
    for (int k = 1; search["kind"] == "train" && k <= kMostStages; ++k)
      visit_stage(search, "search", fmt::format("s{}_", k), visit);
  }
  if (tree.contains("drive") && tree["drive"].is_object() && tree["drive"].contains("gear") &&
      tree["drive"]["gear"].is_array())
    for (std::size_t i = 0; i < tree["drive"]["gear"].size(); ++i) {
      const Json& gear = tree["drive"]["gear"][i];
      if (!gear.is_object() || !gear.contains("name") || !gear["name"].is_string()) continue;
      visit_material(gear, fmt::format("drive.gear[{}]", i + 1), {gear["name"].get<std::string>()},
                     visit);
    }
}

// Returns the table that contains the speed of the input, or null if there is no such table.
const Json* input_table(const Json& tree) {
  const auto table = [](const Json& owner, const char* key) -> const Json* {
    const auto it = owner.find(key);
    return it != owner.end() && it->is_object() ? &*it : nullptr;
  };
  for (const char* key : {"planetary", "drive", "search"})
    if (const Json* own = table(tree, key)) return own;
  const auto stages = tree.find("stage");
  if (stages == tree.end() || !stages->is_array() || stages->empty() ||
      !stages->front().is_object())
    return nullptr;
  const Json* set = table(stages->front(), "planetary");
  return set && set->contains("speed_rpm") ? set : &stages->front();
}

std::string_view word(Spacing spacing) {
  return planetary_keys().find("spacing")->words[static_cast<std::size_t>(spacing)];
}

// Returns the angle in degrees, rounded so that the conversion from radians leaves no rounding
// error. For example, the result is 12 and not 12.000000000000002.
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
  if (body.side != IdlerSide::counter_clockwise)
    j["idler_side"] =
        drive_body_keys().find("idler_side")->words[static_cast<std::size_t>(body.side)];
  return j;
}

Json gear_of(const DriveGraph& graph, const DriveGear& gear) {
  Json j{{"name", gear.name}, {"body", graph.body(gear).name}, {"teeth", gear.teeth}};
  if (gear.shift) j["profile_shift"] = *gear.shift;
  if (!gear.spec) return j;
  const CylindricalSpec& spec = *gear.spec;
  j["normal_module_mm"] = spec.normal_module;
  // A rack of arcs has the pressure angle in its own table.
  if (is_straight(spec.rack)) j["normal_pressure_angle_deg"] = tidy(spec.normal_pressure_angle);
  j["helix_angle_deg"] = tidy(spec.helix_angle);
  if (spec.face_width > 0.0) j["face_width_mm"] = spec.face_width;
  if (spec.thickness_allowance != 0.0) j["thickness_allowance_mm"] = spec.thickness_allowance;
  if (spec.tip_diameter) j["tip_diameter_mm"] = *spec.tip_diameter;
  if (gear.bore) j["bore"]["diameter_mm"] = gear.bore->diameter;
  return j;
}

Json mesh_of(const DriveGraph& graph, const DriveMesh& mesh) {
  Json j{{"name", mesh.name}, {"gears", {graph.gear(mesh, 0).name, graph.gear(mesh, 1).name}}};
  if (mesh.center_distance) j["center_distance_mm"] = *mesh.center_distance;
  if (mesh.efficiency) j["efficiency"] = *mesh.efficiency;
  if (mesh.friction) j["friction_coefficient"] = *mesh.friction;
  if (mesh.backlash) j["backlash_mm"] = *mesh.backlash;
  if (mesh.direction) j["angle_deg"] = mesh.direction->deg();
  return j;
}

// Returns the table with all keys of the gear, from the list `gears` of its stage. Returns null if
// no such list contains the gear.
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

}  // namespace

std::map<std::string, MaterialInput> drive_materials(const Json& tree) {
  std::map<std::string, MaterialInput> materials;
  visit_materials(tree, [&](const std::string& gear, const std::string& key, const Json& node) {
    materials[gear] = read_table<MaterialInput>(material_keys(), node, key);
  });
  return materials;
}

void lend_speed(Json& tree) {
  const Json* input = input_table(tree);
  if (!input || !input->contains("speed_rpm") || !tree.contains("rating")) return;
  const Json& given = (*input)["speed_rpm"];
  const Json& first = given.is_array() && !given.empty() ? given.front() : given;
  Json& rating = tree["rating"];
  if (!first.is_number() || first == 0.0 || !rating.is_object() || rating.contains("speed_rpm"))
    return;
  rating["speed_rpm"] = std::abs(first.get<double>());
}

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
  std::map<std::string, Json> materials;
  visit_materials(tree, [&](const std::string& gear, const std::string&, const Json& node) {
    materials[gear] = node;
  });
  for (const DriveBody& body : graph.bodies) drive["body"].push_back(body_of(graph, body));
  for (const DriveGear& gear : graph.gears) {
    Json table = gear_of(graph, gear);
    if (const Json whole = whole_gear(tree, gear.name); !whole.is_null()) {
      table.update(whole);
    } else if (const auto own = materials.find(gear.name); own != materials.end()) {
      table["material"] = own->second;
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
