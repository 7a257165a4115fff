// Writes answers as tables for a spreadsheet (RFC 4180), in the units of the spec. Each number has
// enough digits to be read back as exactly the same double.
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

/// Returns the cell for a plain value. `unit` is the unit of the value in the catalogue, and the
/// number in the cell is in the corresponding unit of `units`. If there is no value, or if the
/// value is a list, a record or a map, the cell is empty.
std::string csv_cell(const Value& value, UnitSystem units = UnitSystem::mm, Unit unit = Unit::none);
/// Makes a table with a row for each quantity of the gears and, if they are mounted, of the pair
/// and a rack. The columns are key, quantity, symbol, unit, first and second. The columns `first`
/// and `second` contain the values of gear 1 and gear 2, or the two ends of a range. A value that
/// both gears share is in `first`. A list of more than two values has a row for each value (key.1,
/// key.2, …). Lists of records (contacts, overlaps) are omitted.
std::string quantities_csv(const SolvedJob& job);
/// Makes rows as in quantities_csv(), for the measurements of the gears.
std::string measure_csv(const SolvedJob& job, const std::vector<GearMeasures>& measures);
/// Makes a row for each position of the working flanks, with a column for each of its numbers.
std::string contact_csv(const SolvedJob& job, const ContactAnswer& answer);
/// Makes a row for each torque and position.
std::string load_csv(const SolvedJob& job, const LoadAnalysis& answer);
/// Makes a row for each proposal. The first row is the spec as given.
std::string propose_csv(const SolvedJob& job, const ProposeView& view);
/// Makes a row for each quantity, with the columns key, quantity, symbol, unit, first, second,
/// formula and branch. `first` contains the value of gear 1 or of the pair, `second` the value of
/// gear 2.
std::string rating_csv(const SolvedJob& job, const RatingAnswer& answer);
/// Makes a row for each point, with the columns arc, x_mm and y_mm.
std::string outline_csv(const Outline& outline, int points, UnitSystem units);

/// Returns the extent of the usable flank of an external or internal gear. Modifications apply to
/// this extent.
FlankExtent extent_of(const Gear& gear, const EvaluationRanges& ranges);

/// Reads "9x5", the numbers of points along profile and face, each from 2 to 1000. Returns none for
/// other texts.
std::optional<PointGrid> parse_grid(const std::string& text);

/// Makes a row for each point of tooth 0 over the evaluation ranges, with flank modifications. The
/// columns are gear, flank, diameter_mm, height_mm, x_mm, y_mm, z_mm, nx, ny and nz, in the frame
/// of the gear. If `fillet_points` is given, the table also has this number of points along the
/// root fillet next to each flank, at the same heights. In these rows, the column flank contains
/// `right_fillet` or `left_fillet`.
///
/// Errors    `gearN.modifications.…`; a gear without involute flanks, or without a root fillet
Result<std::string> nominal_csv(const SolvedJob& job, const PointGrid& grid,
                                const std::optional<int>& fillet_points = {});

/// Returns the K-diagrams of all gears that have flank modifications or an accuracy grade, for the
/// page. A gear has one diagram if its flanks are equal, and two diagrams if they differ. If a
/// modification does not fit its flank, the gear has no diagram, and the verb `contact` returns an
/// error for this modification.
std::vector<KDiagram> k_diagrams(const SolvedJob& job);

}  // namespace gearwright
