// The columns of a search's tables, CSV and Parquet, as the catalogue says them: one column for each
// quantity with a column's name, two for one of both gears.
// Internal to job/.
#pragma once

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/store/parquet.hpp"

namespace gearwright {

template <class S>
class TableColumns {
 public:
  /// Without the quantities of these keys.
  explicit TableColumns(const Quantities<S>& quantities,
                        std::initializer_list<std::string_view> without = {}) {
    for (const Quantity<S>& q : quantities.list()) {
      if (std::find(without.begin(), without.end(), q.info.key) != without.end()) continue;
      const std::size_t before = heads_.size();
      if (q.info.type == Type::record) {
        for (const QuantityInfo* inner : q.info.of().list) add(*inner);
      } else {
        add(q.info);
      }
      if (heads_.size() > before) quantities_.push_back(&q);
    }
  }

  const std::vector<ParquetColumn>& heads() const { return heads_; }

  /// Calls `cell(column, value)` for every column, in order.
  template <class Cell>
  void row(const S& subject, const Cell& cell) const {
    std::size_t column = 0;
    const auto give = [&](const QuantityInfo& info, const Value& value) {
      if (info.column.empty()) return;
      if (const ValueList* list = value.list()) {
        for (const Value& v : *list) cell(column++, v);
      } else {
        cell(column++, value);
      }
    };
    for (const Quantity<S>* q : quantities_) {
      const Value value = q->get(subject);
      if (const ValueRecord* record = value.record()) {
        for (const Member& m : *record) give(*m.info, m.value);
      } else {
        give(q->info, value);
      }
    }
  }

 private:
  void add(const QuantityInfo& info) {
    if (info.column.empty()) return;
    const ParquetType type = info.type == Type::index ? ParquetType::int64
                             : info.type == Type::whole || info.type == Type::flag
                                 ? ParquetType::int32
                             : info.type == Type::number ? ParquetType::float64
                                                         : ParquetType::text;
    const std::size_t mark = info.column.find('#');
    const std::vector<std::string> names = info.list.empty() ? std::vector<std::string>{""}
                                           : info.two == Two::ends
                                               ? std::vector<std::string>{"min", "max"}
                                               : std::vector<std::string>{"1", "2"};
    for (const std::string& name : names) {
      std::string column = info.column;
      if (mark != std::string::npos) column.replace(mark, 1, name);
      heads_.push_back({std::move(column), type, !info.always});
    }
  }

  std::vector<const Quantity<S>*> quantities_;
  std::vector<ParquetColumn> heads_;
};

/// One table on its way to disk.
template <class S>
class ParquetTable {
 public:
  ParquetTable(const std::filesystem::path& part, const TableColumns<S>& columns,
               const std::vector<std::pair<std::string, std::string>>& notes)
      : columns_(columns), writer_(part, columns.heads(), notes) {}

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
  const TableColumns<S>& columns_;
  ParquetWriter writer_;
};

/// Safeties, masses and face widths have columns where the search asks for them.
const TableColumns<DesignView>& design_columns(const SearchProblem& problem);
const TableColumns<ShiftPoint>& point_columns();

}  // namespace gearwright
