// Strength and mass of a design. The pair is rated by ISO 6336, as by the verb `rate`.
//
//   S_H, S_F   safety factors of flank and root of each gear, at the shifts of the design
//
// The rating uses values of a mounted pair. If the path of contact of a design lies on involute flanks,
// all these values have a closed form (for an internal gear with the data of its cutter,
// design/ring_cuts.hpp). For other designs (undercut, or with tips that pass the start of a flank) the
// gears are cut and mounted, which takes a hundred times as long.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <optional>

#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// The pair of a design for the rating, from closed forms if possible, otherwise from mounted gears.
///
/// Errors    as make_gear, mount, rated_pair
/// Accuracy  both methods agree to 1e-12 (design/design_strength_test.cpp)
Result<RatedPair> pair_of_design(const ShiftGraph& graph, const DesignRow& row);
/// The pair of a design, computed from gears that are cut and mounted.
Result<RatedPair> mounted_design(const ShiftGraph& graph, const DesignRow& row);
/// The row with its safety factors. The face width is the least in the band with which the safety
/// factors are sufficient, or the greatest if none is sufficient. If drawings are checked, the verdict
/// over the drawing is included.
DesignRow rated(const ShiftGraph& graph, DesignRow row);
/// The first limit that the row violates: a safety factor that is too low or has no value, or the
/// verdict. None if the row meets all limits.
std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row);
/// The least of S_H/S_Hmin and S_F/S_Fmin of both gears, with 1 as the default for an absent limit;
/// none if the row has no safety factors.
std::optional<double> least_safety(const SearchProblem& problem, const DesignRow& row);
/// Mass of both gears, kg. An external gear is a full cylinder of the mean diameter (d_a + d_f)/2, as
/// for the reduced mass of ISO 6336-1. An internal gear extends from the mean diameter to 2.5 m_n
/// outside its root circle. [T9.12]
double mass_of(const ShiftGraph& graph, const DesignRow& row);

}  // namespace gearwright
