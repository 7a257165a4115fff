// Inputs that users may expect and that are not supported. The message states this, or names the
// equivalent key, instead of suggesting a known key with a similar name.
#pragma once

#include <string_view>

namespace gearwright {

/// The sentence about a key by its path in the file, "gear2.form"; about a known key with a value:
/// "gear2.teeth", "0". Empty if there is none.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
