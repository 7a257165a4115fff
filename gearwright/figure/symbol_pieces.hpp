// A symbol as our texts write it, "d_Ff", "h_aP*", "C_βI = C_βII", in the pieces that are set.
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

/// A subscript runs from '_' over letters, digits and UTF-8 bytes; '*' stands above.
std::vector<SymbolPiece> symbol_pieces(std::string_view symbol);

}  // namespace gearwright
