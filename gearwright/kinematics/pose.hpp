// Poses between named frames: X_ab maps coordinates in frame B to coordinates in frame A.
//
//   Housing f      z along axis 1, x along the common perpendicular from axis 1 to axis 2, origin
//                  on axis 1
//   Gear1, Gear2   z along the gear's axis, x the centre line of tooth 0 in the section z = 0
//                                                          theory: docs/theory/01-frames.md
//
// In a product, the letters on both sides of a `*` must be equal. Therefore, X_2f * X_f1 * r_1
// compiles, and X_f1 * X_2f does not compile.
#pragma once

#include <Eigen/Geometry>

#include "gearwright/base/vector.hpp"

namespace gearwright {

struct Housing {};
struct Gear1 {};
struct Gear2 {};

/// The coordinates of a point in a frame, mm.
template <class Frame>
struct Point {
  Vec3 r = Vec3::Zero();
};

template <class To, class From>
class Pose {
 public:
  Pose() = default;
  explicit Pose(const Eigen::Isometry3d& isometry) : isometry_(isometry) {}
  const Eigen::Isometry3d& isometry() const { return isometry_; }
  Pose<From, To> inverse() const { return Pose<From, To>(isometry_.inverse()); }

 private:
  Eigen::Isometry3d isometry_ = Eigen::Isometry3d::Identity();
};

template <class A, class B, class C>
Pose<A, C> operator*(const Pose<A, B>& ab, const Pose<B, C>& bc) {
  return Pose<A, C>(ab.isometry() * bc.isometry());
}

template <class A, class B>
Point<A> operator*(const Pose<A, B>& ab, const Point<B>& r_b) {
  return {ab.isometry() * r_b.r};
}

}  // namespace gearwright
