#include "gearwright/catalogue/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gearwright {

namespace {

// Makes the column of the quantity `info`, for gear 1 or 2 if `gear` is 1 or 2.
ListingColumn listing_column(UnitSystem units, const QuantityInfo& info, const std::string& head,
                             int gear, const std::vector<const Member*>& members) {
  ListingColumn column{
      gear > 0 ? fmt::format("{}, gear {}", info.words, gear) : info.words,
      gear > 0 ? fmt::format("{}{}{}", head, head == info.symbol ? "" : " ", gear) : head,
      std::string(unit_text(system_of(info, units), info.unit)),
      {},
      info.type == Type::word || info.type == Type::map};
  for (const Member* m : members) {
    const ValueList* const each = m && gear > 0 ? m->value.list() : nullptr;
    const Value value = each ? (*each)[gear - 1] : m ? m->value : Value();
    column.cells.push_back(text_of(info, value, kAbsent, units));
    column.numbers.push_back(value.number());
  }
  return column;
}

}  // namespace

const Member* member_at(const ValueRecord& record, std::string_view path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  for (const Member& m : record) {
    if (m.info->key != path.substr(0, dot)) continue;
    const ValueRecord* const inner = m.value.record();
    return dot == path.size() ? &m : inner ? member_at(*inner, path.substr(dot + 1)) : nullptr;
  }
  return nullptr;
}

std::vector<ListingColumn> listing_columns(UnitSystem units,
                                           const std::vector<ValueRecord>& records,
                                           std::initializer_list<std::string_view> keys) {
  struct Shown {
    const QuantityInfo* info = nullptr;
    std::vector<const Member*> members{};
  };
  std::vector<Shown> all;
  for (const std::string_view key : keys) {
    Shown shown;
    for (const ValueRecord& record : records) {
      shown.members.push_back(member_at(record, key));
      if (const Member* m = shown.members.back(); m && m->shown) shown.info = m->info;
    }
    if (shown.info) all.push_back(std::move(shown));
  }
  std::vector<ListingColumn> columns;
  for (const Shown& s : all) {
    const auto same = [&](const Shown& other) { return other.info->symbol == s.info->symbol; };
    const bool words = s.info->symbol.empty() || std::count_if(all.begin(), all.end(), same) > 1;
    const std::string& head = words ? s.info->words : s.info->symbol;
    for (const int gear : s.info->two == Two::gears ? std::vector{1, 2} : std::vector{0}) {
      ListingColumn column = listing_column(units, *s.info, head, gear, s.members);
      if (std::any_of(column.cells.begin(), column.cells.end(),
                      [](const std::string& cell) { return cell != kAbsent; }))
        columns.push_back(std::move(column));
    }
  }
  return columns;
}

TextTable record_table(UnitSystem units, std::string title, const std::vector<std::string>& names,
                       const std::vector<ValueRecord>& records,
                       std::initializer_list<std::string_view> keys) {
  TextTable table{std::move(title), {}};
  for (const std::string& name : names) table.rows.push_back({name, "", {}});
  for (const ListingColumn& column : listing_columns(units, records, keys)) {
    table.columns.push_back(column.head);
    table.units.push_back(column.unit);
    for (std::size_t i = 0; i < names.size(); ++i) table.rows[i].cells.push_back(column.cells[i]);
  }
  return table;
}

}  // namespace gearwright
