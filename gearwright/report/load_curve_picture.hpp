// Curves of teeth under load: transmission error, load shares and stiffness while the gears turn, and
// what changes with the torque.
#pragma once

#include <string>

#include "gearwright/report/load_report.hpp"

namespace gearwright {

/// One figure each.
std::string loaded_te_figure(const LoadReport& report);
std::string share_figure(const LoadReport& report);
std::string stiffness_figure(const LoadReport& report);
/// The Harris map; empty with one torque.
std::string harris_figure(const LoadReport& report);

/// A curve of a plot and the classes it is drawn with.
struct PlotCurve {
  std::vector<Vec2> values;
  std::string style;
  bool dots = false;
};

/// What stands around the curves.
struct PlotWords {
  std::string id, title, description;  ///< plain text
  std::string up, along;               ///< SVG markup: what the axes carry
};

/// Curves over their common range; with `from_zero` the values' axis begins at 0. Empty where they
/// have no range.
std::string curves_svg(const PlotWords& words, const std::vector<PlotCurve>& curves,
                       bool from_zero);

}  // namespace gearwright
