// A linear axis of a plot, with round values for its ticks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/svg.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

/// Maps the values lo … hi to the positions from … to, px.
struct Axis {
  double lo, hi;
  double from, to;

  double operator()(double v) const { return from + (v - lo) / (hi - lo) * (to - from); }
  /// The same mapping, limited to one axis length outside, for curves that leave their plot.
  double near(double v) const;
};

/// The position of a plot in its picture, px.
struct PlotArea {
  double width;        ///< of the picture
  double left, right;  ///< distances between the edges of the picture and of the plot
  double top, tall, foot;

  constexpr double bottom() const { return top + tall; }
  constexpr double height() const { return bottom() + foot; }  ///< of the picture
  Axis across(double lo, double hi) const { return {lo, hi, left, width - right}; }
  Axis up(double lo, double hi) const { return {lo, hi, bottom(), top}; }
};

/// Draws at most `most` + 1 horizontal lines with their values at the left of the plot, and one at
/// its bottom.
void draw_rows(Svg& svg, const Axis& x, const Axis& y, int most);

/// Draws values below the plot, with the words under them (SVG markup).
void draw_foot(Svg& svg, const Axis& x, double top, double bottom, int most,
               std::string_view words);

/// Draws points as one curve, without pieces that are far outside. It ends before a point that is
/// not finite and continues after it.
void draw_curve(Svg& svg, const Axis& x, const Axis& y, const std::vector<Vec2>& values,
                std::string_view style);

}  // namespace gearwright
