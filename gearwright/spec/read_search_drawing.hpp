// What a search adds for designs that are drawn: their tolerances, the verdict over their drawings,
// and default limits that keep out what nobody would make.
//
// Internal to spec/: throws SpecError.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// Designs are drawn if their strength, their face width or their allowances are asked for, unless
/// designs with interference are listed too. `search`: the table; its rating has been read.
void read_search_drawing(const Json& search, SearchProblem& problem);

}  // namespace gearwright
