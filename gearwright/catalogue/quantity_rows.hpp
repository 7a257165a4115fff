// The rows of the tables for users, with their values. text_groups() in quantity_info.hpp writes
// them as texts for the terminal and the report, and job/result_rows.hpp writes them for the page.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

/// The quantities of which a table consists.
enum class RowRange {
  shown,  ///< the quantities of the interface that at least one record shows
  all     ///< also quantities that have a value but that no record shows, and the quantities of
          ///< single inner records that only JSON contains
};

struct QuantityRow {
  const QuantityInfo* info;
  std::string group;          ///< heading; may be empty
  std::string path;           ///< keys from the record to the value, "backlash.normal_mm"
  std::string words;          ///< words of the quantity; if they are not clear alone, with the name
                              ///< of the inner record: "distance from A, point B"
  std::vector<Value> values;  ///< one for each record, one for each gear of a single record, or one
                              ///< for both gears
};

/// Returns the rows of a table for users, in the order of the headings. The records are columns
/// side by side (two gears), or there is one record with values for each gear (a pair). A quantity
/// is a row if the interface `door` shows it. The quantities of inner records are also rows.
std::vector<QuantityRow> quantity_rows(const QuantityTable& table,
                                       const std::vector<ValueRecord>& records, Doors door,
                                       UnitSystem units, RowRange range = RowRange::shown);

}  // namespace gearwright
