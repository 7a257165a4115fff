#include "gearwright/job/value_json.hpp"

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

namespace {

struct JsonWriter {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const ValueList& list) const {
    Json j = Json::array();
    for (const Value& v : list) j.push_back(to_json(v));
    return j;
  }
  Json operator()(const ValueRecord& record) const {
    Json j = Json::object();
    for (const Member& m : record) {
      if (m.info->doors & kJson) j[m.info->key] = to_json(m.value);
    }
    return j;
  }
  Json operator()(const ValueMap& map) const {
    Json j = Json::object();
    for (const auto& [name, value] : map) j[name] = to_json(value);
    return j;
  }
  template <class T>
  Json operator()(const T& plain) const {
    return plain;
  }
};

}  // namespace

Json to_json(const Value& value) { return std::visit(JsonWriter(), value.variant()); }

Value to_value(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean: return json.get<bool>();
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned: return json.get<long long>();
    case Json::value_t::number_float: return json.get<double>();
    case Json::value_t::string: return json.get<std::string>();
    case Json::value_t::array: {
      ValueList list;
      for (const Json& j : json) list.push_back(to_value(j));
      return list;
    }
    case Json::value_t::object: {
      ValueMap map;
      for (const auto& [key, j] : json.items()) map.emplace_back(key, to_value(j));
      return map;
    }
    case Json::value_t::null:
    case Json::value_t::binary:
    case Json::value_t::discarded: return {};
  }
  return {};
}

}  // namespace gearwright
