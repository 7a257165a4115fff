// Where a member stands in a JSON text that is known to be one.
//
// Internal to spec/.
#pragma once

#include <optional>
#include <string_view>

#include "gearwright/spec/spec_text.hpp"

namespace gearwright {

/// The place of the key, or of the last table or element on the way to it that is there; none where
/// the first is not.
std::optional<TextPlace> json_place(std::string_view text, std::string_view path);

}  // namespace gearwright
