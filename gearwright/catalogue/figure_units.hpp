// Converts a finished figure to another system of units. The unit of an axis determines the
// conversion of its values.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// Converts values whose unit is given as text. Values are converted only if the text begins with a
/// unit of the catalogue for lengths, or with the square of such a unit ("mm²"). A comma and words
/// may follow the unit.
class TextUnit {
 public:
  TextUnit(UnitSystem units, std::string_view unit);

  double operator()(double value) const;
  int digits(int decimals) const;  ///< decimals to show, from digits_in()
  std::string text() const;        ///< "in", "in²"

 private:
  UnitSystem units_;
  Unit unit_ = Unit::none;
  int power_ = 1;
  std::string rest_;  ///< text after the unit; the whole text if the unit does not change
};

/// Returns the figure with all lengths in this system: points, axes, grid, and lengths in texts.
///
/// Laws      (1) the picture of a plane figure differs only in its texts
///           (2) units without a length, such as ° and N/mm², are unchanged
///           (3) a second call with the same units changes nothing
Figure in_units(UnitSystem units, Figure figure);
std::optional<Figure> in_units(UnitSystem units, std::optional<Figure> figure);

}  // namespace gearwright
