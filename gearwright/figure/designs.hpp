// Shows the designs of a search as dots over two of their quantities.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

struct DesignDot {
  Vec2 at;
  std::string style;       ///< "dot-front", "dot-design", "dot-middle"
  std::string words = {};  ///< the design, shown at the pointer with its two values
};

/// Draws the border of the Pareto front, and over it the dots in their order. The axes extend a
/// little beyond the dots. An axis of positive values is logarithmic if the greatest value exceeds
/// fifteen times the least.
///
/// Domain    at least one dot, all of them finite (contract)
Figure designs_figure(FigureAxis x, FigureAxis y, const std::vector<DesignDot>& dots,
                      std::vector<Vec2> border = {});

}  // namespace gearwright
