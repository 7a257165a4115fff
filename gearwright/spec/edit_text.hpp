// One key of a spec's TOML text set to another value, the rest left as it is: comments, order, blanks.
//
// What a form does to the text beside it, and what a program does to a file that a person keeps.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// `path` as errors name keys, "gear1.rack.dedendum"; `value` as JSON text, null: the key is taken
/// out, with its line where it has one of its own.
///
/// A key that is absent is put at the end of its table; a table that is absent at the end of the
/// text. Keys inside an inline table { … } are set there.
///
/// Errors    a text that is no TOML; a value that is no JSON; a path through something that is no table
Result<std::string> with_key(std::string_view toml, std::string_view path, std::string_view value);

}  // namespace gearwright
