// The columns of a search's tables: designs, and points of the grid of shifts.
// Internal to job/.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/shift_points.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright {

/// Nothing is null.
using TableValue = std::variant<std::monostate, std::int64_t, double, std::string>;

template <class Row>
struct TableColumn {
  std::string name;
  ParquetType type;
  std::function<TableValue(const Row&)> value;
  bool optional = false;
};

const std::vector<TableColumn<DesignRow>>& design_columns();
const std::vector<TableColumn<ShiftPoint>>& point_columns();

/// Degrees as they were given: −12, not what −12° in radians comes back as.
double tidy_degrees(double rad);

}  // namespace gearwright
