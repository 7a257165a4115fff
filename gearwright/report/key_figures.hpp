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
/// ends of the tolerances), safeties, pressure, unevenness. Words, symbols and units are those of
/// the catalogue. Empty if there are none.
std::string key_figures(const ReportInput& input);

/// A box for each of these keys for which the records have a value, in the order of `keys`. If
/// there are several records, a box shows the range from the first value to the last.
std::string key_boxes(const QuantityTable& table, const std::vector<ValueRecord>& records,
                      std::span<const std::string_view> keys, UnitSystem units);

}  // namespace gearwright
