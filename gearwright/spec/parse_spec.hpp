// The tree of tables of a spec, between its text and its data.
//
// Internal to spec/, job/ and the programs: public headers show no tree.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The tables of a spec, hidden from public headers.
struct SpecTree {
  Json tables;
};

/// The tree of a spec, members in their order. Nesting is bounded, and every key of a table occurs
/// once, in JSON too.
///
/// Errors    the syntax error, with line and column
Result<Json> parse_spec(std::string_view text, SpecFormat format);

/// Checks a tree before its keys are read: it must be a table, with bounded nesting.
std::optional<Error> check_tree(const Json& tree);

/// The spec of a tree, equal to that of read_spec for its text.
///
/// Errors    as read_spec, except those of syntax; as check_tree
Result<JobSpec> read_spec_tree(const Json& tree, const std::filesystem::path& folder = {},
                               SpecUse use = SpecUse::geometry);

}  // namespace gearwright
