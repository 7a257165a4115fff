#include "gearwright/figure/markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"

namespace gearwright {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::vector<SymbolPiece> symbol_pieces(std::string_view symbol) {
  using Place = SymbolPiece::Place;
  std::vector<SymbolPiece> pieces;
  Place place = Place::base;
  for (std::size_t i = 0; i < symbol.size(); ++i) {
    const char c = symbol[i];
    if (c == '_') {
      place = Place::below;
      pieces.push_back({"", place});
      continue;
    }
    // A comma between letters belongs to the index, as in "ε_α,eff", but not in "k_1, k_2".
    const bool comma = c == ',' && i + 1 < symbol.size() && symbol[i + 1] != ' ';
    const bool word = is_letter_or_digit(c) || comma || static_cast<unsigned char>(c) >= 0x80;
    if (c == '*') {
      pieces.push_back({"*", Place::above});
      place = Place::base;
      continue;
    }
    if (place == Place::below && !word) place = Place::base;
    if (pieces.empty() || pieces.back().place != place) pieces.push_back({"", place});
    pieces.back().text += c;
  }
  return pieces;
}

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      case '\n':
      case '\t': result += c; break;
      case '\r': break;  // the line feed that follows ends the line
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
          result += "\xEF\xBF\xBD";
        } else {
          result += c;
        }
    }
  }
  return result;
}

std::string with_minus(std::string_view markup) {
  std::string text;
  bool tag = false;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    tag = c == '<' || (tag && c != '>');
    const bool digit = i + 1 < markup.size() && markup[i + 1] >= '0' && markup[i + 1] <= '9';
    if (c != '-' || tag || !digit || (i > 0 && is_letter_or_digit(markup[i - 1])))
      text += c;
    else
      text += "−";
  }
  return text;
}

std::string fixed(const std::optional<double>& value, int decimals) {
  return value && std::isfinite(*value) ? fixed_decimals(*value, decimals) : std::string(kNoValue);
}

std::string counted(std::int64_t n) {
  std::string text = std::to_string(n);
  for (auto at = static_cast<int>(text.size()) - 3; at > (n < 0 ? 1 : 0); at -= 3)
    text.insert(static_cast<std::size_t>(at), "\u202f");  // a narrow no-break space
  return text;
}

std::string percent(double share) { return fixed(100 * std::abs(share), 0); }

std::string symbol_html(std::string_view symbol) {
  using Place = SymbolPiece::Place;
  std::string result;
  for (const SymbolPiece& piece : symbol_pieces(symbol)) {
    switch (piece.place) {
      case Place::base: result += "<var>" + piece.text + "</var>"; break;
      case Place::below: result += "<sub>" + piece.text + "</sub>"; break;
      case Place::above: result += "<sup>" + piece.text + "</sup>"; break;
    }
  }
  return result;
}

std::string symbol_svg(std::string_view symbol) {
  using Place = SymbolPiece::Place;
  std::string result;
  int shift = 0;  // shift of the baseline, px down
  for (const SymbolPiece& piece : symbol_pieces(symbol)) {
    const int wanted = piece.place == Place::base ? 0 : piece.place == Place::below ? 3 : -4;
    const char* style = wanted == 0 ? "v" : "s";
    result += fmt::format("<tspan class=\"{}\"", style);
    if (wanted != shift) result += fmt::format(" dy=\"{}\"", wanted - shift);
    result += ">" + piece.text + "</tspan>";
    shift = wanted;
  }
  if (shift != 0) result += fmt::format("<tspan dy=\"{}\">\xE2\x80\x8B</tspan>", -shift);
  return result;
}

std::string with_symbols(std::string_view text) {
  const auto in_word = [](char c) {
    return is_letter_or_digit(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
  };
  std::string result;
  while (!text.empty()) {
    std::size_t n = 0;
    while (n < text.size() && in_word(text[n])) ++n;
    const std::string_view word = text.substr(0, n);
    const std::size_t low = word.find('_');
    const bool symbol = low != word.npos && low + 1 < n &&
                        character_count(word.substr(0, low)) == 1 &&
                        word.find('_', low + 1) == word.npos;
    result += symbol ? symbol_html(word) : escaped(word);
    text.remove_prefix(n);
    result += escaped(text.substr(0, 1));
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
  }
  return result;
}

std::string without_tags(std::string_view markup) {
  std::string text;
  bool tag = false;
  for (const char c : markup) {
    if (c == '<') tag = true;
    if (!tag) text += c;
    if (c == '>') tag = false;
  }
  return text;
}

std::string captioned(std::string_view picture, std::string_view caption,
                      std::string_view attributes) {
  return fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>\n", attributes, picture,
                     with_minus(caption));
}

std::string caption_key(std::string_view swatch, std::string_view words) {
  return fmt::format("<span class=\"key\"><i class=\"swatch {}\"></i>{}</span>", swatch, words);
}

}  // namespace gearwright
