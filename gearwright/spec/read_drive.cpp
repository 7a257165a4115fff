#include "gearwright/spec/read_drive.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_gear.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {

namespace {

// Rejects the key double_helical outside the table of a gear. `where` is the reason.
void refuse_halves(const Json& node, const std::string& path, const char* where) {
  if (node.contains("double_helical"))
    throw SpecError{{path + ".double_helical", shown(node["double_helical"]), where}};
}

// True if the backlash in this table of a drive is a band of two numbers.
bool gives_band(const Json& node) {
  const auto backlash = node.find("backlash_mm");
  return backlash != node.end() && backlash->is_array() && backlash->size() == 2;
}

}  // namespace

void check_set_names(const TableReader& t, const Json& node, const PlanetarySpec& set) {
  std::vector<std::string> gears, meshes;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    if (const auto member = static_cast<SetMember>(m); set.z(member) || member == SetMember::planet)
      gears.emplace_back(to_string(member));
  for (const SetMesh& mesh : meshes_of(set)) meshes.push_back(mesh.name);
  const auto check = [&](const std::string& key, const std::vector<std::string>& possible,
                         const std::vector<std::string>& present, const char* what) {
    for (const auto& [part, value] : node[key].items()) {
      const auto in = [&part = part](const std::vector<std::string>& names) {
        return is_in(part, names);
      };
      if (in(possible) && !in(present))
        throw SpecError{{t.name(key) + "." + part, shown(value),
                         fmt::format("is not a {} of this set; the names are {}", what,
                                     fmt::join(present, ", "))}};
    }
  };
  for (const Key& key : planetary_keys().keys) {
    const std::string name(key.key);
    if (!node.contains(name) || !node[name].is_object()) continue;
    if (key.kind == KeyKind::by_name && key.place.names() == PerMesh::names()) {
      check(name, PerMesh::names(), meshes, "mesh");
    } else if (key.kind == KeyKind::by_name || name == "material") {
      check(name, set_member_names(), gears, "gear");
    }
  }
}

void need_speeds(const TableReader& t, const std::vector<double>& speeds_rpm, std::size_t inputs) {
  if (const auto error = check_speeds(speeds_rpm, inputs)) t.fail("speed_rpm", error->rule);
}

PlanetarySpec read_set(const Json& node, const std::string& path) {
  refuse_halves(node, path,
                "is a key of a gear; the command `gearwright drive SPEC --expand` prints the set "
                "as [drive], in which each gear can have this key");
  TableReader t(planetary_keys(), node, path);
  PlanetarySpec set;
  t.read(set);
  set.backlash_is_mean = gives_band(node);
  t.table("material");  // read by spec/drive_tree.cpp
  t.finish();
  check_set_names(t, node, set);
  need_speeds(t, set.speeds_rpm, std::max<std::size_t>(set.inputs.size(), 1));
  return set;
}

namespace {

// Returns the table of the planetary set of a stage. Values that it omits are copied from the table
// of the stage.
Json set_of_stage(TableReader& t, const Json& node) {
  Json set = *t.table("planetary");
  for (const char* key : {"normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg",
                          "face_width_mm", "center_distance_mm", "mesh_efficiency", "bore_mm",
                          "friction_coefficient", "speed_rpm", "material"}) {
    if (node.contains(key) && !set.contains(key)) set[key] = node[key];
  }
  // A quantity can be given by one of several keys. If the set has one of these keys, it inherits
  // none of them. Otherwise it inherits all of them.
  const auto inherit_one_of = [&](std::initializer_list<const char*> keys) {
    if (std::any_of(keys.begin(), keys.end(), [&](auto key) { return set.contains(key); })) return;
    for (const char* key : keys)
      if (node.contains(key)) set[key] = node[key];
  };
  inherit_one_of({"torque_Nm", "power_kW"});
  inherit_one_of({"thickness_allowance_mm", "thickness_series", "backlash_mm"});
  return set;
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
    pair.shifts[i] = gear.given_shift();
    pair.modifications[i] = gear.modifications;
    pair.bores[i] = gear.bore;
    pair.double_helical[i] = gear.double_helical;
    need_whole_face(gear, path);
  }
}

// Reads the bores of a pair. A single number applies to both gears, but not to a ring.
void read_bores(TableReader& t, PairStage& pair) {
  const Json* value = t.any("bore_mm");
  if (!value) return;
  const Json list = value->is_array() ? *value : Json::array({*value});
  const auto is_number = [](const Json& item) { return item.is_number(); };
  if ((value->is_array() && list.size() != 2) || !std::all_of(list.begin(), list.end(), is_number))
    t.fail("bore_mm", "must be a number, or two numbers, one for each gear");
  for (const std::size_t i : {0, 1})
    if (i < list.size() || pair.teeth[i] > 0)
      pair.bores[i] = Bore{t.checked("bore_mm", list[std::min(i, list.size() - 1)])};
}

StageSpec read_stage(const Json& node, const std::string& path, bool is_last,
                     const std::filesystem::path& folder) {
  refuse_halves(node, path,
                "must be in the tables of the gears, for example gears = [{ teeth = 19, "
                "double_helical = { gap_mm = 10 }, ... }, { teeth = 58 }]");
  TableReader t(stage_keys(), node, path);
  for (const Key& key : stage_keys().keys) t.any(std::string(key.key));
  if (t.has("planetary")) {
    t.refuse("angle_deg", "is not used for a planetary set, whose input and output are coaxial");
    StageSpec stage;
    stage.planetary = read_set(set_of_stage(t, node), path + ".planetary");
    t.finish();
    return stage;
  }
  for (const char* key : {"backlash_mm", "mesh_efficiency"})
    if (node.contains(key) && node[key].is_object())
      t.fail(key, "must not be a table, because a pair of gears has one mesh");
  const Json* const gears = t.any("gears");
  if (gears)
    for (const char* key :
         {"teeth", "normal_module_mm", "normal_pressure_angle_deg", "helix_angle_deg",
          "face_width_mm", "profile_shift", "thickness_allowance_mm", "bore_mm", "material"})
      t.refuse(key, "must be in the tables of the gears, because each gear has its own keys");
  constexpr std::size_t kPair = 2;
  if (const Json* teeth = t.any("teeth"); teeth && teeth->is_array() && teeth->size() > kPair)
    t.fail(
        "teeth",
        "must be two numbers, because a stage is one pair of gears; give each pair its own "
        "[[stage]]. The gears of two stages that are on one shaft, as in [18, 30] and [30, 54], "
        "can be a single idler. A gear with two meshes is a [[drive.gear]] in two [[drive.mesh]]");
  StageInput in;
  t.read(in);
  PairStage& pair = in.stage.pair;
  if (gears) {
    read_whole_gears(t, *gears, pair, folder);
  } else {
    if (!t.given("teeth"))
      t.fail_absent("teeth", "; a stage needs two numbers of teeth, for example teeth = [19, 58]");
    read_bores(t, pair);
    if (t.given("normal_module_mm")) pair.set_teeth(in.plain);
  }
  if (const Json* angle = t.any("angle_deg")) {
    pair.coaxial = *angle == "coaxial";
    if (pair.coaxial && !is_last)
      t.fail("angle_deg", "must be a number; only the last stage can be \"coaxial\"");
    if (!pair.coaxial && !angle->is_number())
      t.fail("angle_deg", "must be a number, or \"coaxial\" in the last stage");
    if (!pair.coaxial) pair.direction = Angle::degrees(t.checked("angle_deg", *angle));
  }
  pair.backlash = in.backlash.all;
  pair.backlash_is_mean = gives_band(node);
  pair.efficiency = in.efficiency.all;
  if (pair.backlash && !pair.specs[0])
    t.fail("backlash_mm", "needs normal_module_mm, because there are no teeth without a module");
  pair.set_allowances(in.series);
  t.finish();
  need_speeds(t, in.stage.speeds_rpm, 1);
  return in.stage;
}

// Returns the table of the gear with this name in the graph, "drive.gear[2]" or
// "stage[1].gears[2]". Only these tables have the keys of a gear.
std::string table_of_gear(const Json& tree, const std::string& name) {
  if (tree.contains("drive"))
    for (std::size_t i = 0; i < tree["drive"]["gear"].size(); ++i)
      if (tree["drive"]["gear"][i]["name"] == name) return fmt::format("drive.gear[{}]", i + 1);
  if (tree.contains("stage"))
    for (std::size_t i = 1; i <= tree["stage"].size(); ++i)
      for (const int which : {1, 2})
        if (name == fmt::format("s{}_gear{}", i, which))
          return fmt::format("stage[{}].gears[{}]", i, which);
  contract_failed("precondition", "a gear with its own table", __FILE__, __LINE__);
}

// Returns the entry of [drive] with this name in `list`, which is "mesh" or "body": "drive.mesh[2]".
// The default name of a mesh consists of the names of its gears. Returns none if there is no such
// entry.
std::optional<std::string> entry_of(const Json& tree, const std::string& list,
                                    const std::string& name) {
  if (!tree.contains("drive")) return std::nullopt;
  const Json entries = tree["drive"].value(list, Json::array());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Json& own = entries[i];
    const Json gears = own.value("gears", Json::array());
    const std::string usual =
        gears.size() == 2 ? gears[0].get<std::string>() + "_" + gears[1].get<std::string>() : "";
    if (own.value("name", usual) == name) return fmt::format("drive.{}[{}]", list, i + 1);
  }
  return std::nullopt;
}

// Returns the key of a number of the mesh with this name, "drive.mesh[2].center_distance_mm" or
// "planetary.center_distance_mm.planet_ring".
std::string key_of_mesh(const Json& tree, const std::string& name, const std::string& key) {
  if (const auto entry = entry_of(tree, "mesh", name)) return *entry + "." + key;
  if (!tree.contains("stage")) return fmt::format("planetary.{}.{}", key, name);
  for (std::size_t k = 1; k <= tree["stage"].size(); ++k) {
    const Json& stage = tree["stage"][k - 1];
    const std::string prefix = fmt::format("s{}_", k);
    if (!name.starts_with(prefix) || !stage.contains("planetary")) continue;
    return fmt::format("stage[{}]{}.{}.{}", k, stage["planetary"].contains(key) ? ".planetary" : "",
                       key, name.substr(prefix.size()));
  }
  contract_failed("precondition", "a mesh with its own number", __FILE__, __LINE__);
}

// Replaces "drive.mesh", "drive.body" and "drive.positions" by the entry of the spec that the error
// is about. The value of such an error is the name of the mesh or of the body.
void name_entry(Error& error, const Json& tree) {
  if (error.field.ends_with("drive.positions") && tree.contains("drive")) {
    const Json bodies = tree["drive"].value("body", Json::array());
    const auto placed = [](const Json& body) { return body.contains("positions_deg"); };
    const auto at = std::find_if(bodies.begin(), bodies.end(), placed);
    if (std::count_if(bodies.begin(), bodies.end(), placed) == 1)
      error.field = fmt::format("drive.body[{}].positions_deg", at - bodies.begin() + 1);
    return;
  }
  const bool mesh = error.field.ends_with("drive.mesh");
  const bool name =
      !error.value.empty() && !std::isdigit(static_cast<unsigned char>(error.value[0]));
  if (!name || !(mesh || error.field.ends_with("drive.body"))) return;
  const std::string list = mesh ? "mesh" : "body";
  if (!tree.contains("drive")) {  // the short forms have no entries
    const std::size_t dash = error.value.find('_');
    const bool stage =
        tree.contains("stage") && error.value.starts_with('s') && dash != std::string::npos;
    error.field = stage ? fmt::format("stage[{}]", error.value.substr(1, dash - 1))
                  : tree.contains("planetary") ? "planetary"
                                               : "search";
    error.rule = fmt::format("the {} {}: {}", list, error.value, error.rule);
    error.value.clear();
    return;
  }
  error.field = entry_of(tree, list, error.value).value_or(error.field);
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
  TableReader t(spec_keys(), tree, "");
  if (const Json* set = t.table("planetary"))
    return {taken(graph_of(read_set(*set, "planetary")), tree)};
  if (const Json* graph = t.table("drive")) return {read_graph(*graph, folder)};
  std::vector<StageSpec> stages;
  const auto list = t.tables("stage");
  for (const auto& [path, stage] : list) {
    if (stage != list.front().second && stage->contains("power_kW"))
      TableReader(stage_keys(), *stage, path)
          .fail("power_kW", "must not be given, because the first stage determines this value");
    stages.push_back(read_stage(*stage, path, stage == list.back().second, folder));
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
  constexpr std::string_view kGraph = "drive.", kGear = "drive.gear[\"", kMesh = "drive.mesh[\"";
  if (!error.field.starts_with(kGraph)) return error;
  name_entry(error, tree);
  if (error.field.starts_with(kGear)) {  // as of_drive_gear() makes it
    const std::size_t end = error.field.find("\"].");
    const std::string gear = error.field.substr(kGear.size(), end - kGear.size());
    const SpelledMember own = spelled_member("gear1", error.field.substr(end + 3), error.value);
    return {table_of_gear(tree, gear) + own.key.substr(own.key.find('.')), own.value, error.rule,
            error.kind};
  }
  if (error.field.starts_with(kMesh)) {  // as check_distances() makes it
    const std::size_t end = error.field.find("\"].");
    const std::string mesh = error.field.substr(kMesh.size(), end - kMesh.size());
    return {key_of_mesh(tree, mesh, error.field.substr(end + 3) + "_mm"), error.value, error.rule,
            error.kind};
  }
  for (const std::string own : {"planetary", "stage", "search"})
    if (tree.contains(own) && error.field.starts_with(kGraph))
      return {own + "." + error.field.substr(kGraph.size()), error.value, error.rule, error.kind};
  return error;
}

}  // namespace gearwright
