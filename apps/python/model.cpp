#include "apps/python/model.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright::python {

namespace {

// The units that a key may name instead of mm and rad, and how many of them one mm or rad is.
struct NamedUnit {
  const char* suffix;
  double per_house;
};
constexpr NamedUnit kNamed[] = {
    {"_mm", 1.0}, {"_deg", kDegPerRad}, {"_um", kUmPerMm}, {"_arcsec", kArcsecPerRad}};

void scale(Json& value, double factor) {
  if (factor == 1.0) return;
  if (value.is_array()) {
    for (Json& v : value) scale(v, factor);
  } else if (value.is_number()) {
    value = value.get<double>() * factor;
  }
}

bool known(const std::vector<const KeyTable*>& tables, const std::string& key) {
  for (const KeyTable* t : tables)
    if (t->find(key)) return true;
  return false;
}

std::vector<const KeyTable*> tables_under(const std::vector<const KeyTable*>& tables,
                                          const std::string& key) {
  std::vector<const KeyTable*> under;
  for (const KeyTable* t : tables)
    if (const Key* k = t->find(key))
      for (const auto table : k->tables) under.push_back(&table());
  return under;
}

}  // namespace

Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, const std::string& path) {
  Json made = Json::object();
  for (auto& [name, value] : tree.items()) {
    std::string key = name;
    if (!known(tables, key)) {
      for (const NamedUnit& unit : kNamed) {
        if (!known(tables, name + unit.suffix)) continue;
        key = name + unit.suffix;
        scale(value, unit.per_house);
        break;
      }
    }
    const std::string here = path.empty() ? key : path + "." + key;
    if (made.contains(key)) raise(Error{here, "", "is given twice, in its unit and in mm or rad"});
    const auto under = tables_under(tables, key);
    if (value.is_object() && !under.empty()) value = with_keys(std::move(value), under, here);
    if (value.is_array() && !under.empty())
      for (Json& v : value)
        if (v.is_object()) v = with_keys(std::move(v), under, here);
    made[key] = std::move(value);
  }
  return made;
}

std::string house_key(const Key& key) {
  for (const NamedUnit& unit : kNamed)
    if (key.key.ends_with(unit.suffix))
      return std::string(key.key.substr(0, key.key.size() - std::string_view(unit.suffix).size()));
  return std::string(key.key);
}

double units_per_house(const Key& key) {
  for (const NamedUnit& unit : kNamed)
    if (key.key.ends_with(unit.suffix)) return unit.per_house;
  return 1.0;
}

Json spec_with_keys(Json tree) {
  return tree.is_object() ? with_keys(std::move(tree), {&spec_keys()}) : tree;
}

void change(Json& tree, const Json& changes) {
  for (const auto& [key, value] : changes.items()) {
    if (value.is_null()) {
      tree.erase(key);
    } else if (value.is_object() && tree.contains(key) && tree[key].is_object()) {
      change(tree[key], value);
    } else {
      tree[key] = value;
    }
  }
}

JobSpec read_tree_of(const Json& spec, const std::filesystem::path& folder) {
  const py::gil_scoped_release free;
  auto read = read_spec(json_text(spec), SpecFormat::json, folder);
  if (read) return std::move(read).take();
  const py::gil_scoped_acquire hold;
  raise(read.error());
}

ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope) {
  JobSpec read = read_tree_of(spec, folder);
  auto solved = [&] {
    const py::gil_scoped_release free;
    return solve(read, scope);
  }();
  if (!solved) raise(spelled(solved.error(), read.given));
  return std::make_shared<const Model>(
      Model{std::move(spec), folder, std::move(read), std::move(solved).take()});
}

void raise(const Error& error, const Model& model) { raise(spelled(error, model.given())); }

Json GearValue::spec() const {
  const std::string table = which == 1 ? "gear1" : "gear2";
  const Json tree = parse_json(model->job.spec.tree);  // with what gear 2 has from gear 1
  Json own = tree.contains(table) ? tree[table] : Json::object();
  const bool followed = model->spec.contains("gear2") && gear().involute() && !gear().cut_by;
  if (followed && !own.contains("profile_shift") && !own.contains("basic"))
    own["profile_shift"] = gear().spec.profile_shift;
  return own;
}

}  // namespace gearwright::python
