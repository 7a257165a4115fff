// Sets one key of a spec's TOML text to another value and leaves comments, order and blanks
// unchanged.
//
// Forms on the page use it for the text, and programs for the files of a user.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// `path` is that of errors, "gear1.rack.dedendum". `value` is JSON text. Null removes the key,
/// with its line if it has its own.
///
/// A key that is absent is put at the end of its table; a table that is absent at the end of the
/// text. Keys inside an inline table { … } are set there.
///
/// Errors    a text that is not TOML; a value that is not JSON; a path through a value that is not
///           a table
Result<std::string> with_key(std::string_view toml, std::string_view path, std::string_view value);

}  // namespace gearwright
