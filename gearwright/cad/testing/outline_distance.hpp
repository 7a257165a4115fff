// Measures the distance from points to the outline of a tooth, for tests of the CAD files.
#pragma once

#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright::testing {

/// Returns the distance from a point of the plane to the outline of tooth 0, mm. This outline is
/// the half outline and its mirror image.
class OutlineDistance {
 public:
  explicit OutlineDistance(const Outline& outline);
  double operator()(Vec2 q) const;

 private:
  double refined(std::size_t arc, std::size_t sample, const Vec2& q) const;

  Outline outline_;
  std::vector<std::vector<Vec2>> samples_;
  double gap_ = 0.0;
};

}  // namespace gearwright::testing
