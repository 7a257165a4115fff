#include "apps/python/model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::python {

namespace {

void scale(Json& value, double factor) {
  if (factor == 1.0) return;
  if (value.is_array()) {
    for (Json& v : value) scale(v, factor);
  } else if (value.is_number()) {
    value = value.get<double>() * factor;
  }
}

const Key* find(const std::vector<const KeyTable*>& tables, const std::string& key) {
  for (const KeyTable* table : tables)
    if (const Key* found = table->find(key)) return found;
  return nullptr;
}

// Raises the error of missing_unit() for the value of a spec.
void check_unit(const Key& key, const std::string& name, const Json& given, const Json& converted) {
  if (!given.is_number()) return;
  if (const auto error = missing_unit(key, name, given.get<double>(), converted.get<double>()))
    raise(*error);
}

std::vector<const KeyTable*> tables_under(const std::vector<const KeyTable*>& tables,
                                          const std::string& key) {
  std::vector<const KeyTable*> under;
  for (const KeyTable* t : tables)
    if (const Key* k = t->find(key))
      for (const auto table : k->tables) under.push_back(&table());
  return under;
}

const HouseUnit* unit_of(std::string_view key) {
  for (const HouseUnit& house : kHouseUnits)
    if (key.ends_with(unit_suffix(house.unit))) return &house;
  return nullptr;
}

}  // namespace

Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, const std::string& path) {
  Json made = Json::object();
  for (auto& [name, value] : tree.items()) {
    const auto house = std::find_if(kHouseUnits.begin(), kHouseUnits.end(),
                                    [&tables, &own = name](const HouseUnit& h) {
                                      return find(tables, own + std::string(unit_suffix(h.unit)));
                                    });
    std::string key = name;
    if (!find(tables, name) && house != kHouseUnits.end()) {
      key += unit_suffix(house->unit);
      const Json given = value;
      scale(value, house->per_house);
      check_unit(*find(tables, key), path.empty() ? name : path + "." + name, given, value);
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

const Key* key_of_name(const KeyTable& table, const std::string& name) {
  const Key* key = table.find(name);
  for (auto house = kHouseUnits.begin(); !key && house != kHouseUnits.end(); ++house)
    key = table.find(name + std::string(unit_suffix(house->unit)));
  return key;
}

std::optional<Error> missing_unit(const Key& key, const std::string& name, double given,
                                  double converted) {
  if (!key.range.limited() || key.range.contains(converted) || !key.range.contains(given))
    return std::nullopt;
  const bool angle = key.key.ends_with("_deg") || key.key.ends_with("_arcsec");
  return refused(
      name, given,
      fmt::format(
          "is outside the allowed range, because a value without a unit in its key is in {}; use "
          "{} = {:g} for a value in the unit of that key",
          angle ? "rad" : "mm", key.key, given));
}

std::string house_key(const Key& key) {
  const HouseUnit* const house = unit_of(key.key);
  const std::size_t suffix = house ? unit_suffix(house->unit).size() : 0;
  return std::string(key.key.substr(0, key.key.size() - suffix));
}

double units_per_house(const Key& key) {
  const HouseUnit* const house = unit_of(key.key);
  return house ? house->per_house : 1.0;
}

Json spec_with_keys(Json tree) {
  return tree.is_object() ? with_keys(std::move(tree), {&spec_keys()}) : tree;
}

std::pair<Json, std::filesystem::path> read_tree(const py::object& given) {
  if (!is_path(given)) return {spec_with_keys(tree_of(given, "")), {}};
  const SpecText text = value_or_raise(read_spec_text(path_of(given, "spec")));
  return {value_or_raise(parse_spec(text.text, text.format)), text.folder};
}

void change(Json& tree, const Json& changes) {
  for (const auto& [key, value] : changes.items()) {
    if (value.is_null()) {
      tree.erase(key);
    } else if (value.is_object()) {
      if (!tree.contains(key) || !tree[key].is_object()) tree[key] = Json::object();
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

const Member* member_of(const ValueRecord& record, const std::string& name) {
  for (const Member& member : record)
    if (name_of(*member.info) == name) return &member;
  return nullptr;
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
