// The position of a member in a valid JSON text.
//
// Internal to spec/.
#pragma once

#include <optional>
#include <string_view>

#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

/// The position of the key, or of the last existing table or element on the path; none if the first
/// does not exist.
std::optional<TextPlace> json_place(std::string_view text, std::string_view path);

}  // namespace gearwright
