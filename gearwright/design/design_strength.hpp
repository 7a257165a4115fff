// Strength and mass of a design: its pair is rated by ISO 6336 in the same way as by the verb
// `rate`.
//
//   S_H, S_F   safeties of flank and root of each gear, at the design's own shifts
//
// The rating needs numbers of a mounted pair. If the path of contact of a design lies on flanks
// that the rack cut straight, they all have a closed form (for an internal gear with the data of
// its cutter, design/ring_cuts.hpp). For other designs (undercut, or with tips that pass the start
// of a flank) the gears are cut and mounted, at a hundred times the cost.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <optional>

#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// The pair of a design for the rating.
///
/// Errors    as make_gear, mount, rated_pair
/// Accuracy  both ways agree to 1e-12 (design/design_strength_test.cpp)
Result<RatedPair> pair_of_design(const ShiftGraph& graph, const DesignRow& row);
/// The same pair, computed from gears that are cut and mounted.
Result<RatedPair> mounted_design(const ShiftGraph& graph, const DesignRow& row);

/// The row with the required safety factors, at the least face width of its band that reaches them
/// (the greatest if none does), and with the verdict over its drawing if drawings are checked.
DesignRow rated(const ShiftGraph& graph, DesignRow row);

/// The limit that the row violates: a safety that is too low or has no number, or the verdict;
/// none if it meets all.
std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row);

/// The least of S_H/S_Hmin, S_F/S_Fmin of both gears, 1 for a default limit; none if the row has no
/// safety factors.
std::optional<double> least_safety(const SearchProblem& problem, const DesignRow& row);

/// Mass of both gears, kg. A gear is a full cylinder of the mean diameter (d_a + d_f)/2, as for the
/// reduced mass of ISO 6336-1. An internal gear extends from there to 2.5 m_n outside its root.
/// [T9.12]
double mass_of(const ShiftGraph& graph, const DesignRow& row);

}  // namespace gearwright
