// A figure as data: what its curves and bars are made of, for anybody's own plots.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// {"id", "title", "description", "x": {"words", "unit"}, "y", "curves": [{"name", "points": [[x, y], …]}]}.
/// Curves are the lines that have a name and the bars, these one after the other; a break of a line
/// is [null, null].
nlohmann::ordered_json figure_data(const Figure& figure);

}  // namespace gearwright
