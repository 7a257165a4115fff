// Poses between named frames: X_ab maps coordinates in frame B to coordinates in frame A.
//
//   Housing f      z along axis 1, x along the common perpendicular from axis 1 to axis 2, origin
//                  on axis 1
//   Gear1, Gear2   z along the gear's axis, x the centre line of tooth 0 in the section z = 0
//                                                          theory: docs/theory/01-frames.md
//
// In a product, the letters on both sides of a `*` must be equal. Therefore, X_2f * X_f1 * r_1
// compiles, and X_f1 * X_2f does not. Each `*` is one product of matrices. Other rooms declare
// their own frames.
#pragma once

#include <cmath>

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

/// A direction or a displacement, given by its coordinates in a frame. It has no point of
/// application, so the origin of the frame does not matter.
template <class Frame>
struct FreeVector {
  Vec3 v = Vec3::Zero();
};

template <class F>
FreeVector<F> operator+(const FreeVector<F>& a, const FreeVector<F>& b) {
  return {a.v + b.v};
}

template <class F>
FreeVector<F> operator*(const FreeVector<F>& a, double factor) {
  return {a.v * factor};
}

/// The rotation about z. It does not change the z axis or z coordinates, not even in the last bit.
inline Mat3 about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return Mat3{{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
}

/// A linear map of free vectors: a rotation, or its derivative with respect to an angle.
template <class To, class From>
class LinearMap {
 public:
  LinearMap() = default;  ///< the identity
  explicit LinearMap(const Mat3& matrix) : matrix_(matrix) {}
  const Mat3& matrix() const { return matrix_; }

 private:
  Mat3 matrix_ = Mat3::Identity();
};

template <class A, class B, class C>
LinearMap<A, C> operator*(const LinearMap<A, B>& ab, const LinearMap<B, C>& bc) {
  return LinearMap<A, C>(ab.matrix() * bc.matrix());
}

template <class A, class B>
FreeVector<A> operator*(const LinearMap<A, B>& ab, const FreeVector<B>& v_b) {
  return {ab.matrix() * v_b.v};
}

template <class To, class From>
class Pose {
 public:
  Pose() = default;
  explicit Pose(const Eigen::Isometry3d& isometry) : isometry_(isometry) {}
  Pose(const Vec3& origin, const Mat3& rotation) {
    isometry_.linear() = rotation;
    isometry_.translation() = origin;
  }
  const Eigen::Isometry3d& isometry() const { return isometry_; }
  Pose<From, To> inverse() const { return Pose<From, To>(isometry_.inverse()); }

  Vec3 origin() const { return isometry_.translation(); }  ///< origin of From, in the frame To, mm
  /// The direction of the axis x (0), y (1) or z (2) of From, in the frame To.
  Vec3 axis(int i) const { return isometry_.linear().col(i); }
  /// The azimuth of the x axis of From about the z axis of To, rad.
  double turn() const { return std::atan2(isometry_(1, 0), isometry_(0, 0)); }
  /// The part of the pose in the xy plane of To.
  Eigen::Isometry2d plan() const {
    Eigen::Isometry2d x = Eigen::Isometry2d::Identity();
    x.linear() = isometry_.linear().template topLeftCorner<2, 2>();
    x.translation() = isometry_.translation().template head<2>();
    return x;
  }
  /// True if the pose is the identity to the last bit.
  bool is_identity() const { return isometry_.matrix() == Eigen::Matrix4d::Identity(); }

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
