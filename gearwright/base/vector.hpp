// Plane and space vectors, in mm unless stated otherwise.
#pragma once

#include <Eigen/Core>

namespace gearwright {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// The mirror image about the x axis.
inline Vec2 mirrored(const Vec2& v) { return {v.x(), -v.y()}; }

}  // namespace gearwright
