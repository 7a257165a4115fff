// Text functions that several writers of files use. Internal to cad/.
#pragma once

#include <string>
#include <string_view>

namespace gearwright {

/// Writes & < > as references. Control characters, which XML 1.0 does not permit, are replaced by
/// spaces.
std::string xml_text(std::string_view text);

}  // namespace gearwright
