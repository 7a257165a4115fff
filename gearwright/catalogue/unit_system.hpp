// The system of units of a spec and its answer. The catalogue is written in mm. For a spec in inch, every key, value
// and sentence is converted by the unit at the end of its key. No key and no quantity is defined twice.
//
//   mm    _mm   _um    _per_mm   _per_um    _mm_per_rad   _mm_per_turn
//   inch  _in   _uin   _per_in   _per_uin   _in_per_rad   _in_per_turn     1 in = 25.4 mm, 1 µin = 0.0254 µm
//
// Modules are always in mm, diametral pitches always in 1/in. Angles and all units that contain N, kg, s or K
// (N, N m, N/mm, N/mm², kg, m/s) are the same in both systems.
#pragma once

#include <string>
#include <string_view>

#include "gearwright/catalogue/term.hpp"

namespace gearwright {

enum class UnitSystem { mm, inch };  ///< the order of the words of the key `units`

/// The words of the key `units`.
std::string_view to_string(UnitSystem units);

/// The unit that replaces a unit of the catalogue in this system: Unit::inch for Unit::mm.
Unit unit_in(UnitSystem units, Unit unit);
/// A value in the unit that replaces `unit`. Of the numbers that equal it within rounding, it is the one with the
/// fewest digits.
double value_in(UnitSystem units, Unit unit, double value);
/// The decimals for users of a value with this many decimals in `unit`, so that its resolution is at least as fine.
int digits_in(UnitSystem units, Unit unit, int digits);

/// A value with this many decimals in `unit`, as text in the unit that replaces it: "1.0000" or "0.03937" for 1 mm.
std::string text_in(UnitSystem units, Unit unit, double value, int decimals);
/// The text of the unit that replaces `unit`: "mm" or "in".
std::string_view unit_text(UnitSystem units, Unit unit);

/// The ratio of two units of length that are called differently in the two systems.
struct KeyUnit {
  std::string_view metric, inch;  ///< endings of a key, "_mm" and "_in"
  long double size;               ///< size of the inch unit in the metric unit
  bool inverse;                   ///< true for units 1/length

  /// The value in the inch unit, and back. Each result is the shortest of the numbers that the other function
  /// converts to the same double.
  double to_inch(double metric_value) const;
  double to_metric(double inch_value) const;
};

/// The unit of a key or of a path of keys, "gear1.face_width_mm" or "gear1.measured.span_mm.3", if it is a length of the
/// catalogue and therefore depends on the system. Null for other keys.
const KeyUnit* metric_unit(std::string_view key);
/// The unit of a key in an inch spec, "gear1.face_width_in". Null for keys whose unit does not depend on the system.
const KeyUnit* inch_unit(std::string_view key);

/// True if the numbers of this key have the unit of the key of their table, as `3` in span_mm = { 3 = 19.751 }.
bool is_in_unit_of_table(std::string_view key);

/// The name of a key or a path of the catalogue in this system: "face_width_in" for "face_width_mm".
std::string key_in(UnitSystem units, std::string_view key);
/// The name in the catalogue of a key of an inch spec: "face_width_mm" for "face_width_in".
std::string metric_key(std::string_view key);

/// A sentence in this system: numbers before " mm" and " µm", names of keys, and numbers behind "key = " are
/// converted. If `of` is the unit of the key that the sentence is about, numbers without a unit behind "between",
/// "than", "least" and similar words are converted too. A second call changes nothing.
std::string sentence_in(UnitSystem units, std::string_view sentence, const KeyUnit* of = nullptr);

/// A text of numbers in this unit, "[99, 101]", in the unit that replaces it.
std::string numbers_in(UnitSystem units, std::string_view text, const KeyUnit& unit);

}  // namespace gearwright
