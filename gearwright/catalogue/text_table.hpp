// Tables for users, stored as texts. An answer makes each table once, in the words and units of its
// spec. The terminal (job/listing.hpp) and the report (report/table_builder.hpp) print it.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

struct TextTable {
  struct Row {
    std::string words, unit;
    std::vector<std::string> cells;        ///< one for each column
    std::vector<std::string> errors = {};  ///< standard errors of the cells, for the terminal;
                                           ///< empty if no errors are known
  };
  std::string title;
  std::vector<std::string> columns;
  std::vector<Row> rows = {};
  std::vector<std::string> notes = {};  ///< sentences below the table
  std::vector<std::string> units = {};  ///< units of the columns; empty if the rows have units
  bool omit_zeros = false;              ///< true if the terminal names all rows of zeros in a
                                        ///< single line
};

constexpr std::string_view kAbsent = "-";  ///< the cell of a value that a record does not have

/// Returns the member of a record, or of one of its inner records ("span.length_mm"). Returns null
/// if the record lacks it.
const Member* member_at(const ValueRecord& record, std::string_view path);

struct ListingColumn {
  std::string words;  ///< term for the quantity, in full
  std::string head;   ///< heading: the symbol, or words
  std::string unit;
  std::vector<std::string> cells;                   ///< one for each row
  bool left = false;                                ///< true if the cells are aligned to the left
  std::vector<std::optional<double>> numbers = {};  ///< values of the cells, for comparing columns;
                                                    ///< nullopt for a cell that is not a number
};

/// Makes a column for each quantity of `keys` for which at least one record shows a value. If the
/// quantity has one value per gear, each gear with a value has a column. The values are in `units`.
/// The heading is the symbol. If the quantity has no symbol or another quantity has the same
/// symbol, the heading is the words. The key of a member of an inner record is "record.key".
std::vector<ListingColumn> listing_columns(UnitSystem units,
                                           const std::vector<ValueRecord>& records,
                                           std::initializer_list<std::string_view> keys);

/// Makes a table with a row for each record. The row begins with the name of the record. The
/// columns of listing_columns() for `keys` follow.
TextTable record_table(UnitSystem units, std::string title, const std::vector<std::string>& names,
                       const std::vector<ValueRecord>& records,
                       std::initializer_list<std::string_view> keys);

}  // namespace gearwright
