#include "gearwright/report/quantity_table.hpp"

namespace gearwright {

void add_rows(TableBuilder& table, const TextGroup& group) {
  for (const TextRow& row : group.rows) {
    const std::string words = capitalised(row.info->words);
    const std::string_view unit = unit_text(row.info->unit);
    if (row.texts.size() == table.columns()) {
      table.row(words, row.info->symbol, unit, row.texts);
    } else {
      table.common(words, row.info->symbol, unit, row.texts.front());
    }
  }
}

void add_groups(TableBuilder& table, const std::vector<TextGroup>& groups) {
  for (const TextGroup& group : groups) {
    if (!group.title.empty()) table.group(group.title);
    add_rows(table, group);
  }
}

}  // namespace gearwright
