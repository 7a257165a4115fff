// The keys of [search]: what a design search is asked.
#pragma once

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

/// The objective that a word means, "mass" of "weight"; empty: none.
std::string_view objective_called(std::string_view word);

}  // namespace gearwright
