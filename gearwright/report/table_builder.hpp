// Builds an HTML table of quantities. A row has words, symbol and unit, then a value in each
// column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/catalogue/text_table.hpp"

namespace gearwright {

class TableBuilder {
 public:
  /// Caption and headings are plain text. `columns` are the headings of the values.
  TableBuilder(std::string_view caption, const std::vector<std::string>& columns);

  void group(std::string_view title);
  /// Adds a row with one value for each column. The symbol is written as in figure/markup.hpp and
  /// may be empty.
  void row(std::string_view words, std::string_view symbol, std::string_view unit,
           const std::vector<std::string>& values);
  void row(const TextRow& text, const std::vector<std::string>& values);
  /// Adds a row with a single value, which spans all columns. If there is a note, it takes the last
  /// column, and the value spans the columns before it.
  void common(std::string_view words, std::string_view symbol, std::string_view unit,
              const std::string& value, const std::optional<std::string>& note = {});
  void common(const TextRow& text, const std::string& value,
              const std::optional<std::string>& note = {});
  /// Adds the rows of a group of the catalogue, without the heading of the group. A row has one
  /// value for each column, or one value for all columns. The table must have as many columns as
  /// the group has records. A group with a single record (a pair) may also be added to a table with
  /// two columns. A value of the whole pair then spans both columns.
  void rows(const TextGroup& group);
  /// Adds the rows of each group under its heading.
  void groups(const std::vector<TextGroup>& groups);
  /// Adds the quantities of a subject, under their headings.
  template <class S>
  void groups(UnitSystem units, const Quantities<S>& quantities,
              const std::type_identity_t<S>& subject) {
    groups(text_groups(quantities.table(), {quantities.of(subject)}, kPage, units));
  }

  /// Sets the words that a folded table shows next to its caption instead of the first values. The
  /// words may contain symbols.
  void decisive(std::string_view words);
  /// Selects, by keys of the catalogue, the rows that a folded table shows next to its caption. By
  /// default, these are the first rows. The call must precede the rows.
  void decisive_rows(std::vector<std::string_view> keys);

  /// Returns the table. On screen, only the caption and the first values of a long table are
  /// visible until the user unfolds it. On paper the whole table is visible.
  std::string str() const;

 private:
  void open_row(std::string_view words, std::string_view symbol, std::string_view unit);
  void cell(const std::string& value, std::size_t columns);

  static constexpr int kLong = 10;  ///< a table with more rows is folded
  static constexpr int kFirst = 3;  ///< number of values next to the caption of a folded table

  std::string caption_;
  std::string first_;     ///< the first values, HTML
  std::string decisive_;  ///< words shown instead of the first values, HTML; may be empty
  std::vector<std::string_view> decisive_keys_;
  std::string_view key_;  ///< key of the row that is being added; empty if it has none
  bool beside_ = false;   ///< true if the values of this row are next to the caption
  bool row_has_value_ = false;
  int rows_ = 0;
  std::size_t columns_;
  bool in_group_ = false;
  std::string text_;
};

/// Writes a table and its notes, which become paragraphs.
std::string table_html(const TextTable& table);

/// Writes the quantities of a subject as a table.
template <class S>
std::string table_html(std::string_view caption, const std::vector<std::string>& columns,
                       UnitSystem units, const Quantities<S>& quantities,
                       const std::type_identity_t<S>& subject) {
  TableBuilder table(caption, columns);
  table.groups(units, quantities, subject);
  return table.str();
}

}  // namespace gearwright
