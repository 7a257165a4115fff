// Makes the sentences about a search, for the terminal and the page. Internal to job/.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/report/search_report.hpp"

namespace gearwright {

inline constexpr std::string_view kPairNotRead =
    "The table [pair] has no effect on a search, which uses center_distance_mm and mounting of "
    "[search].";

inline constexpr std::string_view kTeethNotRead =
    "The numbers of teeth, the modules and the profile shifts of [gear1] and [gear2] have no "
    "effect on a search, which uses pinion_teeth, ratio, modules_mm and profile_shift of [search].";

/// Returns the size of the teeth in the form that [search] uses, for example "module 2" or
/// "diametral pitch 8".
std::string size_words(const SearchProblem& problem, double module);

/// Returns sentences that describe the rating, the default values, unused tables and the results
/// under load. If no design is feasible, they also describe changes that make designs feasible.
std::vector<SearchReason> reasons_of(const SearchProblem& problem, const SearchRun& run,
                                     UnitSystem units);

}  // namespace gearwright
