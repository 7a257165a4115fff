// Writes one HTML page about a design search, for users: the number of trials, the best designs in
// a sortable table, and pictures of their objectives and of the regions of their profile shifts.
//
// Like the report of a pair (report/report.hpp), the page is one self-contained file and depends
// only on its input.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/design/search.hpp"

namespace gearwright {

struct SearchReport {
  std::string title;      ///< if empty, a title is made from the range of ratios
  std::string spec_text;  ///< the spec, verbatim; omitted if empty
  const Search& search;
  const SearchAnswer& answer;
  std::vector<std::string> reasons;   ///< plain text: warnings, and if no design is feasible, the
                                      ///< reasons and changes that would help
  std::size_t rows = 200;             ///< number of designs in the table
  std::string version;                ///< version of the program
  UnitSystem units = UnitSystem::mm;  ///< of the lengths; the axes of pictures are in mm
};

inline constexpr std::size_t kRegionPictures = 20;  ///< number of the best designs that have a
                                                    ///< picture

/// The numbers of trials and feasible designs, and the best design, in two or three sentences
/// (HTML).
std::string search_verdict(const SearchReport& report);

/// The part of the page between the head and the spec.
std::string search_sections(const SearchReport& report);

/// The page, UTF-8.
///
///   Laws      (1) same input, same bytes
///             (2) the page loads nothing
///             (3) title, spec and reasons may contain any text
///             (4) without scripts, the page contains the table and all pictures
/// Units     those of the spec, degrees; shifts and regions in normal modules; missing values are “–”
std::string search_report(const SearchReport& report);

}  // namespace gearwright
