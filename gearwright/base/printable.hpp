// Text of somebody else's where people read it: in a sentence, in a terminal.
#pragma once

#include <cstddef>
#include <string>

namespace gearwright {

constexpr std::size_t kLongText = 400;  ///< bytes of a title or a file's name that are shown

/// Control characters (those of ISO 6429 above 0x7F too) and bytes that are no UTF-8 are escaped, so
/// that a terminal shows them and does not obey; cut at a character after `most` bytes.
std::string printable(const std::string& text, std::size_t most = kLongText);

}  // namespace gearwright
