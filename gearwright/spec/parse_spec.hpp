// The tree of tables between the text of a spec and what it says.
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

/// The tables of a spec, where a public header must not show them.
struct SpecTree {
  Json tables;
};

/// The tree of a spec, members in their order. Nesting is bounded, and every key of a table stands
/// there once, in JSON too.
///
/// Errors    what is wrong, with line and column
Result<Json> parse_spec(std::string_view text, SpecFormat format);

/// What is wrong with a tree before its keys are looked at: no table at all, or tables too deep in tables.
std::optional<Error> check_tree(const Json& tree);

/// The spec of a tree: what read_spec makes of its text.
///
/// Errors    as read_spec, but for syntax; as check_tree
Result<JobSpec> read_spec_tree(const Json& tree, const std::filesystem::path& folder = {},
                               SpecUse use = SpecUse::geometry);

}  // namespace gearwright
