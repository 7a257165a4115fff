#include "gearwright/job/result_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

#include "gearwright/catalogue/columns.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/inch_schema.hpp"
#include "gearwright/catalogue/scattered_design_quantities.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/job/verbs.hpp"

namespace gearwright {

namespace {

std::string definition_name(const QuantityTable& table) {
  std::string name = table.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

class Schema {
 public:
  Json reference(const QuantityTable& table) {
    const std::string name = definition_name(table);
    if (!definitions_.contains(name)) {
      definitions_[name] = nullptr;  // prevents endless recursion for a record that contains itself
      definitions_[name] = record(table);
    }
    return {{"$ref", "#/$defs/" + name}};
  }
  Json properties_of(const QuantityTable& table) { return record(table)["properties"]; }
  Json list_of(const QuantityTable& table) {
    return {{"type", "array"}, {"items", reference(table)}};
  }
  Json& definitions() { return definitions_; }

 private:
  Json record(const QuantityTable& table) {
    Json properties = Json::object(), required = Json::array();
    for (const QuantityInfo* info : table.list) {
      if (!(info->doors & kJson)) continue;
      properties[info->key] = value(*info);
      if (!info->optional_key) required.push_back(info->key);
    }
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)},
            {"additionalProperties", false}};
  }

  Json value(const QuantityInfo& info) {
    Json j = listed(info, 0);
    std::string text = capitalised(info.words == info.key ? info.meaning : info.words);
    if (info.words != info.key && !info.meaning.empty()) text += ": " + info.meaning;
    if (!text.empty()) j["description"] = text;
    return j;
  }
  // Returns the schema of a value at this depth of the nested lists of the quantity. Depth 0 is the
  // whole value.
  Json listed(const QuantityInfo& info, std::size_t depth) {
    if (depth == info.list.size()) return single(info, info.list.empty() && info.always);
    Json j{{"type", info.always || depth > 0 ? Json("array") : Json{"array", "null"}},
           {"items", listed(info, depth + 1)}};
    if (const int n = info.list[depth]; n > 0) {
      j["minItems"] = n;
      j["maxItems"] = n;
    }
    return j;
  }
  Json single(const QuantityInfo& info, bool always) {
    const auto plain = [&](const char* type) {
      return Json{{"type", always ? Json(type) : Json{type, "null"}}};
    };
    switch (info.type) {
      case Type::number: return plain("number");
      case Type::whole:
      case Type::index: return plain("integer");
      case Type::flag: return plain("boolean");
      case Type::text: return plain("string");
      case Type::word: {
        if (info.one_of.empty()) return plain("string");
        Json words = info.one_of;
        if (!always) words.push_back(nullptr);
        return {{"enum", std::move(words)}};
      }
      case Type::record: {
        const Json inner = reference(info.of());
        if (always || !info.list.empty()) return inner;
        return {{"anyOf", Json{inner, Json{{"type", "null"}}}}};
      }
      case Type::map: break;  // the names of its members depend on the job
    }
    return Json::object();
  }

  Json definitions_ = Json::object();
};

Json search_schema(Schema& schema) {
  const Json stopped{{"type", "object"},
                     {"properties",
                      {{"finished", {{"const", false}}},
                       {"stopped", {{"type", "boolean"}}},
                       {"chunks_done", {{"type", "integer"}}},
                       {"chunks", {{"type", "integer"}}}}},
                     {"required", {"finished", "stopped", "chunks_done", "chunks"}},
                     {"additionalProperties", false}};
  return {{"anyOf", Json{schema.reference(search_quantities().table()),
                         schema.reference(drive_search_quantities().table()), stopped}}};
}

Json study_schema(Schema& schema) {
  const Json unfinished{{"type", "object"},
                        {"properties",
                         {{"finished", {{"const", false}}},
                          {"done", {{"type", "integer"}}},
                          {"count", {{"type", "integer"}}}}},
                        {"required", {"finished", "done", "count"}},
                        {"additionalProperties", false}};
  return {{"anyOf", Json{schema.reference(scatter_study_quantities().table()), unfinished}}};
}

Json error_schema() {
  const Json text{{"type", "string"}};
  Json kinds = Json::array();
  for (const FailureMeaning& meaning : failure_meanings()) kinds.push_back(meaning.text);
  return {{"type", "object"},
          {"properties",
           {{"key", text},
            {"value", text},
            {"message", text},
            {"kind", {{"enum", kinds}}},
            {"file", text},
            {"line", {{"type", "integer"}}},
            {"column", {{"type", "integer"}}}}},
          {"required", {"key", "value", "message", "kind"}},
          {"additionalProperties", false}};
}

}  // namespace

std::vector<const QuantityTable*> result_tables() {
  std::vector<const QuantityTable*> tables{
      &gear_quantities().table(),          &measure_quantities().table(),
      &as_rack_quantities().table(),       &double_helical_quantities().table(),
      &outline_quantities().table(),       &pair_quantities().table(),
      &rack_quantities().table(),          &rack_pair_quantities().table(),
      &scatter_study_quantities().table(), &drawing_quantities().table(),
      &drive_search_quantities().table(),  &file_quantities().table(),
      &warning_quantities().table(),       &verdict_quantities().table()};
  for (const Verb& verb : verbs())
    if (verb.table != nullptr) tables.push_back(&verb.table());
  return with_inner_tables(tables);
}

Json result_schema() {
  Schema schema;
  Json properties;
  properties["title"] = {{"type", "string"}};
  properties["gears"] = {{"type", "array"},
                         {"items",
                          {{"anyOf", Json{schema.reference(gear_quantities().table()),
                                          schema.reference(rack_quantities().table())}}}}};
  // The verb `measure` and the option --as-rack add these data to a gear.
  const Json rack = schema.reference(as_rack_quantities().table());
  const Json measure = schema.reference(measure_quantities().table());
  // The additional data of a double-helical gear are members of the gear itself.
  const Json halves = schema.properties_of(double_helical_quantities().table());
  Json& gear = schema.definitions()[definition_name(gear_quantities().table())]["properties"];
  gear["as_rack"] = rack;
  gear["measure"] = measure;
  gear.update(halves);
  properties["pair"] = {{"anyOf", Json{schema.reference(pair_quantities().table()),
                                       schema.reference(rack_pair_quantities().table())}}};
  // If a result is computed within tolerances, each of these records also has the key `interval`.
  // Its value is an object. For each key that depends on the tolerances, this object has two
  // numbers instead of one.
  const Json interval{{"type", "object"},
                      {"description",
                       "numbers that depend on the tolerances; each number has two values, one at "
                       "the lower and one at the upper end of the tolerances"}};
  for (const QuantityTable* table :
       {&gear_quantities().table(), &measure_quantities().table(), &pair_quantities().table()})
    schema.definitions()[definition_name(*table)]["properties"]["interval"] = interval;
  for (const Verb& verb : verbs())
    if (verb.table != nullptr) properties[verb.key] = schema.reference(verb.table());
  properties["scatter_designs"] = study_schema(schema);
  properties["search"] = search_schema(schema);
  properties["arcs"] = schema.list_of(outline_quantities().table());
  properties["files"] = schema.list_of(file_quantities().table());
  properties["warnings"] = schema.list_of(warning_quantities().table());
  properties["drawing"] = schema.reference(drawing_quantities().table());
  properties["verdict"] = schema.reference(verdict_quantities().table());
  properties["error"] = error_schema();
  Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
             {"title", "Gearwright result"},
             {"description", "The output of gearwright VERB SPEC --json"},
             {"type", "object"},
             {"properties", std::move(properties)},
             {"additionalProperties", false},
             {"$defs", std::move(schema.definitions())}};
  add_inch_names(whole);
  return whole;
}

}  // namespace gearwright
