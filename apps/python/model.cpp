#include "apps/python/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/table_reader.hpp"

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

// Converts every number of a value to inch.
void scale_to_inch(Json& value, const KeyUnit& unit) {
  if (value.is_structured()) {
    for (Json& v : value) scale_to_inch(v, unit);
  } else if (value.is_number()) {
    value = unit.to_inch(value.get<double>());
  }
}

Json in_mm(const Json& spec) {
  try {
    GivenKeys given;
    return in_catalogue_units(spec, given);
  } catch (const SpecError& e) {
    raise(e.error);
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

Json with_keys(Json tree, const std::vector<const KeyTable*>& tables, UnitSystem units,
               const std::string& path) {
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
      if (const KeyUnit* const unit = units == UnitSystem::inch ? metric_unit(key) : nullptr) {
        scale_to_inch(value, *unit);
        key = key_in(UnitSystem::inch, key);
      }
    }
    const std::string here = path.empty() ? key : path + "." + key;
    if (made.contains(key))
      raise(Error{here, "", "is given twice, once in the unit of the key and once in mm or rad"});
    const auto under = tables_under(tables, key);
    if (value.is_object() && !under.empty())
      value = with_keys(std::move(value), under, units, here);
    if (value.is_array() && !under.empty())
      for (Json& v : value)
        if (v.is_object()) v = with_keys(std::move(v), under, units, here);
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
  const KeyRange& range = key.range;
  if (!range.limited() || range.contains(converted) || !range.contains(given)) return std::nullopt;
  const bool angle = key.key.ends_with("_deg") || key.key.ends_with("_arcsec");
  // An angle slightly outside the range, such as π/2 for a helix angle, is probably in rad.
  if (angle && std::abs(converted) <= 2.0 * std::max(std::abs(range.lo), std::abs(range.hi)))
    return std::nullopt;
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

UnitSystem units_of(const Json& spec) {
  const bool inch = spec.is_object() && spec.contains(kUnitsKey) && spec[kUnitsKey] == "inch";
  return inch ? UnitSystem::inch : UnitSystem::mm;
}

Json spec_with_units(Json spec, UnitSystem units) {
  if (units_of(spec) == units) return spec;
  if (units == UnitSystem::mm) return in_mm(spec);
  spec.erase(kUnitsKey);
  return spec_in(units, spec);
}

Json gear_with_units(Json gear, UnitSystem units) {
  Json whole = Json::object();
  if (units_of(gear) == UnitSystem::inch) whole[kUnitsKey] = gear[kUnitsKey];
  gear.erase(kUnitsKey);
  whole["gear1"] = std::move(gear);
  return spec_with_units(std::move(whole), units)["gear1"];
}

Json inherited(const Json& spec) {
  if (units_of(spec) == UnitSystem::mm) return inherit(spec).tree;
  Json tree = spec_with_units(inherit(in_mm(spec)).tree, UnitSystem::inch);
  for (const char* gear : {"gear1", "gear2"}) {
    const auto given = spec.find(gear);
    if (given == spec.end() || !given->is_object() || !tree[gear].is_object()) continue;
    for (const auto& [key, value] : given->items())  // the given numbers have no rounding errors
      if (!value.is_string()) tree[gear][key] = value;
  }
  return tree;
}

Json spec_with_keys(Json tree) {
  if (!tree.is_object()) return tree;
  for (const char* gear : {"gear1", "gear2"}) {
    const auto table = tree.find(gear);
    if (table == tree.end() || !table->is_object() || !table->contains(kUnitsKey)) continue;
    const Json word = (*table)[kUnitsKey];
    if (word != "mm" && word != "inch") continue;  // the reader of the spec rejects this key
    if (!tree.contains(kUnitsKey)) tree[kUnitsKey] = word;
    tree[gear] = gear_with_units(tree[gear], units_of(tree));
  }
  const UnitSystem units = units_of(tree);
  return with_keys(std::move(tree), {&spec_keys()}, units);
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

void set_keys(Json& spec, const std::string& table, const Json& keys) {
  if (spec.contains(table) && !spec[table].is_object()) return;
  for (const auto& [key, value] : keys.items()) spec[table][key] = value;
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
  const Json tree = inherited(model->spec);
  const std::string table = which == 1 ? "gear1" : "gear2";
  Json own = tree.contains(table) ? tree[table] : Json::object();
  const bool followed = model->spec.contains("gear2") && gear().straight_cutter();
  if (followed && !own.contains("profile_shift") && !own.contains("basic"))
    own["profile_shift"] = gear().spec.profile_shift;
  if (units_of(model->spec) == UnitSystem::mm) return own;
  Json in_inch = Json::object();
  in_inch[kUnitsKey] = to_string(UnitSystem::inch);
  in_inch.update(own);
  return in_inch;
}

ValueRecord GearValue::record() const {
  ValueRecord all = gear_record(gear(), halves());
  if (halves())
    for (Member& member : double_helical_quantities().of(*halves())) all.push_back(member);
  return all;
}

}  // namespace gearwright::python
