#include "gearwright/job/row_listing.hpp"

#include <algorithm>

namespace gearwright {

std::size_t text_width(std::string_view text) {
  // The bytes that continue a character have the form 10xxxxxx.
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, text_width(text)), ' ');
}

std::string padded_left(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text_width(text)), ' ') + text;
}

std::string wrapped(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(first + 2, ' ');
  std::string lines(text.substr(0, first));
  std::size_t column = first;
  for (std::string_view rest = text.substr(first); !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (column > first) {
      const bool fits = column + 1 + text_width(word) <= kLineWidth;
      lines += fits ? " " : "\n" + indent;
      column = fits ? column + 1 : indent.size();
    }
    lines += word;
    column += text_width(word);
  }
  return lines + "\n";
}

}  // namespace gearwright
