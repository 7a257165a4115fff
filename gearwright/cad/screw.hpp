// Computes rotations about the gear axis and normals of a screw surface.
//
//   τ  twist, rad/mm     P, n  point and unit normal of a transverse section
#pragma once

#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/vector.hpp"

namespace gearwright {

inline SinCos sincos_of(double angle) { return {std::sin(angle), std::cos(angle)}; }

inline Vec2 turned(const Vec2& v, const SinCos& a) {
  return {a.cos * v.x() - a.sin * v.y(), a.sin * v.x() + a.cos * v.y()};
}

inline Vec2 turned(const Vec2& v, double angle) { return turned(v, sincos_of(angle)); }

inline Vec3 turned_about_axis(const Vec3& v, const SinCos& a) {
  const Vec2 plane = turned(v.head<2>(), a);
  return {plane.x(), plane.y(), v.z()};
}

/// Returns the outward normal of an outline, computed from the angle of its tangent. `side` is σ of
/// generation/outline.hpp. Arcs run from root to tip, clockwise about the tooth.
inline Vec2 section_normal(double side, double tangent_angle) {
  return side * Vec2(-std::sin(tangent_angle), std::cos(tangent_angle));
}

/// Returns the unit normal of the screw surface. It is perpendicular to the tangent of the section
/// and to the tangent of the screw motion (τJP, 1), where J turns a vector by 90°.
inline Vec3 screw_normal(const Vec2& p, const Vec2& n, double twist) {
  return Vec3(n.x(), n.y(), twist * (n.x() * p.y() - n.y() * p.x())).normalized();
}

}  // namespace gearwright
