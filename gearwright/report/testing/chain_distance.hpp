// The distance of a point from a chain of points.
#pragma once

#include <algorithm>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright::testing {

inline double chain_distance(const std::vector<Vec2>& chain, const Vec2& p) {
  double least = kInfinity;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Vec2 ab = chain[i + 1] - chain[i];
    const double square = ab.squaredNorm();
    const double t = square > 0.0 ? std::clamp((p - chain[i]).dot(ab) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, (p - chain[i] - t * ab).norm());
  }
  return least;
}

}  // namespace gearwright::testing
