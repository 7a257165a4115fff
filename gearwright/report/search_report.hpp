// Writes one HTML page about a design search, for users: the tried candidates, the best designs in
// a sortable table, and pictures of their objectives and of the regions of their profile shifts.
//
// Like the report of a pair (report/report.hpp), it depends only on its input and is one
// self-contained file.
#pragma once

#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct SearchReport {
  std::string title;      ///< if empty, a title is made from the range of ratios
  std::string spec_text;  ///< the spec, verbatim; omitted if empty
  const Search& search;
  const SearchAnswer& answer;
  std::vector<std::string> reasons;  ///< plain text: the reasons if nothing fits, changes that
                                     ///< would help, warnings
  std::size_t rows = 200;            ///< number of designs in the table
  std::string version;               ///< of the program
};

inline constexpr std::size_t kRegionPictures = 20;  ///< for the best designs

/// The numbers of candidates and the best design in two or three sentences (HTML).
std::string search_verdict(const SearchReport& report);

/// Everything between the head of the page and the spec.
std::string search_sections(const SearchReport& report);

/// The page, UTF-8.
///
///   Laws      (1) same input, same bytes
///             (2) the page loads nothing
///             (3) title, spec and reasons may contain any text
///             (4) without scripts, the page contains the table and all pictures
/// Units     mm, degrees; shifts and regions in normal modules; missing values are “–”
std::string search_report(const SearchReport& report);

}  // namespace gearwright
