#include "gearwright/spec/json.hpp"

#include <nlohmann/json.hpp>

namespace gearwright {

Json parse_json(std::string_view text) { return Json::parse(text); }

std::string json_text(const Json& tree, int indent) {
  return tree.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gearwright
