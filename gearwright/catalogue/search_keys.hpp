// The keys of [search] for a search for pairs.
#pragma once

#include <string_view>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

/// The objective for a synonym, "mass" for "weight", or "" if the word is not a synonym. The
/// objective may belong to searches for pairs, for drives, or for both.
std::string_view objective_called(std::string_view word);

}  // namespace gearwright
