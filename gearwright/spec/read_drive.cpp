#include "gearwright/spec/read_drive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/drive/short_forms.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// Pairs of members that mesh: the name of a mesh consists of the names of its two members.
const std::vector<std::string> kMeshes{"sun_planet",  "sun_idler",   "idler_planet",
                                       "sun2_planet", "planet_ring", "planet_ring2"};

double number_of(const TableReader& t, const std::string& key, const Json& value) {
  if (!value.is_number()) t.fail(key, "must be a number, or a table of numbers by name");
  return value.get<double>();
}

// Reads one number, or a table of numbers by name. `set` receives the index of the name among the known
// names, and the number.
void read_named(TableReader& t, const std::string& key, std::optional<double>& all,
                const std::vector<std::string>& known,
                const std::function<void(std::size_t, double)>& set) {
  const Json* value = t.any(key);
  if (!value) return;
  if (!value->is_object()) {
    all = number_of(t, key, *value);
    return;
  }
  for (const auto& [name, number] : value->items()) {
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end()) {
      throw SpecError{{t.name(key) + "." + printable(name, 40), shown(number),
                       fmt::format("unknown name; the names are {}", fmt::join(known, ", "))}};
    }
    set(static_cast<std::size_t>(it - known.begin()), number_of(t, key, number));
  }
}

void read_members(TableReader& t, const std::string& key, PerMember& to) {
  read_named(t, key, to.all, set_member_names(),
             [&](std::size_t member, double value) { to.each[member] = value; });
}

void read_meshes(TableReader& t, const std::string& key, PerMesh& to) {
  read_named(t, key, to.all, kMeshes,
             [&](std::size_t mesh, double value) { to.each.emplace_back(kMeshes[mesh], value); });
}

void check_efficiencies(const TableReader& t, const PerMesh& meshes) {
  const auto check = [&](double eta) {
    if (!(eta > 0.0 && eta <= 1.0))
      t.fail("mesh_efficiency", "must be greater than 0 and at most 1");
  };
  if (meshes.all) check(*meshes.all);
  for (const auto& [name, eta] : meshes.each) check(eta);
}

// One value or a list of values, or nothing if the key is absent.
template <class T>
std::optional<std::vector<T>> read_values(TableReader& t, const std::string& key,
                                          bool (Json::*is)() const noexcept, const char* rule) {
  const Json* value = t.any(key);
  if (!value) return std::nullopt;
  std::vector<T> values;
  for (const Json& item : value->is_array() ? *value : Json::array({*value})) {
    if (!(item.*is)()) t.fail(key, rule);
    values.push_back(item.get<T>());
  }
  return values;
}

std::optional<std::vector<std::string>> read_names(TableReader& t, const std::string& key) {
  return read_values<std::string>(t, key, &Json::is_string,
                                  "must be the name of a body, or a list of names");
}

std::vector<double> read_list(TableReader& t, const std::string& key) {
  return read_values<double>(t, key, &Json::is_number, "must be a number, or a list of numbers")
      .value_or(std::vector<double>());
}

// Reads the speeds and the torque of the inputs. Only one torque may be given.
void read_input_loads(TableReader& t, std::vector<double>& speeds, std::optional<double>& torque) {
  speeds = read_list(t, "speed_rpm");
  const std::vector<double> torques = read_list(t, "torque_Nm");
  if (torques.size() > 1)
    t.fail("torque_Nm", "must be one torque, which determines the torques of the other bodies");
  if (!torques.empty()) torque = torques.front();
}

// Rejects the key double_helical outside the table of a gear. `where` is the reason.
void refuse_halves(const Json& node, const std::string& path, const char* where) {
  if (node.contains("double_helical"))
    throw SpecError{{path + ".double_helical", shown(node["double_helical"]), where}};
}

}  // namespace

PlanetarySpec read_set(const Json& node, const std::string& path) {
  refuse_halves(node, path,
                "is a key of a gear; gearwright drive SPEC --expand prints the set as [drive], in "
                "which each gear can have this key");
  TableReader t(planetary_keys(), node, path);
  PlanetarySpec set;
  t.read(set);
  read_members(t, "helix_angle_deg", set.helix_deg);
  read_members(t, "profile_shift", set.profile_shift);
  read_members(t, "thickness_allowance_mm", set.allowance);
  read_members(t, "face_width_mm", set.face_width);
  read_members(t, "tip_diameter_mm", set.tip_diameter);
  read_meshes(t, "center_distance_mm", set.center_distance);
  read_meshes(t, "mesh_efficiency", set.efficiency);
  check_efficiencies(t, set.efficiency);
  set.fixed = read_names(t, "fixed");
  set.inputs = read_names(t, "input").value_or(std::vector<std::string>());
  read_input_loads(t, set.speeds_rpm, set.torque_Nm);
  t.table("material");  // spec/drive_tree.cpp
  t.finish();
  return set;
}

namespace {

// Copies the numbers that the table of a stage gives and the table of its set omits.
Json set_of_stage(TableReader& t, const Json& node) {
  Json set = *t.table("planetary");
  for (const char* key :
       {"normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg", "face_width_mm",
        "center_distance_mm", "mesh_efficiency", "thickness_allowance_mm", "friction_coefficient",
        "speed_rpm", "torque_Nm", "material"}) {
    if (node.contains(key) && !set.contains(key)) set[key] = node[key];
  }
  return set;
}

std::array<std::optional<double>, 2> read_two(TableReader& t, const std::string& key) {
  const std::vector<double> list = read_list(t, key);
  if (list.empty()) return {};
  if (list.size() > 2) t.fail(key, "must be a number, or two numbers, one for each gear");
  return {list.front(), list.back()};
}

// Rejects keys that apply to a single gear but not to a drive.
void refuse_in_drive(const Json& node, const std::string& path) {
  const auto refuse = [&](const std::string& key, const char* why) {
    throw SpecError{{path + "." + key, shown(node[key]), why}};
  };
  if (node.contains("measured"))
    refuse("measured", "is allowed only for a gear that is to be identified");
  if (node.contains("tip_fillet"))
    refuse("tip_fillet", "is not supported in a drive; compute this mesh as a pair");
  if (!node.contains("tolerance") || !node["tolerance"].is_object()) return;
  for (const char* key : {"thickness_series", "span_mm", "over_balls_mm"})
    if (node["tolerance"].contains(key))
      throw SpecError{{path + ".tolerance." + key, shown(node["tolerance"][key]),
                       "is not supported in a drive; give thickness_allowance_mm"}};
}

void need_whole_face(const GearInput& gear, const std::string& path) {
  if (gear.double_helical && !gear.face_width_given)
    throw SpecError{absent_input(path + ".face_width_mm", kWholeFace)};
}

void read_whole_gears(TableReader& t, const Json& gears, PairStage& pair,
                      const std::filesystem::path& folder) {
  const bool two =
      gears.is_array() && gears.size() == 2 && gears[0].is_object() && gears[1].is_object();
  if (!two) t.fail("gears", "must be a list of two tables with the keys of [gear1]");
  // The second gear of the stage inherits from the first in the same way as gear 2 from gear 1.
  const Json both = inherit(Json{{"gear1", gears[0]}, {"gear2", gears[1]}}).tree;
  for (const std::size_t i : {0, 1}) {
    const std::string name = i == 0 ? "gear1" : "gear2";
    const std::string path = fmt::format("{}[{}]", t.name("gears"), i + 1);
    refuse_in_drive(both[name], path);
    const GearInput gear = read_gear(stage_gear_keys(), both[name], path, nullptr, folder);
    pair.teeth[i] = gear.cylindrical.teeth;
    pair.specs[i] = gear.cylindrical;
    pair.shifts[i] = gear.profile_shift;
    pair.modifications[i] = gear.modifications;
    pair.bores[i] = gear.bore;
    pair.double_helical[i] = gear.double_helical;
    need_whole_face(gear, path);
  }
}

void read_teeth(TableReader& t, PairStage& pair) {
  const std::vector<double> teeth = read_list(t, "teeth");
  const auto whole = [](double z) { return z == std::round(z) && z != 0.0 && std::abs(z) <= 1e5; };
  if (teeth.empty())
    t.fail_absent("teeth", "; a stage needs two numbers of teeth, for example teeth = [19, 58]");
  if (teeth.size() != 2 || !std::all_of(teeth.begin(), teeth.end(), whole) || teeth[0] < 0)
    t.fail("teeth", "must be two whole numbers; the second number is negative for a ring");
  pair.teeth = {static_cast<int>(teeth[0]), static_cast<int>(teeth[1])};
  pair.shifts = read_two(t, "profile_shift");
  const auto module = t.number("normal_module_mm");
  const auto alpha = t.number("normal_pressure_angle_deg");
  const double beta = t.number("helix_angle_deg").value_or(0.0);
  const auto face = t.number("face_width_mm");
  const auto allowance = read_two(t, "thickness_allowance_mm");
  if (!module) return;
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = pair.teeth[i];
    spec.normal_module = *module;
    spec.normal_pressure_angle = Angle::degrees(alpha.value_or(20.0));
    spec.helix_angle = Angle::degrees(i == 0 || pair.teeth[1] < 0 ? beta : -beta);
    spec.face_width = face.value_or(10 * *module);
    spec.thickness_allowance = allowance[i].value_or(0.0);
    pair.specs[i] = spec;
  }
}

StageSpec read_stage(const Json& node, const std::string& path,
                     const std::filesystem::path& folder) {
  refuse_halves(node, path,
                "must be in the tables of the gears, for example gears = [{ teeth = 19, "
                "double_helical = { gap_mm = 10 }, ... }, { teeth = 58 }]");
  TableReader t(stage_keys(), node, path);
  StageSpec stage;
  if (t.has("planetary")) {
    stage.planetary = read_set(set_of_stage(t, node), path + ".planetary");
    for (const Key& key : stage_keys().keys) t.any(std::string(key.key));
    t.finish();
    return stage;
  }
  const Json* gears = t.any("gears");
  if (gears) {
    for (const char* key :
         {"teeth", "normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg",
          "face_width_mm", "profile_shift", "thickness_allowance_mm", "material"})
      t.refuse(key, "must be in the tables of the gears, because each gear has its own keys");
    read_whole_gears(t, *gears, stage.pair, folder);
  } else {
    read_teeth(t, stage.pair);
  }
  stage.pair.center_distance = t.number("center_distance_mm");
  stage.friction = t.number("friction_coefficient").value_or(stage.friction);
  read_input_loads(t, stage.speeds_rpm, stage.torque_Nm);
  const auto eta = read_list(t, "mesh_efficiency");
  if (!eta.empty()) {
    PerMesh meshes{eta.front(), {}};
    check_efficiencies(t, meshes);
    stage.pair.efficiency = eta.front();
  }
  for (const Key& key : stage_keys().keys) t.any(std::string(key.key));
  t.finish();
  return stage;
}

// An element of a list of tables, with its path in the spec.
struct ListedTable {
  std::string path;
  const Json& node;
};

std::vector<ListedTable> list_of(TableReader& t, const std::string& key) {
  std::vector<ListedTable> list;
  const Json* value = t.any(key);
  if (!value) return list;
  const bool tables = value->is_array() && std::all_of(value->begin(), value->end(),
                                                       [](const Json& i) { return i.is_object(); });
  if (!tables) t.fail(key, fmt::format("must be a list of tables, [[{}]]", t.name(key)));
  for (const Json& node : *value)
    list.push_back({fmt::format("{}[{}]", t.name(key), list.size() + 1), node});
  return list;
}

std::size_t place_of(const std::vector<std::string>& names, const std::string& name,
                     const std::string& field, const char* what) {
  const auto it = std::find(names.begin(), names.end(), name);
  if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
  throw SpecError{
      {field, printable(name, 40),
       fmt::format("there is no such {}; the known names are {}", what, fmt::join(names, ", "))}};
}

std::string text_at(TableReader& t, const std::string& key) {
  const Json* value = t.any(key);
  if (!value || !value->is_string()) t.fail(key, "must be a name");
  return value->get<std::string>();
}

template <class Item>
void check_names(const std::vector<Item>& items, const std::string& table) {
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (items[i].name == items[k].name)
        throw SpecError{{fmt::format("{}[{}].name", table, i + 1), printable(items[i].name, 40),
                         "is already the name of another entry"}};
}

void read_bodies(TableReader& t, DriveGraph& graph, std::vector<std::string>& names) {
  const std::vector<ListedTable> list = list_of(t, "body");
  for (const auto& [path, node] : list) {
    TableReader body(drive_body_keys(), node, path);
    graph.bodies.emplace_back();
    body.read(graph.bodies.back());
    body.any("rides_on");
    body.finish();
    names.push_back(graph.bodies.back().name);
  }
  check_names(graph.bodies, t.name("body"));
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].node.contains("rides_on")) continue;
    TableReader body(drive_body_keys(), list[i].node, list[i].path);
    graph.bodies[i].carrier =
        place_of(names, text_at(body, "rides_on"), body.name("rides_on"), "body");
  }
}

void read_graph_gear(const Json& node, const std::string& path, DriveGear& gear,
                     const std::filesystem::path& folder) {
  TableReader own(drive_gear_keys(), node, path);
  gear.rack = own.word("form").value_or("gear") == "rack";
  if (!gear.rack && !own.has("teeth"))
    own.fail_absent("teeth", "; give the number of teeth, which is negative for a ring");
  if (!gear.rack)
    own.refuse("height_mm", "is a key of a rack; add form = \"rack\" if the gear is a rack");
  refuse_in_drive(node, path);
  Json whole = node;
  const auto has_module = has_any(node, drive_gear_keys().ways("normal_module_mm"));
  if (!has_module)
    whole["normal_module_mm"] = 1.0;  // numbers of teeth alone do not determine a size
  if (!own.has("teeth")) whole["teeth"] = 1;
  const GearInput given = read_gear(drive_gear_keys(), whole, path, nullptr, folder);
  gear.name = node["name"].get<std::string>();
  gear.teeth = gear.rack ? 0 : given.cylindrical.teeth;
  gear.shift = given.profile_shift;
  gear.modifications = given.modifications;
  gear.bore = given.bore;
  gear.double_helical = given.double_helical;
  need_whole_face(given, path);
  if (has_module && !gear.rack) gear.spec = given.cylindrical;
}

void read_gears(TableReader& t, DriveGraph& graph, const std::vector<std::string>& bodies,
                const std::filesystem::path& folder) {
  for (const auto& [path, node] : list_of(t, "gear")) {
    DriveGear gear;
    read_graph_gear(node, path, gear, folder);
    gear.body = place_of(bodies, node["body"].get<std::string>(), path + ".body", "body");
    graph.gears.push_back(std::move(gear));
  }
  check_names(graph.gears, t.name("gear"));
}

void read_graph_meshes(TableReader& t, DriveGraph& graph) {
  std::vector<std::string> gears;
  for (const DriveGear& gear : graph.gears) gears.push_back(gear.name);
  for (const auto& [path, node] : list_of(t, "mesh")) {
    TableReader m(drive_mesh_keys(), node, path);
    DriveMesh mesh;
    m.read(mesh);
    const auto two = read_names(m, "gears");
    m.finish();
    if (!two || two->size() != 2) m.fail("gears", "must be the names of two gears");
    for (const std::size_t k : {0, 1})
      mesh.gears[k] = place_of(gears, (*two)[k], m.name("gears"), "gear");
    if (mesh.name.empty()) mesh.name = (*two)[0] + "_" + (*two)[1];
    graph.meshes.push_back(std::move(mesh));
  }
  check_names(graph.meshes, t.name("mesh"));
}

DriveGraph read_graph(const Json& node, const std::filesystem::path& folder) {
  TableReader t(drive_keys(), node, "drive");
  DriveGraph graph;
  t.read(graph);
  std::vector<std::string> bodies;
  read_bodies(t, graph, bodies);
  read_gears(t, graph, bodies, folder);
  read_graph_meshes(t, graph);
  const auto places = [&](const std::string& key) {
    std::vector<std::size_t> list;
    for (const std::string& name : read_names(t, key).value_or(std::vector<std::string>()))
      list.push_back(place_of(bodies, name, t.name(key), "body"));
    return list;
  };
  graph.fixed = places("fixed");
  graph.inputs = places("input");
  const auto output = places("output");
  read_input_loads(t, graph.speeds_rpm, graph.torque_Nm);
  t.finish();
  if (graph.inputs.empty()) t.fail_absent("input", "; give the name of the driving body");
  if (output.size() != 1) t.fail_absent("output", "; give the name of the driven body");
  graph.output = output.front();
  return graph;
}

template <class T>
T taken(Result<T> made, const Json& tree) {
  if (!made) throw SpecError{spelled(of_drive_table(made.error(), tree))};
  return std::move(made).take();
}

}  // namespace

bool is_drive(const Json& tree) { return has_any(tree, {"planetary", "stage", "drive"}); }

DriveInput read_drive(const Json& tree, const std::filesystem::path& folder) {
  drive_materials(tree);  // read here only to report errors; a rating reads the materials again
  const char* first = nullptr;
  for (const char* table : {"planetary", "stage", "drive"}) {
    if (!tree.contains(table)) continue;
    if (first)
      throw SpecError{
          {table, "", fmt::format("only one drive is allowed, and the spec has [{}]", first)}};
    first = table;
  }
  for (const char* table : {"planetary", "drive"})
    if (tree.contains(table) && !tree[table].is_object())
      throw SpecError{{table, shown(tree[table]), fmt::format("must be a table, [{}]", table)}};
  if (tree.contains("planetary"))
    return {taken(graph_of(read_set(tree["planetary"], "planetary")), tree)};
  if (tree.contains("drive")) return {read_graph(tree["drive"], folder)};
  std::vector<StageSpec> stages;
  const Json& list = tree["stage"];
  if (!list.is_array() || list.empty())
    throw SpecError{{"stage", shown(list), "must be a list of tables, [[stage]]"}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string path = fmt::format("stage[{}]", i + 1);
    if (!list[i].is_object()) throw SpecError{{path, shown(list[i]), "must be a table, [[stage]]"}};
    stages.push_back(read_stage(list[i], path, folder));
  }
  return taken(train_of(stages), tree);
}

Error of_drive_table(Error error, const Json& tree) {
  constexpr std::string_view kGraph = "drive.";
  if (error.field.starts_with(kGraph) && !tree.contains("drive")) {
    const char* own = tree.contains("planetary") ? "planetary" : "stage";
    error.field = std::string(own) + "." + error.field.substr(kGraph.size());
  }
  return error;
}

}  // namespace gearwright
