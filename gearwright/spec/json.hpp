// Trees of specs and results. Members keep the order in which they were written.
//
// This header only declares the tree, because nlohmann/json.hpp adds a second to each compilation,
// and reading or writing text adds two more. Headers include this file. Sources that look into a
// tree include nlohmann/json.hpp. The functions below read and write text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace gearwright {

using Json = nlohmann::ordered_json;

/// The nesting depth of the brackets in a text. Brackets in strings do not count. Callers check the
/// depth before a foreign text is parsed, because trees are written and destroyed recursively.
int json_depth(std::string_view text);

/// Throws  nlohmann::json::parse_error
Json parse_json(std::string_view text);

/// The text of a tree on one line, or with `indent` spaces per level. Bytes that are not valid
/// UTF-8 become U+FFFD.
std::string json_text(const Json& tree, int indent = -1);

}  // namespace gearwright
