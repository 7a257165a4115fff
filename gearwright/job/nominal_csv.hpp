// Nominal points of all flanks for a measuring machine, as a table.
// Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>

#include "gearwright/inspection/nominal_points.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

/// The extent of the flank to which modifications apply, also for an internal gear.
FlankExtent extent_of(const Gear& gear, const EvaluationRanges& ranges);

/// Reads "9x5": points along the profile, along the face; none for other texts.
std::optional<PointGrid> parse_grid(const std::string& text);

/// A row for each point of tooth 0 over the evaluation ranges, flank modifications included: gear,
/// flank, diameter_mm, height_mm, x_mm, y_mm, z_mm, nx, ny, nz, in the gear's frame. With
/// `fillet_points` ≥ 2 also this number of points along the root fillet next to each flank, at the
/// same heights; their flank is `right_fillet` or `left_fillet`.
///
/// Errors    `gearN.modifications.…`; a gear without involute flanks, or without the fillet
Result<std::string> nominal_csv(const SolvedJob& job, const PointGrid& grid,
                                const std::optional<int>& fillet_points = {});

}  // namespace gearwright
