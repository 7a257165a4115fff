// Converts tolerances to numbers. Computes the gears at both ends of their tolerances and at
// every combination of the ends. Internal to arrange/.
//
// The two ends of a tolerance are its least and its greatest permitted value. Within the small
// range of a tolerance, backlash, contact ratio, clearances, tip thickness and safeties are
// monotonic in each toleranced number. The least and the greatest value of each quantity therefore
// occur at a combination of ends, which is called a corner. For example, the tip is thinnest on a
// thin tooth with a great tip diameter. This combination is neither of the two ends of the gear,
// because one end has the thinnest tooth with the shortest tip, and the other end has the thickest
// tooth with the longest tip.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// Returns the input with numerical allowances in place of a DIN 3967 series, a span, or a
/// dimension over balls.
///
/// Errors    `gearN.tolerance.…` if the series does not exist, if no tooth has the given dimension,
///           if the measuring tool is missing, if circular-arc flanks are measured, or if the
///           mating gear or the base cylinder determines the tooth thickness;
///           `gearN.measure.span_teeth` as span_over(); the errors of arrange()
Result<GivenPair> with_allowances(const GivenPair& given);

/// Computes the deviations of each tip diameter whose tolerance is given as a fit.
///
/// Errors    `gearN.tolerance.tip_fit` if the fit does not exist; `gearN.tip_diameter` if the
///           diameter is outside the table of fits
std::optional<Error> apply_tip_fits(Arranged& nominal);

/// Returns gears and pair at both ends. `nominal.given` is the unchanged input. Returns none if
/// there are no tolerances.
///
/// Errors    as arrange() for the gears at one end, with the field of the tolerance that causes the
///           error; `gearN.tolerance.tip_…` if the tip has a fillet; `pair.distance_…` if a gear
///           has `cut_by`; `pair.backlash` if the tolerance of the centre distance alone changes
///           the backlash by more than the given range of the backlash; `pair.distance_tolerance`
///           if ISO 286 has no such tolerance
Result<std::shared_ptr<const ArrangedEnds>> arrange_ends(const Arranged& nominal, Scope scope);

struct TolerancedNumber {
  enum class Of { thickness, tip, distance } of;
  int gear;   ///< 1 or 2; 0 for the pair
  Ends ends;  ///< least and greatest thickness allowance, tip diameter or centre distance, mm
  bool excludes_nominal;  ///< true if the nominal tip diameter or centre distance is not between
                          ///< `ends`
};

std::vector<TolerancedNumber> tolerances_of(const Arranged& nominal);

/// True if the nominal tip diameter of a gear or the nominal centre distance lies outside its
/// tolerance, for example with the deviations 0.05 mm and 0.1 mm.
bool tolerances_exclude_nominal(const Arranged& nominal);

/// For each toleranced number, the end to use (0 or 1), or none for the nominal value.
using ToleranceCorner = std::vector<std::optional<std::size_t>>;

/// Returns all combinations of ends.
std::vector<ToleranceCorner> corners_of(const std::vector<TolerancedNumber>& tolerances);

/// Returns the gears and the pair at one corner.   Errors  as arrange()
Result<Arranged> at_corner(const Arranged& nominal, const std::vector<TolerancedNumber>& tolerances,
                           const ToleranceCorner& corner);

/// Returns the gears and the pair at those corners that can be arranged. The list is empty if fewer
/// than two numbers have a tolerance, because the corners of one tolerance are the two ends.
std::vector<Arranged> arranged_corners(const Arranged& nominal);

/// Returns a corner in words, for example "At a centre distance of 59.985 mm and a thickness
/// allowance of −0.02 mm on gear 1".
std::string corner_words(const std::vector<TolerancedNumber>& tolerances,
                         const ToleranceCorner& corner);

/// Returns the result of arrange() without `ends` and `given`. Gears and pair are computed at the
/// mean of their tolerances. If allowances are given by a series or a measurement, the caller must
/// first convert them to numbers by with_allowances().
Result<Arranged> arrange_nominal(const GivenPair& given, Scope scope);

}  // namespace gearwright
