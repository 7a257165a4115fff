// An HTML table of quantities: words, symbol, unit, then one value per column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

class TableBuilder {
 public:
  /// Caption and headings are plain text. `columns` are the headings of the values.
  TableBuilder(std::string_view caption, const std::vector<std::string>& columns);

  void group(std::string_view title);
  /// Adds one value per column. The symbol is written as in html_text.hpp and may be empty.
  void row(std::string_view words, std::string_view symbol, std::string_view unit,
           const std::vector<std::string>& values);
  /// Adds the values for a row of the catalogue.
  void row(const TextRow& text, const std::vector<std::string>& values);
  /// Adds one value common to all columns, or to all except the last, which then contains a note.
  void common(std::string_view words, std::string_view symbol, std::string_view unit,
              const std::string& value, const std::optional<std::string>& note = {});
  void common(const TextRow& text, const std::string& value,
              const std::optional<std::string>& note = {});
  /// Adds the rows of the catalogue without the heading of the group, with a value per column or
  /// one that is common to all. The table has as many columns as there are records, or two for one
  /// record (a pair).
  void rows(const TextGroup& group);
  /// Adds the same rows under their headings.
  void groups(const std::vector<TextGroup>& groups);

  /// Replaces the first values by these words, with symbols, next to the caption of a folded table.
  void decisive(std::string_view words);

  /// Returns the table. On screen, a long table is folded behind its caption and its first values.
  /// On paper it is unfolded.
  std::string str() const;

 private:
  void open_row(std::string_view words, std::string_view symbol, std::string_view unit);
  void cell(const std::string& value, std::size_t columns);

  static constexpr int kLong = 10;  ///< rows; a table with more is folded
  static constexpr int kFirst = 3;  ///< values next to the caption of a folded table

  std::string caption_;
  std::string first_;     ///< values, HTML
  std::string decisive_;  ///< words that replace them, HTML; empty if they are used
  bool row_has_value_ = false;
  int rows_ = 0;
  std::size_t columns_;
  bool in_group_ = false;
  std::string text_;
};

}  // namespace gearwright
