// Reads [search] of a spec, and the keys of [gear1] and [gear2] that a search does not choose:
// pressure angle, rack, helix, face width.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include "gearwright/design/search_problem.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// The tables as given; null if the spec has none.
SearchProblem read_search(const Json& search, const Json* gear_1, const Json* gear_2);

/// ISO 54 series I, and II, mm.
const std::vector<double>& iso54_modules(int series);

}  // namespace gearwright
