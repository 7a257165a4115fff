// Parses the text of a spec into a tree of tables.
//
// Internal to spec/, job/ and the programs, because public headers do not contain trees.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// The tables of a spec, in a struct that public headers only declare.
struct SpecTree {
  Json tables;
};

/// Returns the tree of a spec, with members in the order of the text. The nesting is limited. A key
/// must not occur twice in a table, in TOML or in JSON.
///
/// Errors    the syntax error, with line and column
Result<Json> parse_spec(std::string_view text, SpecFormat format);

/// Returns line and column of the byte with the index `at`.
TextPlace place_at(std::string_view text, std::size_t at);

/// Returns the position of a key in a JSON text that is valid up to this key. If the last table of
/// the path contains the key twice, returns the second position. If the key does not exist, returns
/// the position of the last table or element on the path that does exist. Returns none if the first
/// part of the path does not exist.
std::optional<TextPlace> json_place(std::string_view text, std::string_view path);

/// Checks a tree before its keys are read. The tree must be a table with bounded nesting.
std::optional<Error> check_tree(const Json& tree);

/// Returns the spec of a tree, which equals the spec that read_spec reads from the tree's text.
///
/// Errors    the errors of read_spec, except errors of syntax, and the errors of check_tree
Result<JobSpec> read_spec_tree(const Json& tree, const std::filesystem::path& folder = {},
                               SpecUse use = SpecUse::geometry);

// Converts the units of a spec to mm when it is read, and results and specs back to the units of
// the user when they are written.

struct GivenKeys;  // catalogue/spelling.hpp

/// Returns the spec in mm with the keys of the catalogue, without the key `units`. `given` receives
/// the units and, for inch, the converted values as written.
///
/// Throws  SpecError if `units` is not a known word, or if the key of a length has the wrong unit
Json in_catalogue_units(const Json& spec, GivenKeys& given);

/// Returns a result or a part of a spec, with keys, numbers and sentences converted to this unit
/// system. A spec inside a result gets the key `units`. A second call changes nothing.
Json in_units(UnitSystem units, const Json& record);

/// Returns a whole spec in this unit system, with the key `units` if it is not "mm".
Json spec_in(UnitSystem units, const Json& spec);

}  // namespace gearwright
