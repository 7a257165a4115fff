// Settings of a search whose designs are checked as drawings: tolerances, the verdict over the
// drawings, and default limits that exclude impractical designs.
//
// Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// Drawings are checked if the search has a rating, face widths or allowances, unless designs with
/// interference are listed too. `search`: the table; its rating has been read.
void read_search_drawing(const Json& search, SearchProblem& problem);

}  // namespace gearwright
