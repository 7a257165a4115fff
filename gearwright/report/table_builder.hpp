// An HTML table of quantities: words, symbol, unit, then one value per column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gearwright {

class TableBuilder {
 public:
  /// Caption and headings are plain text. `columns` head the values.
  TableBuilder(std::string_view caption, const std::vector<std::string>& columns);

  void group(std::string_view title);
  /// One value per column; the symbol as in html_text.hpp, may be empty.
  void row(std::string_view words, std::string_view symbol, std::string_view unit,
           const std::vector<std::string>& values);
  /// One value that belongs to all columns.
  void common(std::string_view words, std::string_view symbol, std::string_view unit,
              const std::string& value);
  /// One value that belongs to all columns but the last, which holds a note.
  void common(std::string_view words, std::string_view symbol, std::string_view unit,
              const std::string& value, const std::string& note);

  std::size_t columns() const { return columns_; }  ///< of values
  std::string str() const;

 private:
  void open_row(std::string_view words, std::string_view symbol, std::string_view unit);
  void cell(const std::string& value, std::size_t columns);

  std::size_t columns_;
  bool in_group_ = false;
  std::string text_;
};

}  // namespace gearwright
