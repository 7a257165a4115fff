#include "apps/python/model.hpp"

#include <algorithm>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::python {

namespace {

// Units that a key may name, with the number of units in one mm or rad.
struct NamedUnit {
  std::string_view suffix;
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

bool has(const std::vector<const KeyTable*>& tables, const std::string& key) {
  return std::any_of(tables.begin(), tables.end(),
                     [&](const KeyTable* table) { return table->find(key) != nullptr; });
}

std::vector<const KeyTable*> tables_under(const std::vector<const KeyTable*>& tables,
                                          const std::string& key) {
  std::vector<const KeyTable*> under;
  for (const KeyTable* t : tables)
    if (const Key* k = t->find(key))
      for (const auto table : k->tables) under.push_back(&table());
  return under;
}

const NamedUnit* unit_of(std::string_view key) {
  for (const NamedUnit& unit : kNamed)
    if (key.ends_with(unit.suffix)) return &unit;
  return nullptr;
}

}  // namespace

Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, const std::string& path) {
  Json made = Json::object();
  for (auto& [name, value] : tree.items()) {
    const NamedUnit* unit = has(tables, name) ? std::end(kNamed) : std::begin(kNamed);
    while (unit != std::end(kNamed) && !has(tables, name + std::string(unit->suffix))) ++unit;
    std::string key = name;
    if (unit != std::end(kNamed)) {
      key += unit->suffix;
      scale(value, unit->per_house);
    }
    const std::string here = path.empty() ? key : path + "." + key;
    if (made.contains(key))
      raise(Error{here, "", "is given twice, once in the unit of the key and once in mm or rad"});
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
  const NamedUnit* const unit = unit_of(key.key);
  return std::string(key.key.substr(0, key.key.size() - (unit ? unit->suffix.size() : 0)));
}

double units_per_house(const Key& key) {
  const NamedUnit* const unit = unit_of(key.key);
  return unit ? unit->per_house : 1.0;
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

Result<ModelPtr> solved_model(Json spec, const std::filesystem::path& folder, Scope scope) {
  const py::gil_scoped_release free;
  const auto read = read_spec_tree(spec, folder);
  if (!read) return read.error();
  auto solved = scope == Scope::gears ? solve(*read, scope) : solve_any(*read, scope);
  if (!solved) return spelled(solved.error(), read->given);
  return std::make_shared<const Model>(Model{std::move(spec), folder, std::move(solved).take()});
}

ModelPtr make_model(Json spec, const std::filesystem::path& folder, Scope scope) {
  return value_or_raise(solved_model(std::move(spec), folder, scope));
}

const Value& quantity(const ValueRecord& record, std::string_view key) {
  static const Value kNothing;
  for (const Member& member : record)
    if (member.info->key == key) return member.value;
  return kNothing;
}

ModelPtr with_two_gears(ModelPtr model) {
  if (auto error = two_gears_error(model->job.spec)) raise(*error, *model);
  return model;
}

void raise(const Error& error, const Model& model) { raise(spelled(error, model.given())); }

Json GearValue::spec() const {
  // This tree contains the values that gear 2 inherits from gear 1.
  const Json tree = inherit(model->spec).tree;
  const std::string table = which == 1 ? "gear1" : "gear2";
  Json own = tree.contains(table) ? tree[table] : Json::object();
  const bool followed = model->spec.contains("gear2") && gear().straight_cutter();
  if (followed && !own.contains("profile_shift") && !own.contains("basic"))
    own["profile_shift"] = gear().spec.profile_shift;
  return own;
}

ValueRecord GearValue::record() const {
  ValueRecord all = gear_record(gear(), halves());
  if (halves())
    for (Member& member : double_helical_quantities().of(*halves())) all.push_back(member);
  return all;
}

}  // namespace gearwright::python
