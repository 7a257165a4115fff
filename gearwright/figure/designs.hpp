// Designs of a search as dots over two of their numbers.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

struct DesignDot {
  Vec2 at;
  std::string style;       ///< "dot-front", "dot-design", "dot-middle"
  std::string words = {};  ///< shown at the pointer
};

/// The dots in their order over axes with some room around them, and below them the border of the
/// front. An axis of positive values is logarithmic if the greatest is more than fifteen times the
/// least.
///
/// Domain    at least one dot, all of them finite (contract)
Figure designs_figure(FigureAxis x, FigureAxis y, const std::vector<DesignDot>& dots,
                      std::vector<Vec2> border = {});

}  // namespace gearwright
