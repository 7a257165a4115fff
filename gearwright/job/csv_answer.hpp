// Answers as tables for a spreadsheet (RFC 4180), in the units of the spec. Reading the numbers
// gives the same doubles.
#pragma once

#include <string>

#include "gearwright/catalogue/measure_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/rating_answer.hpp"

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
/// The same rows for the measurements of the gears.
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

}  // namespace gearwright
