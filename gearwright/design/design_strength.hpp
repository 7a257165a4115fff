// Strength and mass of a design: its pair is rated by ISO 6336 in the same way as by the verb
// `rate`.
//
//   S_H, S_F   safeties of flank and root of each gear, at the design's own shifts
//
// The rating room takes numbers of a mounted pair. A design whose path of contact lies on flanks
// that the rack cut straight has them all in closed form, with an internal gear those that its cutter
// leaves (design/ring_cuts.hpp); of others (undercut ones, tips that pass the start of a flank) the
// gears are cut and mounted, at a hundred times the cost.
//                                              theory: docs/theory/09-design-search.md, 9.7
#pragma once

#include <optional>

#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// The pair of a design as the rating takes it.
///
/// Errors    as make_gear, mount_involutes, rated_pair
/// Accuracy  both ways agree to 1e-12 (design/design_strength_test.cpp)
Result<RatedPair> pair_of_design(const ShiftGraph& graph, const DesignRow& row);
/// The same by gears that are cut and mounted.
Result<RatedPair> mounted_design(const ShiftGraph& graph, const DesignRow& row);

/// The row with the safety factors that the problem requires, at the least face width of its band that
/// has them (the greatest if none has them), and with the verdict over its drawing if designs are
/// drawn.
DesignRow rated(const ShiftGraph& graph, DesignRow row);

/// The limit of safety that the row falls short of, or has no number for, or the verdict; none: it
/// holds.
std::optional<Limit> short_of(const SearchProblem& problem, const DesignRow& row);

/// The least of S_H/S_Hmin, S_F/S_Fmin of both gears, 1 for a default limit; none if the row has no
/// safety factors.
std::optional<double> least_safety(const SearchProblem& problem, const DesignRow& row);

/// Mass of both gears, kg: full cylinders of the mean diameter (d_a + d_f)/2, as ISO 6336-1 takes
/// rims
/// for the reduced mass; an internal gear from there to 2.5 m_n outside its root. [T9.12]
double mass_of(const ShiftGraph& graph, const DesignRow& row);

}  // namespace gearwright
