#include "gearwright/spec/text_depth.hpp"

#include <algorithm>
#include <vector>

namespace gearwright {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

// Returns the position after the next `end` at or after `at`, or the length of the text.
std::size_t after(std::string_view text, std::size_t at, std::string_view end) {
  at = text.find(end, at);
  return at == text.npos ? text.size() : at + end.size();
}

// Returns the position after the TOML string that begins at `at`. A string in single quotes has no
// escapes. A string in three quotes can contain line breaks, and can end in two more quotes.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
  const bool many_lines = text.substr(at).starts_with(three);
  for (std::size_t i = at + (many_lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (!many_lines && (text[i] == quote || text[i] == '\n')) {
      return text[i] == quote ? i + 1 : i;  // the parser rejects a line break
    } else if (many_lines && text.substr(i).starts_with(three)) {
      std::size_t end = i + 3;
      while (end < text.size() && end < i + 5 && text[end] == quote) ++end;
      return end;
    }
  }
  return text.size();
}

// The end of an XML element's start tag.
struct TagEnd {
  std::size_t at;  // position of '>', or npos if the tag has a syntax error
  bool empty;      // true if the element has no content, <name/>
};

// The tag begins at `at`. Names can contain quotes, and values can contain '>'.
TagEnd end_of_tag(std::string_view xml, std::size_t at) {
  at = xml.find_first_of(" \t\r\n/>?", at + 1);
  for (;;) {
    at = xml.find_first_of("=>", at);
    if (at == xml.npos || xml[at] == '>') return {at, at != xml.npos && xml[at - 1] == '/'};
    const std::size_t value = xml.find_first_not_of(kBlanks, at + 1);
    if (value == xml.npos || (xml[value] != '"' && xml[value] != '\'')) return {xml.npos, false};
    at = xml.find(xml[value], value + 1);
    if (at == xml.npos) return {xml.npos, false};
    ++at;
  }
}

}  // namespace

std::optional<int> deep_toml_line(std::string_view toml, int most) {
  int line = 1;
  int depth = 0;
  std::vector<int> dots{0};  // for the text outside all brackets and for each open bracket
  for (std::size_t i = 0; i < toml.size();) {
    const char c = toml[i];
    if (c == '"' || c == '\'') {
      const std::size_t end = after_string(toml, i);
      const std::string_view inside = toml.substr(i, end - i);
      line += static_cast<int>(std::count(inside.begin(), inside.end(), '\n'));
      i = end;
      continue;
    }
    if (c == '#') {
      i = std::min(toml.find('\n', i), toml.size());
      continue;
    }
    ++i;
    if (c == '\n') ++line;
    if (c == ',' || (c == '\n' && dots.size() == 1)) {
      depth -= dots.back();
      dots.back() = 0;
    } else if ((c == ']' || c == '}') && dots.size() > 1) {
      depth -= dots.back() + 1;
      dots.pop_back();
    } else if (c == '[' || c == '{') {
      dots.push_back(0);
      ++depth;
    } else if (c == '.') {
      ++dots.back();
      ++depth;
    }
    if (depth > most) return line;
  }
  return std::nullopt;
}

bool has_deep_elements(std::string_view xml, int most) {
  int depth = 0;
  for (std::size_t at = 0; (at = xml.find('<', at)) != xml.npos;) {
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<!--")) {
      at = after(xml, at + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = after(xml, at + 9, "]]>");
    } else if (rest.starts_with("<?")) {
      at = after(xml, at + 2, "?>");
    } else if (rest.starts_with("<!")) {
      at = after(xml, at + 2, ">");
    } else if (rest.starts_with("</")) {
      --depth;
      at = after(xml, at + 2, ">");
    } else {
      const TagEnd end = end_of_tag(xml, at);
      if (end.at == xml.npos) return false;
      if (!end.empty && ++depth > most) return true;
      at = end.at;
    }
  }
  return false;
}

}  // namespace gearwright
