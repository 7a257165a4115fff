// A point or direction in the plane, turned about the origin.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace gearwright::oracle {

inline Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

}  // namespace gearwright::oracle
