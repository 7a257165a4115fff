// Writes a figure as data: the points of its curves and bars, for the user's own plots.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// {"id", "title", "description", "x": {"words", "unit"}, "y", "curves": [{"name", "points": [[x,
/// y], …]}]}. The curves are the named lines, and the bars as one additional curve. A break of a
/// line is
/// [null, null]. If there are circles or named dots, they are in "circles" and "points". The values
/// of a map are in "grid": {"words", "unit", "x": […], "y": […], "values": [[…], …]}, a row for each
/// y, null where there is no value.
nlohmann::ordered_json figure_data(const Figure& figure);

}  // namespace gearwright
