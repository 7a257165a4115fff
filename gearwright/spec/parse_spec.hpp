// The tree of tables into which the text of a spec is parsed.
//
// Internal to spec/, job/ and the programs, because public headers do not contain trees.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The tables of a spec, in a struct that public headers only declare.
struct SpecTree {
  Json tables;
};

/// The tree of a spec, with members in the order of the text. The nesting is limited, and every key
/// of a table must occur once, in JSON as well.
///
/// Errors    the syntax error, with line and column
Result<Json> parse_spec(std::string_view text, SpecFormat format);

/// The position of a key in a valid JSON text. If the key does not exist, the result is the
/// position of the last table or element on the path that does exist. There is no result if the
/// first part of the path does not exist.
std::optional<TextPlace> json_place(std::string_view text, std::string_view path);

/// Checks a tree before its keys are read. The tree must be a table with bounded nesting.
std::optional<Error> check_tree(const Json& tree);

/// The spec of a tree. It is equal to the spec that read_spec reads from the text of the tree.
///
/// Errors    the errors of read_spec, except errors of syntax, and the errors of check_tree
Result<JobSpec> read_spec_tree(const Json& tree, const std::filesystem::path& folder = {},
                               SpecUse use = SpecUse::geometry);

}  // namespace gearwright
