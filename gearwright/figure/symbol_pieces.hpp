// Splits a symbol as written in texts, such as "d_Ff", "h_aP*" or "C_βI = C_βII", into pieces for
// formatting.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

bool is_letter_or_digit(char c);

struct SymbolPiece {
  enum class Place { base, below, above };
  std::string text;
  Place place;
};

/// A subscript extends from '_' over letters, digits and UTF-8 bytes. '*' is a superscript.
std::vector<SymbolPiece> symbol_pieces(std::string_view symbol);

}  // namespace gearwright
