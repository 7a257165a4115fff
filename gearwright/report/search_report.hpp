// Writes one HTML page about a design search, for users. It contains the number of trials, the best
// designs in a sortable table, and pictures of their objectives and shift regions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/figure/distribution_figures.hpp"
#include "gearwright/report/search_table.hpp"

namespace gearwright {

/// A sentence about a search, or a change of the spec, which is an item below the last sentence.
struct SearchReason {
  std::string text;
  bool is_change = false;
};

struct SearchReport {
  std::string title;      ///< if empty, a title is made from the range of ratios
  std::string spec_text;  ///< the spec, verbatim; omitted if empty
  const Search& search;
  const SearchAnswer& answer;
  /// Warnings in plain text. If no design is feasible, the list also contains the reasons and the
  /// changes that would help.
  std::vector<SearchReason> reasons;
  std::size_t rows = 200;             ///< number of designs in the table
  UnitSystem units = UnitSystem::mm;  ///< units of the lengths
};

/// Greatest number of designs, best first, that have a picture of their region.
inline constexpr std::size_t kRegionPictures = 20;

/// Returns the page in UTF-8.
///
///   Laws      (1) the same input gives the same bytes
///             (2) the page loads nothing
///             (3) title, spec and reasons may contain any text
///             (4) without scripts, the page contains the table and all pictures
/// Units     lengths in `units`, angles in degrees, shifts and regions in normal modules; missing
///           values are “–”
std::string search_report(const SearchReport& report);

// Writes one HTML page about designs that are ranked by a percentile of their scatter. It contains
// a sortable table, and a figure of the percentiles with their confidence intervals.

struct StudyReport {
  std::string title, sentence;
  std::string spec_text;   ///< the spec, verbatim; omitted if empty
  std::string percentile;  ///< "95 %"
  std::vector<TableColumn> columns;
  std::vector<TableRow> rows;                ///< best first
  std::vector<RankingScene::Entry> ranking;  ///< one entry for each row
  std::vector<std::string> refused;  ///< designs that have no scatter results, with the reason
};

/// Greatest numbers of rows in the table and of entries in the figure.
inline constexpr std::size_t kStudyRows = 500, kStudyDots = 80;

/// Returns the page in UTF-8. All texts are plain and may contain any character.
std::string study_report(const StudyReport& report);

}  // namespace gearwright
