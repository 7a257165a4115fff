// A linear axis of a plot, with round values for its ticks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/report/svg.hpp"

namespace gearwright {

/// Values lo … hi at the places from … to, px.
struct Axis {
  double lo, hi;
  double from, to;

  double operator()(double v) const { return from + (v - lo) / (hi - lo) * (to - from); }
  /// The same, no further outside than the axis is long: for curves that leave their plot.
  double near(double v) const;
};

/// The place of a plot in its picture, px.
struct PlotArea {
  double width;        ///< of the picture
  double left, right;  ///< from the picture's edges to the plot's
  double top, tall, foot;

  constexpr double bottom() const { return top + tall; }
  constexpr double height() const { return bottom() + foot; }  ///< of the picture
  Axis across(double lo, double hi) const { return {lo, hi, left, width - right}; }
  Axis up(double lo, double hi) const { return {lo, hi, bottom(), top}; }
};

struct Ticks {
  std::vector<double> values;
  int decimals;  ///< by which they differ
};

/// Round values within [lo, hi]: multiples of 1, 2 or 5 times a power of ten.
///
/// Domain    lo < hi, most ≥ 1 (contract)
/// Laws      at most most + 1 values
Ticks round_ticks(double lo, double hi, int most);

/// Those of them that lie between lo and hi.
std::vector<double> levels_between(double lo, double hi, int most);

/// lo … hi widened by `share` of its length on both sides; a single value gets room of its own.
std::vector<double> widened(double lo, double hi, double share);

/// Horizontal lines with their values at the left of the plot, `most` + 1 at most, and one at its
/// foot.
void draw_rows(Svg& svg, const Axis& x, const Axis& y, int most);

/// Values below the plot, and the words under them (SVG markup).
void draw_foot(Svg& svg, const Axis& x, double top, double bottom, int most,
               std::string_view words);

/// Points as one curve, without pieces of it that are far outside; it ends before a point that is not
/// finite and begins anew behind it.
void draw_curve(Svg& svg, const Axis& x, const Axis& y, const std::vector<Vec2>& values,
                std::string_view style);

/// A curve of a plot and the classes it is drawn with.
struct PlotCurve {
  std::vector<Vec2> values;
  std::string style;
  bool dots = false;
};

/// What stands around the curves.
struct PlotWords {
  std::string id, title, description;  ///< plain text
  std::string up, along;               ///< SVG markup: the quantities of the axes
};

/// Curves over their common range; with `from_zero` the values' axis begins at 0. Empty where they
/// have no range.
std::string curves_svg(const PlotWords& words, const std::vector<PlotCurve>& curves,
                       bool from_zero);

}  // namespace gearwright
