// Converts a table of the catalogue to columns. Records are flattened here and nowhere else.
//
// A column is a quantity of a table, or of a record inside it. A list of records is one column. The
// writers of rows (CSV, Parquet, the arrays of Python and of the page) select from these columns,
// name them and give them their own types.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct RecordColumn {
  std::vector<const QuantityInfo*> path;  ///< quantities from the row down to the column
  bool optional = false;                  ///< true if a row may have no value for the column

  const QuantityInfo& info() const { return *path.back(); }
  /// True if the column is a record, whose quantities are the columns after this one.
  bool opened() const { return info().of && info().list.empty(); }
  /// The keys of the path, separated by `between`, for example "ellipse.semi_minor_mm".
  std::string name(std::string_view between) const;
  bool has(Doors door) const;
  /// The number of values that this column has in each row, including the values of nested lists.
  /// The result is 0 if this number varies from row to row.
  std::size_t width() const;
  /// The value of this column in a record of the row's table, or null if the record lacks it.
  const Value* in(const ValueRecord& row) const;
  /// The plain values of this column in a row. The result has width() elements. An element is null
  /// if its value is missing.
  ///
  /// Domain    width() > 0 (contract)
  std::vector<const Value*> values(const ValueRecord& row) const;
};

std::vector<RecordColumn> columns_of(const QuantityTable& table);

/// The value of a quantity in a record of its table, or null if the record lacks it.
const Value* value_in(const ValueRecord& record, const QuantityInfo& info);

/// The given tables, each followed by the tables of its records. No table occurs twice.
std::vector<const QuantityTable*> with_inner_tables(
    const std::vector<const QuantityTable*>& tables);

}  // namespace gearwright
