#include "gearwright/base/printable.hpp"

#include <fmt/format.h>

namespace gearwright {

std::string printable(const std::string& text, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < text.size() && out.size() < most; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    // Takes whole characters only. The first byte of a character gives its length (UTF-8).
    const std::size_t length = byte < 0x80   ? 1
                               : byte < 0xC0 ? 0
                               : byte < 0xE0 ? 2
                               : byte < 0xF0 ? 3
                                             : 4;
    if (length == 0 || i + length > text.size()) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    bool whole = true;
    for (std::size_t k = 1; k < length; ++k)
      whole = whole && (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    // The control characters U+0080 to U+009F are C2 followed by a byte below A0.
    const bool control = byte == 0xC2 && whole && static_cast<unsigned char>(text[i + 1]) < 0xA0;
    if (whole && !control) {
      out += text.substr(i, length);
      i += length - 1;
    } else {
      out += fmt::format("\\x{:02x}", byte);
    }
  }
  return out.size() < most ? out : out + "...";
}

}  // namespace gearwright
