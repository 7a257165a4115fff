// Text functions common to the writers of files. Internal to cad/.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// Writes & < > as references, and control characters, which XML 1.0 does not permit, as spaces.
std::string xml_text(std::string_view text);

}  // namespace gearwright
