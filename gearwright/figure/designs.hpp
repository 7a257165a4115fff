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

/// Draws the dots in their order on axes with some margin, and under them the border of the Pareto
/// front. An axis of positive values is logarithmic if the greatest value exceeds fifteen times the
/// least.
///
/// Domain    at least one dot, all of them finite (contract)
Figure designs_figure(FigureAxis x, FigureAxis y, const std::vector<DesignDot>& dots,
                      std::vector<Vec2> border = {});

}  // namespace gearwright
