// Declares trees of specs and results. Members keep the order in which they were written.
//
// This header only declares the tree, because nlohmann/json.hpp makes each compilation 1 s longer,
// and code that reads or writes text makes it another 2 s longer. Headers therefore include this
// file where the declaration is sufficient. nlohmann/json.hpp is included by headers whose structs
// contain a tree, and by sources that access members of a tree. The functions below read and write
// text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

using Json = nlohmann::ordered_json;

/// Returns the nesting depth of the brackets in a text. Brackets in strings do not count. Callers
/// check the depth before they parse text of unknown origin, because trees are written and
/// destroyed recursively.
int json_depth(std::string_view text);

/// Throws  nlohmann::json::parse_error
Json parse_json(std::string_view text);

/// Returns the text of a tree on one line, or with `indent` spaces per level. Bytes that are not
/// valid UTF-8 become U+FFFD.
std::string json_text(const Json& tree, int indent = -1);

// Writes a spec as TOML text from its tree. Internal to spec/ and the program.

/// Returns a value on one line. A table is written in braces.
std::string toml_value(const Json& value);

/// Returns the tree as TOML text. Reading the text gives exactly the doubles of the tree. Plain
/// values precede tables, and each table of a list has a heading [[name]].
///
/// Domain    an object of numbers, strings, booleans, arrays and objects (contract)
std::string toml_text(const Json& tree);

/// Returns sentences as comments. Each sentence begins on a new line.
std::string toml_comment(const std::vector<std::string>& sentences);

}  // namespace gearwright
