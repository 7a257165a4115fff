// Reads [search] of a spec, and the keys of [gear1] and [gear2] that a search does not choose:
// pressure angle, rack, helix, face width.
//
// Internal to spec/. The functions throw SpecError, like the readers of single values.
#pragma once

#include "gearwright/design/search_problem.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// `search`, `gear_1` and `gear_2` are the tables as given. The tables of the gears may be null.
SearchProblem read_search(const Json& search, const Json* gear_1, const Json* gear_2);

/// The modules of ISO 54, series I (1) or series II (2), in mm.
const std::vector<double>& iso54_modules(int series);

}  // namespace gearwright
