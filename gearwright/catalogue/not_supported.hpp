// Inputs that users may expect but that are not supported. The message states this, or names the
// equivalent key. Otherwise a known key with a similar name would be suggested.
#pragma once

#include <string_view>

namespace gearwright {

/// The sentence about an unknown key with this path in the file, "gear2.form", or about a known key
/// with a value, "gear2.teeth" and "0". It is empty if there is no such sentence.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
