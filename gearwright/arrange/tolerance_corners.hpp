// A nominal state at the combinations of the ends of its tolerances.
//
// Backlash, contact ratio, clearances, tip thickness and safeties are monotonic in each toleranced
// number over its small range, so that the worst of each lies at a corner of the box of tolerances.
// Internal to arrange/.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// One toleranced number.
struct TolerancedNumber {
  enum class Of { thickness, tip, distance } of;
  int gear;   ///< 1, 2; 0 for the pair
  Ends ends;  ///< mm: thickness allowance, tip diameter, centre distance
};

/// The tolerances; empty if there are none.
std::vector<TolerancedNumber> tolerances_of(const Arranged& nominal);

/// For each tolerance the end that applies, 0 or 1; none for its nominal value.
using ToleranceCorner = std::vector<std::optional<std::size_t>>;

/// All combinations of ends.
std::vector<ToleranceCorner> corners_of(const std::vector<TolerancedNumber>& tolerances);

/// The nominal state at this corner.   Errors  as arrange()
Result<Arranged> at_corner(const Arranged& nominal, const std::vector<TolerancedNumber>& tolerances,
                           const ToleranceCorner& corner);

/// "At a centre distance of 59.985 mm and a thickness allowance of −0.02 mm on gear 1".
std::string corner_words(const std::vector<TolerancedNumber>& tolerances,
                         const ToleranceCorner& corner);

}  // namespace gearwright
