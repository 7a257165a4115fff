// Converts tolerances to numbers, and computes the gears at both ends of their tolerances and at every
// combination of the ends.
//
// Backlash, contact ratio, clearances, tip thickness and safeties are monotonic in each toleranced
// number over its small range. The worst value of each is therefore at a corner of the box of tolerances.
// Internal to arrange/.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// The input with allowances converted to numbers from DIN 3967, a span, or a dimension over balls.
///
/// Errors    `gearN.tolerance.…` if the series does not exist, if no tooth has the given reading, or if
///           the measuring tool is missing
Result<GivenPair> with_allowances(const GivenPair& given);

/// Computes the deviations of tip diameters that are given by a fit.
///
/// Errors    `gearN.tolerance.tip_fit` if the fit does not exist; `gearN.tip_diameter` beyond the table
std::optional<Error> apply_tip_fits(Arranged& nominal);

/// Gears and pair at both ends; none if there are no tolerances.
///
/// Errors    as arrange() at that end; `pair.backlash` if the tolerance of the centre distance
///           alone exceeds it; `pair.distance_tolerance`
Result<std::shared_ptr<const ArrangedEnds>> arrange_ends(const Arranged& nominal, Scope scope);

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

/// The gears and the pair at this corner.   Errors  as arrange()
Result<Arranged> at_corner(const Arranged& nominal, const std::vector<TolerancedNumber>& tolerances,
                           const ToleranceCorner& corner);

/// "At a centre distance of 59.985 mm and a thickness allowance of −0.02 mm on gear 1".
std::string corner_words(const std::vector<TolerancedNumber>& tolerances,
                         const ToleranceCorner& corner);

}  // namespace gearwright
