// Finds the nesting of a text before it is parsed. The parsers of TOML and of XML are recursive, so
// the stack would overflow if a text were nested deeply. Internal to spec/.
#pragma once

#include <optional>
#include <string_view>

namespace gearwright {

/// Returns the first line of a TOML text in which the nesting exceeds `most` levels, or none. Each
/// open bracket and each dot of a name is a level. The dot of a number also counts, up to the next
/// comma. Strings and comments do not count.
std::optional<int> deep_toml_line(std::string_view toml, int most);

/// True if the elements of an XML text are nested in more than `most` levels. The result is correct
/// up to the first syntax error, at which the parser ends.
bool has_deep_elements(std::string_view xml, int most);

}  // namespace gearwright
