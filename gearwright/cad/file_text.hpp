// Text functions common to the writers of files. Internal to cad/.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// With & < > " as references; control characters, of which XML 1.0 has none, become spaces.
std::string xml_text(std::string_view text);

}  // namespace gearwright
