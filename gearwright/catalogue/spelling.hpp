// Conversion of an error of the library for a spec file: the keys of the file replace the members
// of structs, and the sentence is unchanged.
//
//   gear1.tip_diameter = 10: must be greater than the root diameter 35 mm
//   gear1.tip_diameter_mm = 10: must be greater than the root diameter 35 mm
//
// Members in a sentence are in backticks. They are searched for next to the member of the error,
// then in the enclosing tables.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// Paths of the keys that a spec gives, "gear1.left_tip_relief_um": if several keys set one member,
/// the error names the given one.
using GivenKeys = std::set<std::string, std::less<>>;

/// The error with keys for members. Other words are unchanged, so repeated spelling has no effect.
Error spelled(const Error& error, const GivenKeys& given = {});

/// Replaces members by keys in a sentence about `owner`, "gear1", or about the spec if it is empty.
std::string spelled(std::string_view sentence, const GivenKeys& given = {},
                    std::string_view owner = {});

/// The key of one member, "search.limits.contact_ratio"; the member itself if there is none.
std::string spelled_member(std::string_view member, const GivenKeys& given = {});

}  // namespace gearwright
