// The system of units of a spec and its answer. The catalogue is written in mm. For a spec in inch,
// keys, values and sentences are converted. The unit at the end of a key determines the conversion.
//
//   mm    _mm   _um    _per_mm   _per_um    _mm_per_rad   _mm_per_turn      1 in = 25.4 mm
//   inch  _in   _uin   _per_in   _per_uin   _in_per_rad   _in_per_turn      1 µin = 0.0254 µm
//
// Modules are always in mm, and diametral pitches always in 1/in. Angles and all units that contain
// N, kg, s or K (N, N m, N/mm, N/mm², kg, m/s) are the same in both systems.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/term.hpp"

namespace gearwright {

enum class UnitSystem { mm, inch };  ///< the order of the words of the key `units`

std::string_view to_string(UnitSystem units);

/// Returns the units of the catalogue that the inch system replaces.
std::vector<Unit> units_to_convert();
/// Returns the unit that replaces a unit of the catalogue in this system, for example inch for mm.
Unit unit_in(UnitSystem units, Unit unit);
/// Returns a value in the unit that replaces `unit`. The result is the number with the fewest
/// digits that equals the exact value within rounding.
double value_in(UnitSystem units, Unit unit, double value);
/// Returns the number of decimals shown to users, for a value with `digits` decimals in `unit`. It
/// is `digits` + 1 in inch, and `digits` in lb. In µin or 1/in it is `digits` − 1, but never less
/// than 0. If `digits` is not 0, the resolution changes by a factor of less than 4.
int digits_in(UnitSystem units, Unit unit, int digits);

/// Returns the text of a value in the unit that replaces `unit`, with the number of decimals of
/// digits_in(). For 1 mm and 4 decimals, the text is "1.0000" in mm and "0.03937" in inch.
std::string text_in(UnitSystem units, Unit unit, double value, int decimals);
/// Returns the text of the unit that replaces `unit`, for example "mm" or "in".
std::string_view unit_text(UnitSystem units, Unit unit);

/// A unit of length of the metric system and the unit that replaces it in the inch system.
struct KeyUnit {
  std::string_view metric, inch;  ///< endings of a key, "_mm" and "_in"
  long double size;               ///< size of the inch unit, in metric units
  bool inverse;                   ///< true for units 1/length

  /// These functions convert a value to the inch unit and back. A number in inch with up to 12
  /// digits does not change if to_metric() and then to_inch() convert it.
  double to_inch(double metric_value) const;
  double to_metric(double inch_value) const;
};

/// Returns the unit of a key or of a path of keys, for example of "gear1.measured.span_mm.3".
/// Returns null if the unit is the same in both systems.
const KeyUnit* metric_unit(std::string_view key);
/// Returns the unit of a key in an inch spec, for example of "gear1.face_width_in". Returns null
/// for keys whose unit is the same in both systems.
const KeyUnit* inch_unit(std::string_view key);

/// True if the numbers under this key have the unit that the key of the enclosing table names. An
/// example is the key `3` in span_mm = { 3 = 19.751 }.
bool is_in_unit_of_table(std::string_view key);

/// Returns the name of a key or a path of the catalogue in this system. For example,
/// "face_width_mm" becomes "face_width_in" in inch.
std::string key_in(UnitSystem units, std::string_view key);
/// Returns the name that a key of an inch spec has in the catalogue. For example, "face_width_in"
/// becomes "face_width_mm".
std::string metric_key(std::string_view key);

/// Returns a sentence in this system. The function converts names of keys, numbers before " mm" or
/// " µm", and numbers after "key = ". If the sentence is about a key with the unit `of`, numbers
/// without a unit after "between", "than", "least" and similar words are also converted. A second
/// call changes nothing.
std::string sentence_in(UnitSystem units, std::string_view sentence, const KeyUnit* of = nullptr);

/// Converts a text of numbers in this unit, such as "[99, 101]", to the unit that replaces it.
std::string numbers_in(UnitSystem units, std::string_view text, const KeyUnit& unit);

}  // namespace gearwright
