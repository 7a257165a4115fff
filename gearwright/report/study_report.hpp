// Writes one HTML page about designs that are ranked by a percentile of their scatter: a sortable
// table, and a figure of the percentiles with their confidence intervals. The page is one
// self-contained file and depends only on its input.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gearwright {

struct StudyReport {
  std::string title, sentence;
  std::string spec_text;   ///< the spec, verbatim; omitted if empty
  std::string version;     ///< version of the program
  std::string percentile;  ///< "95 %"
  struct Column {
    std::string head, unit, meaning;
  };
  std::vector<Column> columns;
  struct Cell {
    std::string text;
    std::optional<double> key;  ///< value by which the column is sorted
  };
  struct Row {
    std::vector<Cell> cells;  ///< one for each column
    double percentile = 0.0, mean = 0.0;
    std::optional<double> lower, upper;
    std::string words;  ///< "design 3, 23:45 teeth, module 3"
  };
  std::vector<Row> rows;             ///< best first
  std::vector<std::string> refused;  ///< designs that have no scatter results, with the reason
};

/// Greatest numbers of rows in the table and of entries in the figure.
inline constexpr std::size_t kStudyRows = 500, kStudyDots = 80;

/// The page, UTF-8. All texts are plain and may contain any character.
std::string study_report(const StudyReport& report);

}  // namespace gearwright
