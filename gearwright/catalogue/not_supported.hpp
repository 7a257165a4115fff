// What people write for what does not exist here: instead of a known key that is spelt alike they
// get one sentence that says so, or how the same thing is written.
#pragma once

#include <string_view>

namespace gearwright {

/// The sentence about a key by its path in the file, "gear2.form"; about a known key with a value as
/// shown: "gear2.teeth", "0". Empty: there is none.
std::string_view not_supported(std::string_view path, std::string_view value = {});

}  // namespace gearwright
