#include "apps/web/engine/catalogue_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::web {

namespace {

// The words for KeyKind in the JSON, in the order of the enumerators. The form has no fields for
// numbers by name and for lists of texts. The word for KeyKind::by_name is therefore "any", and
// key_json() writes "any" for a list of texts.
constexpr std::array<const char*, 8> kKinds{"number", "whole", "boolean", "text",
                                            "word",   "any",   "table",   "any"};
constexpr std::array<const char*, 8> kTypes{"number", "whole", "index",  "flag",
                                            "word",   "text",  "record", "map"};
constexpr std::array<const char*, 4> kTwos{"values", "gears", "ends", "fraction"};

template <class Names, class E>
const char* name_of(const Names& names, E value) {
  return names[static_cast<std::size_t>(value)];
}

Json texts(const std::vector<std::string_view>& list) {
  return Json(std::vector<std::string>(list.begin(), list.end()));
}

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json key_json(const Key& k) {
  const Unit unit = unit_of(k.key);
  Json tables = Json::array();
  for (const auto& table : k.tables) tables.push_back(table().name);
  Json j{{"key", k.key},
         {"symbol", k.symbol},
         {"kind", k.kind == KeyKind::text && k.list ? "any" : name_of(kKinds, k.kind)},
         {"unit", unit_text(unit)},
         {"suffix", unit == Unit::none ? "" : unit_suffix(unit).substr(1)},
         {"words", texts(k.words)},
         {"range", nullptr},
         {"list", nullptr},
         {"form", form_of(k)},
         {"required", k.required},
         {"needs", texts(k.needs)},
         {"excludes", texts(k.excludes)},
         {"tables", std::move(tables)},
         {"fallback", k.fallback},
         {"meaning", plain_words(k.meaning)},
         {"also", texts(k.also)},
         {"documented", k.in_documents}};
  if (k.range.limited()) {
    j["range"] = {{"lo", number_or_null(k.range.lo)},
                  {"hi", number_or_null(k.range.hi)},
                  {"loOpen", k.range.lo_open},
                  {"hiOpen", k.range.hi_open},
                  {"zero", k.range.zero},
                  {"reason", k.range.reason}};
  }
  if (k.list)
    j["list"] = {{"least", k.list->least}, {"most", k.list->most}, {"single", k.list->single}};
  return j;
}

Json said_json(const QuantityInfo& s) {
  return {{"key", s.key},
          {"words", s.words},
          {"symbol", s.symbol},
          {"unit", unit_text(s.unit)},
          {"digits", digits_of(s)},
          {"group", s.group},
          {"meaning", plain_words(s.meaning)},
          {"type", name_of(kTypes, s.type)},
          {"list", s.list},
          {"two", name_of(kTwos, s.two)},
          {"oneOf", s.one_of},
          {"of", s.type == Type::record && s.of ? s.of().name : std::string()},
          {"page", (s.doors & kPage) != 0},
          {"listing", (s.doors & kListing) != 0},
          {"percent", s.unit == Unit::percent},
          {"nothing", s.nothing},
          {"greaterFirst", s.greater_first}};
}

}  // namespace

std::string catalogue_json() {
  Json inputs = Json::array();
  for (const KeyTable* table : all_key_tables()) {
    Json keys = Json::array();
    for (const Key& k : table->keys) keys.push_back(key_json(k));
    inputs.push_back({{"name", table->name},
                      {"meaning", plain_words(table->meaning)},
                      {"keys", std::move(keys)}});
  }
  Json quantities = Json::array();
  for (const QuantityTable* table : result_tables()) {
    Json list = Json::array();
    for (const QuantityInfo* s : table->list)
      if ((s->doors & kJson) != 0) list.push_back(said_json(*s));
    quantities.push_back(
        {{"name", table->name}, {"groups", table->groups}, {"quantities", std::move(list)}});
  }
  Json materials = Json::array();
  for (const NamedMaterial& m : named_materials())
    materials.push_back({{"name", m.name},
                         {"kind", material_letters(m.kind)},
                         {"hardness_HV", m.hardness_HV},
                         {"note", m.note}});
  Json objectives = Json::array();
  for (std::size_t i = 0; i < kObjectiveNames.size(); ++i) {
    const auto objective = static_cast<Objective>(i);
    const ObjectiveWords words = words_of(objective);
    objectives.push_back({{"name", kObjectiveNames[i]},
                          {"words", words.name},
                          {"symbol", words.symbol},
                          {"unit", words.unit},
                          {"better", seeks_greatest(objective) ? "greater" : "smaller"}});
  }
  Json inch_units;
  for (const Unit unit : {Unit::mm, Unit::um, Unit::per_mm, Unit::mm_per_rad}) {
    constexpr int kMany = 9;  // decimals; with 0 decimals, digits_in() could not return one less
    inch_units[std::string(unit_text(unit))] = {unit_text(UnitSystem::inch, unit),
                                                metric_unit(unit_suffix(unit))->to_metric(1.0),
                                                digits_in(UnitSystem::inch, unit, kMany) - kMany};
  }
  return json_text({{"version", kVersion},
                    {"inchUnits", std::move(inch_units)},
                    {"materials", std::move(materials)},
                    {"objectives", std::move(objectives)},
                    {"inputs", std::move(inputs)},
                    {"quantities", std::move(quantities)}});
}

}  // namespace gearwright::web
