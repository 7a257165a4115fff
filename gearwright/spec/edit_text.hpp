// Sets one key of a spec's TOML text to another value and leaves comments, order and blanks
// unchanged.
//
// The page uses this for its forms, and programs use it to change the files of a user.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// `path` has the form that errors use, "gear1.rack.dedendum". `value` is JSON text. Null removes
/// the key, and its line if the key has a line of its own.
///
/// An absent key is added at the end of its table. An absent table is added at the end of the text.
/// Keys of an inline table { … } are set inside the braces.
///
/// Errors    a text that is not TOML; a value that is not JSON; a path through a value that is not
///           a table
Result<std::string> with_key(std::string_view toml, std::string_view path, std::string_view value);

}  // namespace gearwright
