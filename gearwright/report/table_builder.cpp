#include "gearwright/report/table_builder.hpp"

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

TableBuilder::TableBuilder(std::string_view caption, const std::vector<std::string>& columns)
    : caption_(escaped(caption)), columns_(columns.size()) {
  GW_EXPECTS(columns_ > 0);
  text_ = fmt::format(
      "<div class=\"scroll\"><table>\n<caption>{}</caption>\n<thead><tr><th "
      "scope=\"col\">Quantity</th>"
      "<th scope=\"col\">Symbol</th><th scope=\"col\">Unit</th>",
      escaped(caption));
  for (std::size_t i = 0; i < columns_; ++i) {
    text_ += fmt::format("<th scope=\"col\" class=\"value\">{}</th>", escaped(columns[i]));
  }
  text_ += "</tr></thead>\n";
}

void TableBuilder::group(std::string_view title) {
  if (in_group_) text_ += "</tbody>\n";
  in_group_ = true;
  text_ +=
      fmt::format("<tbody><tr class=\"group\"><th scope=\"rowgroup\" colspan=\"{}\">{}</th></tr>\n",
                  columns_ + 3, escaped(title));
}

void TableBuilder::open_row(std::string_view words, std::string_view symbol,
                            std::string_view unit) {
  if (!in_group_) text_ += "<tbody>\n";
  in_group_ = true;
  text_ += fmt::format(
      "<tr><th scope=\"row\">{}</th><td class=\"symbol\">{}</td><td class=\"unit\">{}</td>",
      with_symbols(words), symbol_html(symbol), escaped(unit));
  row_has_value_ = false;
  beside_ = decisive_keys_.empty() ? rows_ < kFirst : is_in(key_, decisive_keys_);
  ++rows_;
  if (beside_)
    first_ += (first_.empty() ? ": " : "; ") +
              (symbol.empty() ? with_symbols(words) : symbol_html(symbol));
}

// Adds a cell. A single number is never broken into two lines. A range or a list may be broken
// between its numbers.
void TableBuilder::cell(const std::string& value, std::size_t columns) {
  const bool several = value.find(" … ") != value.npos || value.find(", ") != value.npos;
  text_ +=
      fmt::format("<td class=\"value{}\"{}>{}</td>", several ? " several" : "",
                  columns > 1 ? fmt::format(" colspan=\"{}\"", columns) : "", with_symbols(value));
  if (!beside_ || value.empty()) return;
  first_ += (row_has_value_ ? " / " : " ") + with_symbols(value);
  row_has_value_ = true;
}

void TableBuilder::decisive(std::string_view words) { decisive_ = ": " + with_symbols(words); }

void TableBuilder::row(std::string_view words, std::string_view symbol, std::string_view unit,
                       const std::vector<std::string>& values) {
  GW_EXPECTS(values.size() == columns_);
  open_row(words, symbol, unit);
  for (const std::string& value : values) cell(value, 1);
  text_ += "</tr>\n";
}

void TableBuilder::decisive_rows(std::vector<std::string_view> keys) {
  decisive_keys_ = std::move(keys);
}

void TableBuilder::row(const TextRow& text, const std::vector<std::string>& values) {
  key_ = text.info->key;
  row(capitalised(text.info->words), text.info->symbol, text.unit, values);
  key_ = {};
}

void TableBuilder::common(std::string_view words, std::string_view symbol, std::string_view unit,
                          const std::string& value, const std::optional<std::string>& note) {
  GW_EXPECTS(!note || columns_ > 1);
  open_row(words, symbol, unit);
  cell(value, note ? columns_ - 1 : columns_);
  if (note) cell(*note, 1);
  text_ += "</tr>\n";
}

void TableBuilder::common(const TextRow& text, const std::string& value,
                          const std::optional<std::string>& note) {
  key_ = text.info->key;
  common(capitalised(text.info->words), text.info->symbol, text.unit, value, note);
  key_ = {};
}

void TableBuilder::rows(const TextGroup& group) {
  for (const TextRow& each : group.rows) {
    if (each.texts.size() == columns_)
      row(each, each.texts);
    else
      common(each, each.texts.front());
  }
}

void TableBuilder::groups(const std::vector<TextGroup>& groups) {
  for (const TextGroup& each : groups) {
    if (!each.title.empty()) group(each.title);
    rows(each);
  }
}

std::string TableBuilder::str() const {
  const std::string table = text_ + (in_group_ ? "</tbody>\n" : "") + "</table></div>\n";
  if (rows_ <= kLong) return table;
  return fmt::format(
      "<details class=\"fold\"><summary>{}<span "
      "class=\"first\">{}</span></summary>\n{}</details>\n",
      caption_, decisive_.empty() ? first_ : decisive_, table);
}

std::string table_html(const TextTable& table) {
  std::string text = table.title.empty() ? "" : fmt::format("<h3>{}</h3>\n", escaped(table.title));
  if (!table.rows.empty()) {
    std::vector<std::string> heads;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const std::string& head = table.columns[i];
      const bool symbol = head.find('_') != head.npos;
      const bool unit = i < table.units.size() && !table.units[i].empty();
      heads.push_back((symbol ? head : capitalised(head)) + (unit ? ", " + table.units[i] : ""));
    }
    TableBuilder html(table.title, heads);
    for (const TextTable::Row& row : table.rows) html.row(row.words, "", row.unit, row.cells);
    text = html.str();
  }
  for (const std::string& note : table.notes)
    text += fmt::format("<p>{}</p>\n", escaped(capitalised(note)));
  return text;
}

}  // namespace gearwright
