// Makes the columns of the CSV and Parquet tables of a search from the catalogue. Each quantity
// with a column name has one column, or two columns if it has a value for each gear or for each end
// of a range. Internal to job/ and the programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/columns.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright {

/// Adds the headings of a column to `heads`. There is one heading, or one for each gear, or one for
/// each end of a range.
void add_heads(const RecordColumn& column, std::vector<ParquetColumn>& heads);

template <class S>
class TableColumns {
 public:
  /// Makes the columns of all quantities, except those with the keys in `without`.
  explicit TableColumns(const Quantities<S>& quantities,
                        const std::vector<std::string_view>& without = {}) {
    const std::vector<RecordColumn> all = columns_of(quantities.table());
    for (const Quantity& q : quantities.list()) {
      if (is_in(q.info.key, without)) continue;
      Source source{&q, {}};
      for (const RecordColumn& column : all) {
        if (column.path.front() != &q.info || column.info().column.empty()) continue;
        source.columns.push_back(column);
        add_heads(column, heads_);
      }
      if (!source.columns.empty()) sources_.push_back(std::move(source));
    }
  }

  const std::vector<ParquetColumn>& heads() const { return heads_; }

  /// Calls `cell(column, value)` for every column, in order.
  template <class Cell>
  void row(const S& subject, const Cell& cell) const {
    std::size_t at = 0;
    for (const Source& source : sources_) {
      const ValueRecord record{
          {&source.quantity->info, Quantities<S>::value(*source.quantity, subject)}};
      for (const RecordColumn& column : source.columns)
        for (const Value* value : column.values(record)) cell(at++, *value);
    }
  }

 private:
  struct Source {
    const Quantity* quantity;
    std::vector<RecordColumn> columns;  ///< columns of the quantity, or of its record
  };
  std::vector<Source> sources_;
  std::vector<ParquetColumn> heads_;
};

template <class S>
class ParquetTable {
 public:
  ParquetTable(const std::filesystem::path& part, TableColumns<S> columns,
               const std::vector<std::pair<std::string, std::string>>& notes)
      : columns_(std::move(columns)), writer_(part, columns_.heads(), notes) {}

  void add(const S& row) {
    columns_.row(row, [&](std::size_t i, const Value& v) {
      if (const auto* n = std::get_if<long long>(&v.variant())) writer_.set(i, std::int64_t{*n});
      if (const auto* flag = std::get_if<bool>(&v.variant())) writer_.set(i, std::int64_t{*flag});
      if (const auto* x = std::get_if<double>(&v.variant())) writer_.set(i, *x);
      if (const auto* s = std::get_if<std::string>(&v.variant()))
        writer_.set(i, std::string_view(*s));
    });
    writer_.end_row();
  }
  void close() { writer_.close(); }

 private:
  TableColumns<S> columns_;
  ParquetWriter writer_;
};

/// Returns the columns of designs. Quantities that only some searches compute, for example safety
/// factors and masses, are included if this search computes them.
TableColumns<DesignView> design_columns(const SearchProblem& problem);
TableColumns<ShiftPoint> point_columns();

}  // namespace gearwright
