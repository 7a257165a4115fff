#include "gearwright/catalogue/columns.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"

namespace gearwright {

namespace {

void add(const QuantityTable& table, const RecordColumn& around, std::vector<RecordColumn>& all) {
  for (const QuantityInfo* info : table.list) {
    RecordColumn column = around;
    column.path.push_back(info);
    column.optional = around.optional || !info->always || info->optional_key;
    all.push_back(column);
    if (column.opened()) add(info->of(), column, all);
  }
}

void add(const QuantityTable& table, std::vector<const QuantityTable*>& all) {
  if (!add_once(all, &table)) return;
  for (const QuantityInfo* info : table.list)
    if (info->of) add(info->of(), all);
}

}  // namespace

std::string RecordColumn::name(std::string_view between) const {
  std::string name;
  for (const QuantityInfo* info : path) {
    if (!name.empty()) name += between;
    name += info->key;
  }
  return name;
}

bool RecordColumn::has(Doors door) const {
  return std::all_of(path.begin(), path.end(),
                     [&](const QuantityInfo* info) { return (info->doors & door) != 0; });
}

std::size_t RecordColumn::width() const {
  std::size_t width = 1;
  for (const int length : info().list) width *= static_cast<std::size_t>(length);
  return width;
}

const Value* RecordColumn::in(const ValueRecord& row) const {
  const ValueRecord* record = &row;
  const Value* value = nullptr;
  for (const QuantityInfo* info : path) {
    value = record ? value_in(*record, *info) : nullptr;
    record = value ? value->record() : nullptr;
  }
  return value;
}

std::vector<const Value*> RecordColumn::values(const ValueRecord& row) const {
  GW_EXPECTS(width() > 0);
  static const Value kNothing;
  const Value* const value = in(row);
  std::vector<const Value*> all{value ? value : &kNothing};
  for (const int length : info().list) {
    std::vector<const Value*> inner;
    for (const Value* outer : all) {
      const ValueList* list = outer->list();
      for (int i = 0; i < length; ++i)
        inner.push_back(list ? &(*list)[static_cast<std::size_t>(i)] : outer);
    }
    all = std::move(inner);
  }
  return all;
}

std::vector<RecordColumn> columns_of(const QuantityTable& table) {
  std::vector<RecordColumn> all;
  add(table, {}, all);
  return all;
}

const Value* value_in(const ValueRecord& record, const QuantityInfo& info) {
  for (const Member& member : record)
    if (member.info == &info) return &member.value;
  return nullptr;
}

std::vector<const QuantityTable*> with_inner_tables(
    const std::vector<const QuantityTable*>& tables) {
  std::vector<const QuantityTable*> all;
  for (const QuantityTable* table : tables) add(*table, all);
  return all;
}

}  // namespace gearwright
