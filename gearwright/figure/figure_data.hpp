// Writes the points of a figure's curves and bars as data, for the user's own plots.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// Returns {"id", "title", "description", "x": {"words", "unit"}, "y", "curves": [{"name",
/// "points": [[x, y], …]}]}. Each line with words is a curve, and all bars with words together are
/// one more curve. The point [null, null] marks a break of a line. Circles and named dots, if there
/// are any, are in "circles" and "points". The values of a map are in "grid": {"words", "unit",
/// "x": […], "y": […], "values": [[…], …]}. "values" has one row for each y, and null for a point
/// without a value.
nlohmann::ordered_json figure_data(const Figure& figure);

}  // namespace gearwright
