// The sections of a design search's page.
#pragma once

#include <string>

#include "gearwright/report/search_report.hpp"

namespace gearwright {

inline constexpr std::size_t kRegionPictures = 20;  ///< of the best designs

/// Counts and the best design in two or three sentences (HTML).
std::string search_verdict(const SearchReport& report);

/// Everything between the head of the page and the spec.
std::string search_sections(const SearchReport& report);

}  // namespace gearwright
