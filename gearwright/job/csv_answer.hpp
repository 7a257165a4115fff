// Answers as tables for a spreadsheet (RFC 4180), in the units of the spec. Reading the numbers
// gives the same doubles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/inspection/nominal_points.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/report/k_diagram.hpp"

namespace gearwright {

/// The cell for a plain value. `unit` is the unit of the value in the catalogue, and the cell has
/// the corresponding unit of the system `units`. The cell is empty if there is no value or if the
/// value is a list, a record or a map.
std::string csv_cell(const Value& value, UnitSystem units = UnitSystem::mm, Unit unit = Unit::none);
/// A row for each quantity of the gears and, if they are mounted, of the pair and a rack. The
/// columns are key, quantity, symbol, unit, first and second. The last two are for gear 1 and gear
/// 2, or for the two ends of a range. A value that both gears share is in `first`, and a longer
/// list has a row for each value (key.1, key.2, …). Lists of records (contacts, overlaps) are
/// omitted.
std::string quantities_csv(const SolvedJob& job);
/// Rows as in quantities_csv(), for the measurements of the gears.
std::string measure_csv(const SolvedJob& job, const std::vector<GearMeasures>& measures);
/// A row for each position of the working flanks, with a column for each number of the position.
std::string contact_csv(const SolvedJob& job, const ContactAnswer& answer);
/// A row for each torque and position.
std::string load_csv(const SolvedJob& job, const LoadAnalysis& answer);
/// A row for each proposal. The first row is the spec as given.
std::string propose_csv(const SolvedJob& job, const ProposeView& view);
/// A row for each quantity, with the columns key, quantity, symbol, unit, first, second, formula
/// and branch. `second` is the value of gear 2.
std::string rating_csv(const SolvedJob& job, const RatingAnswer& answer);
/// A row for each point, with the columns arc, x_mm and y_mm.
std::string outline_csv(const Outline& outline, int points, UnitSystem units);

/// The usable extent of the flank of an external or internal gear. Modifications apply to it.
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

/// One diagram for each gear if both flanks are equal, otherwise one for each flank. A gear
/// with a modification that does not fit its flank has no diagram, because the verb `contact`
/// reports the modification.
std::vector<KDiagram> k_diagrams(const SolvedJob& job);

}  // namespace gearwright
