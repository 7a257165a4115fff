#include "gearwright/spec/read_drive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

namespace {

// The names of meshes. Each name consists of the names of the two members that mesh.
const std::vector<std::string> kMeshes{"sun_planet",  "sun_idler",   "idler_planet",
                                       "sun2_planet", "planet_ring", "planet_ring2"};

// Reads one number, or a table of numbers by name. `set` receives the index of the name among the
// known names, and the number.
void read_named(TableReader& t, const std::string& key, std::optional<double>& all,
                const std::vector<std::string>& known,
                const std::function<void(std::size_t, double)>& set) {
  const Json* value = t.any(key);
  if (!value) return;
  if (!value->is_object()) {
    if (!value->is_number()) t.fail(key, "must be a number, or a table of numbers by name");
    all = t.checked(key, *value);
    return;
  }
  for (const auto& [name, number] : value->items()) {
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end()) {
      throw SpecError{{t.name(key) + "." + printable(name, 40), shown(number),
                       fmt::format("unknown name; the names are {}", fmt::join(known, ", "))}};
    }
    set(static_cast<std::size_t>(it - known.begin()), t.checked(key, number, name));
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

// Reads the series and the backlash, which replace the thickness allowances. A band of the
// backlash is replaced by its mean. A table with one backlash for each mesh is left to the
// caller.
void read_play(TableReader& t, std::string& series, std::optional<double>& backlash) {
  series = t.text("thickness_series").value_or("");
  check_series(t, series);
  const Json* value = t.any("backlash_mm");
  if (!value || value->is_object()) return;
  const std::vector<double> band = read_list(t, "backlash_mm");
  if (band.size() > 2 || band.front() > band.back())
    t.fail("backlash_mm", "must be a number, or a band of two numbers in rising order");
  backlash = (band.front() + band.back()) / 2;
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
  read_members(t, "bore_mm", set.bore);
  read_meshes(t, "center_distance_mm", set.center_distance);
  read_meshes(t, "mesh_efficiency", set.efficiency);
  read_play(t, set.series, set.backlash.all);
  if (t.has("backlash_mm") && node["backlash_mm"].is_object())
    read_meshes(t, "backlash_mm", set.backlash);
  set.fixed = read_names(t, "fixed");
  set.inputs = read_names(t, "input").value_or(std::vector<std::string>());
  read_input_loads(t, set.speeds_rpm, set.torque_Nm);
  t.table("material");  // read by spec/drive_tree.cpp
  t.finish();
  return set;
}

namespace {

// The table of the planetary set of a stage. Values that it omits are copied from the table of the
// stage.
Json set_of_stage(TableReader& t, const Json& node) {
  Json set = *t.table("planetary");
  for (const char* key : {"normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg",
                          "face_width_mm", "center_distance_mm", "mesh_efficiency", "bore_mm",
                          "friction_coefficient", "speed_rpm", "torque_Nm", "material"}) {
    if (node.contains(key) && !set.contains(key)) set[key] = node[key];
  }
  constexpr std::array kPlay{"thickness_allowance_mm", "thickness_series", "backlash_mm"};
  if (std::none_of(kPlay.begin(), kPlay.end(), [&](auto key) { return set.contains(key); }))
    for (const char* key : kPlay)
      if (node.contains(key)) set[key] = node[key];
  return set;
}

std::array<std::optional<double>, 2> read_two(TableReader& t, const std::string& key) {
  const std::vector<double> list = read_list(t, key);
  if (list.empty()) return {};
  if (list.size() > 2) t.fail(key, "must be a number, or two numbers, one for each gear");
  return {list.front(), list.back()};
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
  auto bore = read_two(t, "bore_mm");
  if (pair.teeth[1] < 0 && read_list(t, "bore_mm").size() < 2) bore[1].reset();
  for (const std::size_t i : {0, 1})
    if (bore[i]) pair.bores[i] = Bore{*bore[i]};
  if (module)
    pair.set_teeth({*module, Angle::degrees(alpha.value_or(20.0)), beta, face, allowance});
}

StageSpec read_stage(const Json& node, const std::string& path, bool is_last,
                     const std::filesystem::path& folder) {
  refuse_halves(node, path,
                "must be in the tables of the gears, for example gears = [{ teeth = 19, "
                "double_helical = { gap_mm = 10 }, ... }, { teeth = 58 }]");
  TableReader t(stage_keys(), node, path);
  StageSpec stage;
  if (t.has("planetary")) {
    t.refuse("angle_deg", "is not used for a planetary set, whose input and output are coaxial");
    stage.planetary = read_set(set_of_stage(t, node), path + ".planetary");
    for (const Key& key : stage_keys().keys) t.any(std::string(key.key));
    t.finish();
    return stage;
  }
  const Json* gears = t.any("gears");
  if (gears) {
    for (const char* key :
         {"teeth", "normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg",
          "face_width_mm", "profile_shift", "thickness_allowance_mm", "bore_mm", "material"})
      t.refuse(key, "must be in the tables of the gears, because each gear has its own keys");
    read_whole_gears(t, *gears, stage.pair, folder);
  } else {
    read_teeth(t, stage.pair);
  }
  stage.pair.center_distance = t.number("center_distance_mm");
  if (const Json* angle = t.any("angle_deg")) {
    stage.pair.coaxial = *angle == "coaxial";
    if (stage.pair.coaxial && !is_last)
      t.fail("angle_deg", "must be a number; only the last stage can be \"coaxial\"");
    if (!stage.pair.coaxial && !angle->is_number())
      t.fail("angle_deg", "must be a number, or \"coaxial\" in the last stage");
    if (!stage.pair.coaxial) stage.pair.direction = Angle::degrees(t.checked("angle_deg", *angle));
  }
  std::string series;
  read_play(t, series, stage.pair.backlash);
  if (const Json* value = t.any("backlash_mm"); value && value->is_object())
    t.fail("backlash_mm",
           "must be a number, or a band of two numbers, because a pair of gears has one mesh");
  if (stage.pair.backlash && !stage.pair.specs[0])
    t.fail("backlash_mm", "needs normal_module_mm, because there are no teeth without a module");
  stage.pair.set_allowances(series);
  stage.friction = t.number("friction_coefficient").value_or(stage.friction);
  read_input_loads(t, stage.speeds_rpm, stage.torque_Nm);
  const auto eta = read_list(t, "mesh_efficiency");
  if (!eta.empty()) stage.pair.efficiency = eta.front();
  for (const Key& key : stage_keys().keys) t.any(std::string(key.key));
  t.finish();
  return stage;
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
          {table, "",
           fmt::format("cannot be combined with [{}], because a spec describes only one drive",
                       first)}};
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
    stages.push_back(read_stage(list[i], path, i + 1 == list.size(), folder));
  }
  return taken(train_of(stages), tree);
}

MeshLoadFactors read_mesh_load_factors(const Json& tree) {
  constexpr const char* kKey = "mesh_load_factor";
  MeshLoadFactors factors;
  if (!tree.contains("rating") || !tree["rating"].contains(kKey)) return factors;
  const Json& value = tree["rating"][kKey];
  const TableReader t(rating_keys(), tree["rating"], "rating");
  factors.computed = value == "computed";
  if (value.is_number()) {
    factors.given.all = value.get<double>();
  } else if (value.is_object() && !value.empty()) {
    for (const auto& [mesh, factor] : value.items())
      factors.given.each.emplace_back(mesh, t.checked(kKey, factor, mesh));
  } else if (!factors.computed) {
    t.fail(kKey,
           "must be a number, a table of numbers by mesh such as { sun_planet = 1.2 }, or "
           "\"computed\"");
  }
  if (!factors.given.all && !is_drive(tree) && !is_drive_search(tree.value("search", Json())))
    t.fail(kKey, "must be a number for a pair, which has one mesh");
  return factors;
}

Error of_drive_table(Error error, const Json& tree) {
  constexpr std::string_view kGraph = "drive.";
  if (!error.field.starts_with(kGraph)) return error;
  for (const std::string own : {"planetary", "stage", "search"})
    if (tree.contains(own))
      return {own + "." + error.field.substr(kGraph.size()), error.value, error.rule, error.kind};
  return error;
}

}  // namespace gearwright
