// The nominal points of all flanks for a measuring machine, as a table.
// Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>

#include "gearwright/inspection/nominal_points.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// The flank that modifications lie on, of an internal gear too.
FlankExtent extent_of(const Gear& gear, const EvaluationRanges& ranges);

/// Reads "9x5": points along the profile, along the face; none when it is nothing of the kind.
std::optional<PointGrid> parse_grid(const std::string& text);

/// A row for each point of tooth 0 over the evaluation ranges, flank modifications included: gear,
/// flank, diameter_mm, height_mm, x_mm, y_mm, z_mm, nx, ny, nz, in the gear's frame. With
/// `fillet_points` ≥ 2 so many along the root fillet beside each flank, at the same heights; their
/// flank is `right_fillet` or `left_fillet`.
///
/// Errors    `gearN.modifications.…`; a gear without involute flanks, or without the fillet
Result<std::string> nominal_csv(const SolvedJob& job, const PointGrid& grid,
                                const std::optional<int>& fillet_points = {});

}  // namespace gearwright
