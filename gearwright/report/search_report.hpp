// One HTML page about a design search, for users: the tried candidates, the best designs in a
// sortable table, and pictures of their objectives and of the regions of their profile shifts.
//
// As the report of a pair (report/report.hpp): a function of its input alone, in one file that
// needs nothing else.
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
  std::vector<std::string> reasons;  ///< plain text: reasons if nothing fits, changes that would
                                     ///< help, warnings
  std::size_t rows = 200;            ///< number of designs in the table
  std::string version;               ///< of the program
};

inline constexpr std::size_t kRegionPictures = 20;  ///< of the best designs

/// Counts and the best design in two or three sentences (HTML).
std::string search_verdict(const SearchReport& report);

/// Everything between the head of the page and the spec.
std::string search_sections(const SearchReport& report);

/// The page, UTF-8.
///
///   Laws      (1) same input, same bytes
///             (2) no request leaves the page
///             (3) title, spec and reasons are text, with any content
///             (4) without script the table and all pictures are there
/// Units     mm, degrees; shifts and regions in normal modules; missing values are “–”
std::string search_report(const SearchReport& report);

}  // namespace gearwright
