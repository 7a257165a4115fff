// Trees of specs and results, members in the order in which they were written.
//
// Declared only: nlohmann/json.hpp costs a compilation a second, and reading or writing text
// another two. Headers include this one, sources that look into a tree nlohmann/json.hpp, and text
// is read and written here.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace gearwright {

using Json = nlohmann::ordered_json;

/// The nesting depth of brackets in a text, except those in strings. Callers check it before a
/// foreign text is parsed, because trees are written and destroyed recursively.
int json_depth(std::string_view text);

/// Throws  nlohmann::json::parse_error
Json parse_json(std::string_view text);

/// The text of a tree on one line, or with `indent` spaces per level. Bytes that are not characters
/// become U+FFFD.
std::string json_text(const Json& tree, int indent = -1);

}  // namespace gearwright
