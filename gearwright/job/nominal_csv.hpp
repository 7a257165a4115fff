// Nominal points of all flanks for a measuring machine, as a table, and the K-diagrams of all
// flanks. Internal to job/ and the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/inspection/nominal_points.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// The usable extent of the flank, over which modifications apply. The gear may be internal.
FlankExtent extent_of(const Gear& gear, const EvaluationRanges& ranges);

/// Reads "9x5", the numbers of points along the profile and along the face. Other texts give no
/// grid.
std::optional<PointGrid> parse_grid(const std::string& text);

/// A row for each point of tooth 0 over the evaluation ranges, with flank modifications. The
/// columns are gear, flank, diameter_mm, height_mm, x_mm, y_mm, z_mm, nx, ny and nz, in the gear's
/// frame. With `fillet_points` ≥ 2, the table also has this number of points along the root fillet
/// next to each flank, at the same heights. In the rows of a fillet, the column flank contains
/// `right_fillet` or `left_fillet`.
///
/// Errors    `gearN.modifications.…`; a gear without involute flanks, or without a root fillet
Result<std::string> nominal_csv(const SolvedJob& job, const PointGrid& grid,
                                const std::optional<int>& fillet_points = {});

// The K-diagrams of all flanks that have modifications or an accuracy grade, for the page.

/// One diagram for each gear if both flanks are equal, otherwise one for each flank. A modification
/// that does not fit its flank is omitted, because the verb `contact` reports it.
std::vector<KDiagram> k_diagrams(const SolvedJob& job);

}  // namespace gearwright
