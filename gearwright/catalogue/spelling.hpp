// What the door to a spec file does with an error of the library: it puts the file's keys in place
// of the members of structs, and leaves the sentence as it is.
//
//   gear1.tip_diameter = 10: must be greater than the root diameter 35 mm
//   gear1.tip_diameter_mm = 10: must be greater than the root diameter 35 mm
//
// Members that a sentence names stand between backticks; they are looked for beside the member that
// the error is about, then in the tables around it.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// Paths of the keys that a spec gives, "gear1.left_tip_relief_um": where several keys set one
/// member, the error is about the one that was given.
using GivenKeys = std::set<std::string, std::less<>>;

/// With keys for members; what is no member of an input stays, so that spelling twice does nothing.
Error spelled(const Error& error, const GivenKeys& given = {});

/// A sentence about `owner`, "gear1"; empty: about the spec.
std::string spelled(std::string_view sentence, const GivenKeys& given = {},
                    std::string_view owner = {});

/// The key of one member, "search.limits.contact_ratio"; itself where there is none.
std::string spelled_member(std::string_view member, const GivenKeys& given = {});

}  // namespace gearwright
