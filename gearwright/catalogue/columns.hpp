// A table of the catalogue as columns: the one place where records are flattened.
//
// A column is a quantity of a table, or of a record in it, which is opened; a list of records is one column. What
// writes rows (CSV, Parquet, the arrays of Python and of the page) chooses of these columns, names them and gives
// them its own types.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct RecordColumn {
  std::vector<const QuantityInfo*> path;  ///< from the row's own quantity to that of the column
  bool optional = false;                  ///< a row may lack it, or have no value for it

  const QuantityInfo& info() const { return *path.back(); }
  /// It is a record: the columns after it are those of its quantities.
  bool opened() const { return info().of && info().list.empty(); }
  /// The keys of the path: "ellipse.semi_minor_mm".
  std::string name(std::string_view between) const;
  /// Whether it is given at this door.
  bool has(Doors door) const;
  /// So many values in each row, nested lists counted; 0: any number.
  std::size_t width() const;
  /// Its value in a record of the row's table; null: the record lacks it.
  const Value* in(const ValueRecord& row) const;
  /// Its plain values in a row, as many as the width; nothing for each where there is none.
  /// Domain  width() > 0 (contract)
  std::vector<const Value*> values(const ValueRecord& row) const;
};

/// In the table's order.
std::vector<RecordColumn> columns_of(const QuantityTable& table);

/// The quantity's value in a record of its table; null: the record lacks it.
const Value* value_in(const ValueRecord& record, const QuantityInfo& info);

/// The tables, each followed by those of the records in it that did not come before.
std::vector<const QuantityTable*> with_inner_tables(
    std::initializer_list<const QuantityTable*> tables);

}  // namespace gearwright
