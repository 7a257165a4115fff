// The position of a member in a valid JSON text.
//
// Internal to spec/.
#pragma once

#include <optional>
#include <string_view>

#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

/// The position of the key. If the key does not exist, the result is the position of the last table
/// or element of the path that exists. There is no result if the first part of the path does not
/// exist.
std::optional<TextPlace> json_place(std::string_view text, std::string_view path);

}  // namespace gearwright
