// The most important quantities of a pair, at the top of the report.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/report/report.hpp"

namespace gearwright {

/// A box for each available key figure: ratio, centre distance, contact ratio, backlash (at both
/// ends of tolerances), safeties, pressure, unevenness. The boxes are rows of the catalogue with
/// their words, symbols and units. Empty if there are none.
std::string key_figures(const ReportInput& input);

/// A box for each of these keys that the records have, in the order of the keys. For several
/// records it shows the range from the value of the first to that of the last.
std::string key_boxes(const QuantityTable& table, const std::vector<ValueRecord>& records,
                      std::span<const std::string_view> keys, UnitSystem units);

}  // namespace gearwright
