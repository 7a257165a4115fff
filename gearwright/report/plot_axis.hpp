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

struct Ticks {
  std::vector<double> values;
  int decimals;  ///< that tell them apart
};

/// Round values within [lo, hi]: multiples of 1, 2 or 5 times a power of ten.
///
/// Domain    lo < hi, most ≥ 1 (contract)
/// Laws      at most most + 1 values
Ticks round_ticks(double lo, double hi, int most);

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

}  // namespace gearwright
