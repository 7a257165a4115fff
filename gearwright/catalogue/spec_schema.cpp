#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/catalogue/inch_schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/rating_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright {

namespace {

using Json = nlohmann::ordered_json;

// Returns the number as JSON. A whole number has no decimal point.
Json number_json(double x) {
  return x == std::floor(x) && std::abs(x) < 1e15 ? Json(static_cast<long long>(x)) : Json(x);
}

// Returns the schema of a number. General limits, such as kMaxInput, do not apply in a list.
Json number_schema(const Key& key) {
  const bool whole = key.kind == KeyKind::whole;
  const double most = whole ? kMaxWholeInput : kMaxInput;
  const KeyRange& r = key.range;
  Json s{{"type", whole ? "integer" : "number"}};
  if (std::isfinite(r.lo)) {
    s[r.lo_open ? "exclusiveMinimum" : "minimum"] = number_json(r.lo);
  } else if (!key.list) {
    s["minimum"] = number_json(-most);
  }
  if (std::isfinite(r.hi)) {
    s[r.hi_open ? "exclusiveMaximum" : "maximum"] = number_json(r.hi);
  } else if (!key.list) {
    s["maximum"] = number_json(most);
  }
  if (!r.zero) s["not"] = {{"const", 0}};
  return s;
}

Json enum_schema(const std::vector<std::string_view>& words) { return {{"enum", words}}; }

Json reference(const KeyTable& table) { return {{"$ref", fmt::format("#/$defs/{}", table.name)}}; }

std::vector<Json> element_schemas(const Key& key) {
  switch (key.kind) {
    case KeyKind::number:
    case KeyKind::whole: return {number_schema(key)};
    case KeyKind::boolean: return {{{"type", "boolean"}}};
    case KeyKind::text: return {{{"type", "string"}}};
    case KeyKind::word: return {enum_schema(key.words)};
    case KeyKind::table: {
      std::vector<Json> list;
      for (const auto table : key.tables) {
        list.push_back(reference(table()));
        const Key* const shorthand = table().find(table().shorthand);
        if (shorthand && shorthand->kind == KeyKind::text) list.push_back({{"type", "string"}});
      }
      return list;
    }
    case KeyKind::by_name: {
      const Json number = number_schema(key);
      return {number,
              {{"type", "object"},
               {"propertyNames", {{"enum", key.place.names()}}},
               {"additionalProperties", number}}};
    }
    case KeyKind::any: break;
  }
  if (!key.range.limited()) return {};
  const Json number = number_schema(key);  // schema of a number, or of numbers by name
  return {number, {{"type", "object"}, {"additionalProperties", number}}};
}

Json any_of(const std::vector<Json>& list) {
  if (list.empty()) return Json::object();
  return list.size() == 1 ? list.front() : Json{{"anyOf", list}};
}

Json value_schema(const Key& key) {
  std::vector<Json> list;
  if (!key.words.empty() && key.kind != KeyKind::word) list.push_back(enum_schema(key.words));
  const std::vector<Json> elements = element_schemas(key);
  if (key.list) {
    if (key.list->single) list.insert(list.end(), elements.begin(), elements.end());
    Json array{{"type", "array"},
               {"items", key.list->numbers          ? Json{{"type", "number"}}
                         : key.kind == KeyKind::any ? elements.front()
                                                    : any_of(elements)},
               {"minItems", key.list->least},
               {"maxItems", key.list->most}};
    const bool names = key.kind == KeyKind::text && key.list->single && key.list->most > 1;
    if (key.kind == KeyKind::word || names) array["uniqueItems"] = true;
    list.push_back(std::move(array));
  } else {
    list.insert(list.end(), elements.begin(), elements.end());
  }
  return any_of(list);
}

std::string description_of(const Key& key) {
  std::string text = key.symbol.empty() ? "" : std::string(key.symbol) + ": ";
  text += plain_words(key.meaning);
  if (!key.fallback.empty() && !Json::accept(key.fallback))
    text += "; default: " + plain_words(key.fallback);
  return text;
}

Json key_schema(const Key& key) {
  Json s{{"description", description_of(key)}};
  s.update(value_schema(key));
  if (!key.fallback.empty() && Json::accept(key.fallback)) s["default"] = Json::parse(key.fallback);
  return s;
}

Json table_schema(const KeyTable& table) {
  Json s{{"description", table.meaning}, {"type", "object"}};
  Json properties = Json::object();
  Json required = Json::array();
  Json needs = Json::object();
  Json rules = Json::array();
  for (const Key& key : table.keys) {
    properties[std::string(key.key)] = key_schema(key);
    if (key.required) required.push_back(key.key);
    if (!key.needs.empty()) needs[std::string(key.key)] = key.needs;
    for (const std::string_view other : key.excludes)
      rules.push_back({{"not", {{"required", {key.key, other}}}}});
  }
  s["properties"] = std::move(properties);
  s["additionalProperties"] = false;
  if (!required.empty()) s["required"] = std::move(required);
  if (!needs.empty()) s["dependentRequired"] = std::move(needs);
  if (!rules.empty()) s["allOf"] = std::move(rules);
  return s;
}

Json required(std::initializer_list<const char*> keys) { return {{"required", keys}}; }

// Returns the requirement for gears. A search can choose the numbers of teeth, and a drive has its
// own gears. Every other spec needs at least one complete gear.
Json gears_or_search() {
  const Json whole{{"$ref", "#/$defs/whole_gear"}};
  Json rack = required({"form"});
  rack["properties"] = {{"form", {{"const", "rack"}}}};
  // Gear 2 needs only its number of teeth, because all its other values default to those of gear 1.
  const Json second{{"anyOf", {required({"teeth"}), rack}}};
  const Json either{{"anyOf", {whole, reference(blank_keys())}}};
  const Json either_second{{"anyOf", {second, reference(blank_keys())}}};
  Json known{{"properties", {{"gear1", whole}, {"gear2", second}}}};
  // If gear 2 has readings, the verb `identify` computes the module of both gears from them.
  Json unknown = required({"gear2"});
  unknown["properties"] = {{"gear1", required({"teeth"})},
                           {"gear2", required({"teeth", "measured"})}};
  Json alone = required({"gear1"});
  alone["anyOf"] = {std::move(known), std::move(unknown)};
  const Json without{
      {"anyOf",
       {required({"search"}), required({"planetary"}), required({"stage"}), required({"drive"})}}};
  return {{"if", without},
          {"then", {{"properties", {{"gear1", either}, {"gear2", either_second}}}}},
          {"else", std::move(alone)}};
}

// Some keys of [rating] need a speed, but a drive takes the speed from its input. This function
// therefore removes the condition from the schema of [rating], and returns it as a condition for
// specs without a drive.
Json needs_outside_drives(Json& rating) {
  Json needs = std::move(rating["dependentRequired"]);
  rating.erase("dependentRequired");
  const Json drive{{"anyOf", {required({"planetary"}), required({"stage"}), required({"drive"})}}};
  return {{"if", drive},
          {"else", {{"properties", {{"rating", {{"dependentRequired", std::move(needs)}}}}}}}};
}

Json whole_gear() {
  Json s = required({"teeth"});
  s["anyOf"] = {required({"normal_module_mm"}),
                required({"normal_diametral_pitch_per_in"}),
                required({"transverse_module_mm"}),
                required({"basic"}),
                required({"cut_by"}),
                required({"measured"})};  // for a gear whose module `identify` computes
  return s;
}

}  // namespace

std::string spec_schema() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"$id", "urn:gearwright:spec"},
              {"title", "A spec of Gearwright"}};
  schema.update(table_schema(spec_keys()));
  schema.update(gears_or_search());
  Json defs;
  for (const KeyTable* table : all_key_tables()) {
    if (table != &spec_keys()) defs[std::string(table->name)] = table_schema(*table);
  }
  defs[std::string(gear_keys().name)].erase("required");
  schema["allOf"].push_back(needs_outside_drives(defs[std::string(rating_keys().name)]));
  defs["whole_gear"] = whole_gear();
  defs[std::string(blank_keys().name)] = table_schema(blank_keys());
  schema["$defs"] = std::move(defs);
  add_inch_names(schema);
  separate_units(schema);
  return schema.dump(2) + "\n";
}

}  // namespace gearwright
