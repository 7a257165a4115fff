// Answers as tables for a spreadsheet: RFC 4180, numbers that read back to the same double.
#pragma once

#include <string>

#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/rating_answer.hpp"

namespace gearwright {

/// A plain value in a cell; empty for no value and for a list, a record or a map.
std::string csv_cell(const Value& value);
/// A row for each quantity of the gears and, where they are mounted, of the pair and a rack:
/// key, quantity, symbol, unit, first, second. The last two are gear 1 and gear 2, or the two ends
/// of a range; common values are in `first`, and a longer list has its own rows (key.1, key.2, …).
/// Lists of records (contacts, overlaps) are left to JSON.
std::string quantities_csv(const SolvedJob& job);
/// A row for each position of the working flanks, a column for each number of it.
std::string contact_csv(const SolvedJob& job, const ContactAnswer& answer);
/// A row for each torque and position.
std::string load_csv(const LoadAnalysis& answer);
/// A row for each quantity: key, quantity, symbol, unit, first, second, formula, branch; `second`
/// is that of gear 2.
std::string rating_csv(const RatingAnswer& answer);
/// A row for each point: arc, x_mm, y_mm.
std::string outline_csv(const Outline& outline, int points);

}  // namespace gearwright
