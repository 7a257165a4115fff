// Converts an error of the library for the user of a spec file. The keys of the file replace the
// members of structs, and the rest of the sentence is unchanged.
//
//   gear1.tip_diameter = 10: must be greater than the root diameter 35 mm
//   gear1.tip_diameter_mm = 10: must be greater than the root diameter 35 mm
//
// Members in a sentence are in backticks. Their keys are searched first in the table of the error,
// and then in the enclosing tables.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

/// The paths of the keys that a spec gives, for example "gear1.left_tip_relief_um". If several keys
/// can set the same member, an error names the key that the spec gives.
struct GivenKeys : std::set<std::string, std::less<>> {
  using set::set;
  UnitSystem units = UnitSystem::mm;  ///< units of the spec; the paths have metric keys in both
                                      ///< systems
  /// The values of the lengths as the spec writes them, by path. Empty unless the spec is in inch.
  std::map<std::string, std::string, std::less<>> written{};
};

/// Returns the error with keys in place of members, in the units of the spec. If the value is the
/// default of a key of a rack, or if it is converted from another key of the spec, a preface to the
/// rule states this. All other words are unchanged, so a second call replaces no key.
Error spelled(const Error& error, const GivenKeys& given = {});

/// Converts an error, whose field is a key of the catalogue, to the units of the spec. A value that
/// the spec gives is shown as the spec writes it.
Error in_units_of(const GivenKeys& given, const Error& error);

/// Replaces members by keys in a sentence about the table `owner`, for example "gear1". If `owner`
/// is empty, the sentence is about the spec.
std::string spelled(std::string_view sentence, const GivenKeys& given = {},
                    std::string_view owner = {});

struct SpelledMember {
  std::string key;    ///< with its path, "search.contact_ratio_min"
  std::string value;  ///< as it is written in the file; a word is in quotes
};
/// Returns the key of a member of the table `owner`. If this table has no such member, a member of
/// the spec is used. If no key sets the member, the path is `owner.member` and the value unchanged.
SpelledMember spelled_member(std::string_view owner, std::string_view member,
                             const std::string& value = {});

}  // namespace gearwright
