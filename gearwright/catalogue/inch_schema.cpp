#include "gearwright/catalogue/inch_schema.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

namespace {

using Json = nlohmann::ordered_json;

std::string inch(const std::string& key) { return key_in(UnitSystem::inch, key); }

// Converts the limits in the schema of a quantity to its inch unit. The description and the default
// are removed, because they apply to the metric unit.
void convert_limits(Json& schema, const KeyUnit& unit) {
  if (!schema.is_structured()) return;
  if (schema.is_object()) {
    schema.erase("description");
    schema.erase("default");
    for (const char* limit : {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum"})
      if (const auto it = schema.find(limit); it != schema.end())
        *it = unit.to_inch(it->get<double>());
  }
  for (Json& inner : schema) convert_limits(inner, unit);
}

// Adds to a schema the requirement that all `keys` are present. For a length, the requirement is a
// condition that accepts the metric name or the inch name. All other keys are listed under
// `plain_name`.
void accept_either(Json& schema, const Json& keys, const char* plain_name) {
  Json plain = Json::array();
  for (const Json& key : keys) {
    const auto name = key.get<std::string>();
    if (metric_unit(name)) {
      schema["allOf"].push_back(
          {{"anyOf", {{{"required", {name}}}, {{"required", {inch(name)}}}}}});
    } else {
      plain.push_back(name);
    }
  }
  if (!plain.empty()) schema[plain_name] = std::move(plain);
}

void add_properties(Json& properties) {
  Json::object_t all;
  for (auto& [name, value] : properties.items()) {
    const KeyUnit* const unit = metric_unit(name);
    Json twin = value;
    add_inch_names(value);
    all.emplace_back(name, std::move(value));
    if (!unit) continue;
    convert_limits(twin, *unit);
    add_inch_names(twin);
    all.emplace_back(inch(name), std::move(twin));
  }
  properties = std::move(all);
}

void add_words(Json& words) {
  const Json given = words;
  for (const Json& word : given)
    if (word.is_string() && metric_unit(word.get<std::string>()))
      words.push_back(inch(word.get<std::string>()));
}

// Adds conditions for keys that need other keys. For example, tip_relief_um may need
// tip_relief_start_mm. The other key may have its metric name or its inch name.
void add_needs(Json& schema, const Json& needs) {
  for (const auto& [key, keys] : needs.items()) {
    Json required = Json::object();
    accept_either(required, keys, "required");
    schema["dependentSchemas"][key] = required;
    if (metric_unit(key)) schema["dependentSchemas"][inch(key)] = required;
  }
}

// Returns a schema that rejects keys of the other unit system in tables at any depth. `other` is a
// pattern for the endings of such keys. A key that matches `other` is accepted only if it also
// matches `both`, the pattern for keys with the same name in both systems. `self` is the path under
// which the schema is stored.
Json without_names(const char* other, const char* both, const char* self) {
  const Json again{{"$ref", self}};
  const Json name{{"anyOf", {{{"not", {{"pattern", other}}}}, {{"pattern", both}}}}};
  return {{"if", {{"type", "object"}}},
          {"then", {{"propertyNames", name}, {"additionalProperties", again}}},
          {"else", {{"if", {{"type", "array"}}}, {"then", {{"items", again}}}}}};
}

}  // namespace

void separate_units(Json& schema) {
  constexpr const char *kMm = "#/$defs/only_mm", *kInch = "#/$defs/only_inch";
  schema["$defs"]["only_mm"] = without_names("_u?in$", "_per_in$", kMm);
  schema["$defs"]["only_inch"] =
      without_names("_[mu]m$", "module_mm$|modules_mm$|_N_per_um$", kInch);
  schema["allOf"].push_back(
      {{"if", {{"properties", {{"units", {{"const", "inch"}}}}}, {"required", {"units"}}}},
       {"then", {{"$ref", kInch}}},
       {"else", {{"$ref", kMm}}}});
}

void add_inch_names(Json& schema) {
  if (schema.is_array()) {
    for (Json& inner : schema) add_inch_names(inner);
    return;
  }
  if (!schema.is_object()) return;
  for (auto& [name, inner] : schema.items()) {
    if (name == "properties") {
      add_properties(inner);
    } else if (name == "$defs") {
      for (Json& definition : inner) add_inch_names(definition);
    } else if (name == "enum") {
      add_words(inner);
    } else if (name != "default" && name != "const") {
      add_inch_names(inner);
    }
  }
  if (const auto it = schema.find("required"); it != schema.end()) {
    const Json keys = *it;
    schema.erase("required");
    accept_either(schema, keys, "required");
  }
  if (const auto it = schema.find("dependentRequired"); it != schema.end()) {
    const Json needs = *it;
    schema.erase("dependentRequired");
    add_needs(schema, needs);
  }
}

}  // namespace gearwright
