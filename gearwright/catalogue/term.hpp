// Terms: the name, the symbol and the unit of a quantity, written once for all tables of results.
//
//   Unit   the unit of a value, as the suffix of its key and as the user reads it
//   Type   the type of a value
//   Term   key, words (the standard's term) and symbol of a quantity that occurs in several tables
#pragma once

#include <span>
#include <string_view>

namespace gearwright {

enum class Unit {
  none,
  mm,
  um,
  deg,
  arcsec,
  per_mm,
  mm_per_rad,
  m_per_s,
  newton,
  newton_metre,
  kilowatt,
  megapascal,
  per_minute,
  hertz,
  newton_per_mm,
  newton_per_mm_um,  ///< stiffness of a mesh per face width
  newton_per_um,
  celsius,
  kg,
  kg_per_mm,
  modules,          ///< normal modules; no unit for people
  modules_squared,  ///< of a region of two shifts
  percent           ///< a share of 1; people read 100 times it
};

enum class Type {
  number,
  whole,
  index,  ///< a whole number that may pass 2³¹
  flag,
  word,
  text,
  record,
  map
};

/// "mm", "°", "µm"; empty for pure numbers.
std::string_view unit_text(Unit unit);
/// The suffix of keys in this unit: "_mm", "_deg"; empty for units without a suffix.
std::string_view unit_suffix(Unit unit);
/// The unit given by the suffix of the key; Unit::none for other keys.
Unit unit_of(std::string_view key);
/// Decimals that people read: 4 of mm (0.1 µm, the last digit of a gear drawing), 5 of degrees
/// (0.17 µm on a radius of 1 m) and of pure numbers.
int unit_digits(Unit unit);

struct Term {
  const char *key, *words, *symbol = "";
  Type type = Type::number;
};

std::span<const Term> terms();  ///< by key
/// Domain  the key of a term (contract)
const Term& term_of(std::string_view key);

}  // namespace gearwright
