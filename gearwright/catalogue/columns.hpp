// A table of the catalogue as columns: the one place where records are flattened.
//
// A column is a quantity of a table, or of a record in it, which is opened; a list of records is
// one column. The writers of rows (CSV, Parquet, the arrays of Python and of the page) select from
// these columns, name them and give them their own types.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct RecordColumn {
  std::vector<const QuantityInfo*> path;  ///< from the row's quantity to the column's
  bool optional = false;                  ///< a row may lack it, or have no value for it

  const QuantityInfo& info() const { return *path.back(); }
  /// True for a record, whose quantities are the columns after it.
  bool opened() const { return info().of && info().list.empty(); }
  /// The keys of the path: "ellipse.semi_minor_mm".
  std::string name(std::string_view between) const;
  /// True if the column is given at this interface.
  bool has(Doors door) const;
  /// Number of values in each row, including nested lists; 0 for any number.
  std::size_t width() const;
  /// Its value in a record of the row's table; null if the record lacks it.
  const Value* in(const ValueRecord& row) const;
  /// Its plain values in a row, as many as the width, with null for missing ones.
  ///
  /// Domain    width() > 0 (contract)
  std::vector<const Value*> values(const ValueRecord& row) const;
};

/// The columns in the order of the table.
std::vector<RecordColumn> columns_of(const QuantityTable& table);

/// The quantity's value in a record of its table; null if the record lacks it.
const Value* value_in(const ValueRecord& record, const QuantityInfo& info);

/// The tables, each followed by the tables of its records that did not occur before.
std::vector<const QuantityTable*> with_inner_tables(
    std::initializer_list<const QuantityTable*> tables);

}  // namespace gearwright
