#include "gearwright/figure/symbol_pieces.hpp"

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

}  // namespace gearwright
