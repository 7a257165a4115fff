// Designs of a search as dots over two of their numbers.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

struct DesignDot {
  Vec2 at;
  std::string style;       ///< "dot-front", "dot-design", "dot-middle"
  std::string words = {};  ///< for the pointer
};

/// The dots in their order over axes that hold them with some room, and below them the border of the
/// front. An axis of positive values is one of powers where the greatest is more than fifteen times
/// the least.
///
/// Domain    at least one dot, all of them finite (contract)
Figure designs_figure(FigureAxis x, FigureAxis y, const std::vector<DesignDot>& dots,
                      std::vector<Vec2> border = {});

}  // namespace gearwright
