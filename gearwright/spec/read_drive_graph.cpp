#include "gearwright/spec/read_drive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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

std::size_t place_of(const std::vector<std::string>& names, const std::string& name,
                     const std::string& field, const char* what) {
  const auto it = std::find(names.begin(), names.end(), name);
  if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
  if (names.empty())
    throw SpecError{{field, fmt::format("\"{}\"", printable(name, 40)),
                     fmt::format("there is no such {0}, because the drive has none; give every {0} "
                                 "in a table [[drive.{0}]] with its name",
                                 what)}};
  throw SpecError{{field, fmt::format("\"{}\"", printable(name, 40)),
                   fmt::format("there is no such {}; the known names are {}{}", what,
                               fmt::join(names, ", "), did_you_mean(name, names))}};
}

template <class Item>
void check_names(const std::vector<Item>& items, const std::string& table) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name.empty())
      throw SpecError{
          {fmt::format("{}[{}].name", table, i + 1), "\"\"", "must have at least one character"}};
    for (std::size_t k = 0; k < i; ++k)
      if (items[i].name == items[k].name)
        throw SpecError{{fmt::format("{}[{}].name", table, i + 1), printable(items[i].name, 40),
                         "is already the name of another entry"}};
  }
}

std::vector<std::string> add_bodies(const GraphInput& in, DriveGraph& graph) {
  std::vector<std::string> names;
  for (const auto& [body, rides_on] : in.bodies) {
    graph.bodies.push_back(body);
    names.push_back(body.name);
  }
  check_names(graph.bodies, "drive.body");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const std::string& carrier = in.bodies[i].rides_on; !carrier.empty())
      graph.bodies[i].carrier =
          place_of(names, carrier, fmt::format("drive.body[{}].rides_on", i + 1), "body");
  return names;
}

// Reads the dimensions of a rack. The data of its teeth are in the table of the pinion.
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
  for (const char* key : {"height_mm", "length_mm"})
    if (!gear.rack)
      own.refuse(key, "is a key of a rack; add form = \"rack\" if the gear is a rack");
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
  const GearInput given = read_gear(drive_gear_keys(), whole, path, nullptr, folder);
  gear.name = node["name"].get<std::string>();
  gear.teeth = gear.rack ? 0 : given.cylindrical.teeth;
  gear.shift = given.given_shift();
  gear.modifications = given.modifications;
  gear.bore = given.bore;
  gear.double_helical = given.double_helical;
  need_whole_face(given, path);
  if (has_module && !gear.rack) gear.spec = given.cylindrical;
}

void read_gears(TableReader& t, DriveGraph& graph, const std::vector<std::string>& bodies,
                const std::filesystem::path& folder) {
  for (const auto& [path, node] : t.tables("gear")) {
    DriveGear gear;
    read_graph_gear(*node, path, gear, folder);
    gear.body = place_of(bodies, (*node)["body"].get<std::string>(), path + ".body", "body");
    graph.gears.push_back(std::move(gear));
  }
  check_names(graph.gears, "drive.gear");
}

void add_meshes(const GraphInput& in, DriveGraph& graph) {
  std::vector<std::string> gears;
  for (const DriveGear& gear : graph.gears) gears.push_back(gear.name);
  for (const auto& [given, names] : in.meshes) {
    DriveMesh mesh = given;
    for (const std::size_t k : {0, 1})
      mesh.gears[k] = place_of(
          gears, names[k], fmt::format("drive.mesh[{}].gears", graph.meshes.size() + 1), "gear");
    if (mesh.name.empty()) mesh.name = names[0] + "_" + names[1];
    graph.meshes.push_back(std::move(mesh));
  }
  check_names(graph.meshes, "drive.mesh");
}

// Converts the speed and the force of an input that is a rack. The graph stores them as the speed
// and the torque of a body that turns once per pitch.
void set_rack_loads(TableReader& t, const GraphInput& in, DriveGraph& graph) {
  t.refuse("speed_rpm",
           "applies to a body that turns, but the input is a rack; give speed_m_per_s");
  t.refuse("torque_Nm", "applies to a body that turns, but the input is a rack; give force_N");
  const auto pitch = rack_pitch(graph, graph.inputs.front());
  for (const char* key : {"speed_m_per_s", "force_N"})
    if (t.given(key) && !pitch)
      t.fail(key, "needs the pitch of the rack; give normal_module_mm of its pinion");
  if (graph.inputs.size() == 1 && in.force_N.value_or(0.0) * in.speed_m_per_s.value_or(0.0) < 0.0)
    t.fail("force_N",
           "must have the sign of speed_m_per_s, because a single input drives; if the other end "
           "drives, give that body as the input");
  if (in.speed_m_per_s)
    graph.speeds_rpm = {*in.speed_m_per_s * kSecondsPerMinute * kMmPerM / *pitch};
  if (in.force_N) graph.torque_Nm = *in.force_N * *pitch / kMmPerM / (2 * std::numbers::pi);
}

void set_rack_lengths(TableReader& t, DriveGraph& graph) {
  std::size_t g = 0;
  for (const auto& [path, node] : t.tables("gear")) {
    DriveGear& gear = graph.gears[g++];
    TableReader own(drive_gear_keys(), *node, path);
    if (gear.rack) set_rack_length(own, rack_pitch(graph, gear.body), *gear.rack);
  }
}

void refuse_planet_angles(TableReader& t, const DriveGraph& graph) {
  std::size_t m = 0;
  for (const auto& [path, node] : t.tables("mesh")) {
    const DriveMesh& mesh = graph.meshes[m++];
    if (!graph.body(graph.gear(mesh, 0)).carrier && !graph.body(graph.gear(mesh, 1)).carrier)
      continue;
    TableReader(drive_mesh_keys(), *node, path)
        .refuse("angle_deg",
                "is not allowed for planets, whose positions determine the direction; give "
                "positions_deg of the planet");
  }
}

}  // namespace

void set_rack_length(TableReader& t, std::optional<double> pitch, RackBar& bar) {
  constexpr const char* kKey = "length_mm";
  const auto length = t.number(kKey);
  if (!length) return;
  if (!pitch) t.fail(kKey, "needs the pitch of the rack; give normal_module_mm of its pinion");
  constexpr double kMost = 100'000;   // teeth
  constexpr double kRounding = 1e-9;  // pitches; rounding error of the product n p_t
  const double teeth = std::floor(*length / *pitch + kRounding);
  if (teeth < 1 || teeth > kMost)
    t.fail(kKey,
           fmt::format("must be between {} mm and {} mm, the lengths of 1 and of 100 000 teeth",
                       format_number(*pitch), format_number(kMost * *pitch)));
  bar.teeth = static_cast<int>(teeth);
  bar.space = *length;
}

void refuse_in_drive(const Json& node, const std::string& path) {
  const auto refuse = [&](const std::string& key, const char* why) {
    throw SpecError{{path + "." + key, shown(node[key]), why}};
  };
  if (node.contains("measured"))
    refuse("measured", "is allowed only for a gear that is to be identified");
  if (node.contains("cut_by"))
    refuse("cut_by", "is not supported in a drive; compute this mesh as a pair");
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

// Returns the name of the first input. The key `input` can be a list of names.
Json first_input(const Json& node) {
  const Json input = node.value("input", Json());
  return input.is_array() && !input.empty() ? input.front() : input;
}

DriveGraph read_graph(const Json& node, const std::filesystem::path& folder) {
  TableReader t(drive_keys(), node, "drive");
  for (const auto& [path, gear] : t.tables("gear"))
    if (is_rack(*gear) && gear->value("body", Json()) == first_input(node))
      t.refuse("power_kW", "applies to a body that turns, but the input is a rack; give force_N");
  GraphInput in;
  t.read(in);
  DriveGraph graph = in.graph;
  const std::vector<std::string> bodies = add_bodies(in, graph);
  read_gears(t, graph, bodies, folder);
  add_meshes(in, graph);
  set_rack_lengths(t, graph);
  refuse_planet_angles(t, graph);
  const auto places = [&](const char* key, const std::vector<std::string>& names) {
    std::vector<std::size_t> list;
    for (const std::string& name : names)
      list.push_back(place_of(bodies, name, t.name(key), "body"));
    return list;
  };
  graph.fixed = places("fixed", in.fixed);
  graph.inputs = places("input", in.inputs);
  const auto output = places("output", in.output);
  if (graph.inputs.size() == 1 && graph.moves(graph.inputs.front())) {
    set_rack_loads(t, in, graph);
  } else {
    for (const char* key : {"speed_m_per_s", "force_N"})
      t.refuse(key, "applies only if the single input is a rack");
  }
  t.finish();
  if (graph.inputs.empty()) t.fail_absent("input", "; give the name of the driving body");
  if (output.empty()) t.fail_absent("output", "; give the name of the driven body");
  graph.output = output.front();
  need_speeds(t, graph.speeds_rpm, graph.inputs.size());
  return graph;
}

}  // namespace gearwright
