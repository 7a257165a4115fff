// Pieces of text that the writers of files share. Internal to cad/.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// So many decimals, without the zeros at their end, never "-0".
std::string short_decimal(double value, int decimals);

/// With & < > " as references; control characters, of which XML 1.0 has none, become spaces.
std::string xml_text(std::string_view text);

}  // namespace gearwright
