// Converts a table of the catalogue to columns. This is the only code that flattens nested records.
//
// A column is a quantity of a table, or of a record inside the table. A list of records is one
// column. The writers of rows (CSV, Parquet, the arrays of Python and of the page) select from
// these columns and give each of them a name and a type of their format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct RecordColumn {
  std::vector<const QuantityInfo*> path;  ///< quantities on the path from the row to the column
  bool optional = false;                  ///< true if a row may have no value for the column

  const QuantityInfo& info() const { return *path.back(); }
  /// True if the column is a record. The next columns are then the quantities of the record.
  bool opened() const { return info().of && info().list.empty(); }
  /// Returns the keys of the path, separated by `between`, for example "ellipse.semi_minor_mm".
  std::string name(std::string_view between) const;
  bool has(Doors door) const;
  /// Returns the number of values that this column has in each row, including the values of nested
  /// lists. Returns 0 if this number varies from row to row.
  std::size_t width() const;
  /// Returns the value of this column in a record of the row's table, or null if there is none.
  const Value* in(const ValueRecord& row) const;
  /// Returns the plain values of this column in a row. The result has width() elements. If a value
  /// is missing, its element points to a null Value.
  ///
  /// Domain    width() > 0 (contract)
  std::vector<const Value*> values(const ValueRecord& row) const;
};

std::vector<RecordColumn> columns_of(const QuantityTable& table);

/// Returns the value of a quantity in a record of its table, or null if there is none.
const Value* value_in(const ValueRecord& record, const QuantityInfo& info);

/// Returns the given tables, each followed by the tables of its records. No table occurs twice.
std::vector<const QuantityTable*> with_inner_tables(
    const std::vector<const QuantityTable*>& tables);

}  // namespace gearwright
