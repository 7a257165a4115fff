// Terms: the name, the symbol and the unit of a quantity, defined once for all tables of results.
//
//   Unit   the unit of a value, as the suffix of a key and as text for users
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
  modules,          ///< normal modules; no unit is shown to users
  modules_squared,  ///< area of a region of two profile shifts
  percent,          ///< a share from 0 to 1, shown to users as a percentage
  hour,
  vickers,
  kg_per_m3,
  mm2_per_s,
  m2_kelvin_per_watt,
  square_metre,
  inch,  ///< this unit and the units below occur only in results of specs in inch
  microinch,
  per_inch,
  inch_per_rad,
  pound
};

enum class Type {
  number,
  whole,
  index,  ///< a whole number that may exceed 2³¹
  flag,
  word,
  text,
  record,
  map
};

/// Returns "mm", "°", "µm" and so on, or "" for a pure number.
std::string_view unit_text(Unit unit);
/// Returns the suffix of keys in this unit, "_mm" or "_deg", or "" if the unit has no suffix.
std::string_view unit_suffix(Unit unit);
/// Returns the unit that the suffix of the key names, or Unit::none if there is no such suffix.
Unit unit_of(std::string_view key);
/// Returns the number of decimals for users. It is 4 for mm (0.1 µm, the last digit of a gear
/// drawing), and 5 for degrees (0.17 µm on a radius of 1 m) and for pure numbers.
int unit_digits(Unit unit);

struct Term {
  const char *key, *words, *symbol = "";
  Type type = Type::number;
};

std::span<const Term> terms();  ///< sorted by key
/// Returns the term with this key.   Domain  `key` is the key of a term (contract)
const Term& term_of(std::string_view key);

}  // namespace gearwright
