#include "gearwright/spec/read_drive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_gear.hpp"

namespace gearwright {

namespace {

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
  throw SpecError{{field, fmt::format("\"{}\"", printable(name, 40)),
                   fmt::format("there is no such {}; the known names are {}{}", what,
                               fmt::join(names, ", "), did_you_mean(name, names))}};
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

// Reads the dimensions of the rack body. The data of the teeth are in the table of the pinion.
RackBar read_bar(const Json& node, const std::string& path) {
  Json own = Json::object();
  for (const auto& [key, value] : node.items())
    if (rack_bar_keys().find(key)) own[key] = value;
  TableReader t(rack_bar_keys(), own, path);
  RackBar bar;
  t.read(bar);
  t.finish();
  return bar;
}

void read_graph_gear(const Json& node, const std::string& path, DriveGear& gear,
                     const std::filesystem::path& folder) {
  TableReader own(drive_gear_keys(), node, path);
  if (own.word("form").value_or("gear") == "rack") gear.rack = read_bar(node, path);
  if (!gear.rack && !own.has("teeth"))
    own.fail_absent("teeth", "; give the number of teeth, which is negative for a ring");
  if (!gear.rack)
    own.refuse("height_mm", "is a key of a rack; add form = \"rack\" if the gear is a rack");
  own.refuse_unknown();
  for (const auto& [key, value] : node.items())
    if (gear.rack && key != "name" && key != "body" && !rack_bar_keys().find(key))
      own.refuse(key, std::string(kNotOfRack));
  refuse_in_drive(node, path);
  Json whole = node;
  const auto has_module = has_any(node, drive_gear_keys().ways("normal_module_mm"));
  if (!has_module)
    whole["normal_module_mm"] = 1.0;  // placeholder for read_gear(), because a gear of the graph
                                      // may have no module
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

// Reads the speed and the force of an input that is a rack. The graph stores them as the speed and
// the torque of a body that turns once per pitch.
void read_rack_loads(TableReader& t, DriveGraph& graph) {
  t.refuse("speed_rpm",
           "applies to a body that turns, but the input is a rack; give speed_m_per_s");
  t.refuse("torque_Nm", "applies to a body that turns, but the input is a rack; give force_N");
  const auto pitch = rack_pitch(graph, graph.inputs.front());
  const auto one = [&](const std::string& key) -> std::optional<double> {
    const std::vector<double> values = read_list(t, key);
    if (values.empty()) return std::nullopt;
    if (values.size() > 1) t.fail(key, "must be one number");
    if (!pitch) t.fail(key, "needs the pitch of the rack; give normal_module_mm of its pinion");
    return values.front();
  };
  constexpr double kSecondsPerMinute = 60.0;
  if (const auto v = one("speed_m_per_s"))
    graph.speeds_rpm = {*v * kSecondsPerMinute * kMmPerM / *pitch};
  if (const auto F = one("force_N"))
    graph.torque_Nm = *F * *pitch / kMmPerM / (2 * std::numbers::pi);
}

}  // namespace

std::optional<std::vector<std::string>> read_names(TableReader& t, const std::string& key) {
  return read_values<std::string>(t, key, &Json::is_string,
                                  "must be the name of a body, or a list of names");
}

std::vector<double> read_list(TableReader& t, const std::string& key) {
  constexpr const char* kRule = "must be a number, or a list of numbers";
  const auto list = read_values<double>(t, key, &Json::is_number, kRule);
  if (!list) return {};
  if (list->empty()) t.fail(key, kRule);
  for (const double x : *list) t.checked(key, x);
  return *list;
}

void read_input_loads(TableReader& t, std::vector<double>& speeds, std::optional<double>& torque) {
  speeds = read_list(t, "speed_rpm");
  const std::vector<double> torques = read_list(t, "torque_Nm");
  if (torques.size() > 1)
    t.fail("torque_Nm", "must be one torque, which determines the torques of the other bodies");
  if (!torques.empty()) torque = torques.front();
}

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
  const bool moves = graph.inputs.size() == 1 && graph.moves(graph.inputs.front());
  if (moves) {
    read_rack_loads(t, graph);
  } else {
    for (const char* key : {"speed_m_per_s", "force_N"})
      t.refuse(key, "applies only if the single input is a rack");
    read_input_loads(t, graph.speeds_rpm, graph.torque_Nm);
  }
  t.finish();
  if (graph.inputs.empty()) t.fail_absent("input", "; give the name of the driving body");
  if (output.size() != 1) t.fail_absent("output", "; give the name of the driven body");
  graph.output = output.front();
  return graph;
}

}  // namespace gearwright
