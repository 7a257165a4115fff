#include "gearwright/generation/outline.hpp"

#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

Vec2 Arc::point(double u) const {
  if (u == 0.0) return begin_point;
  if (u == 1.0) return end_point;
  return curve->point(begin + u * (end - begin));
}

CurvePoint Arc::at(double u) const {
  CurvePoint result = curve->at(begin + u * (end - begin));
  if (end < begin) {
    result.tangent_angle += std::numbers::pi;
    result.curvature = -result.curvature;
  }
  return result;
}

const Arc* Outline::find(ArcName name) const {
  for (const Arc& arc : arcs)
    if (arc.name == name) return &arc;
  return nullptr;
}

std::vector<Vec2> sample(const Arc& arc, int n) {
  GW_EXPECTS(n >= 2);
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(n));
  points.push_back(arc.begin_point);
  const double step = (arc.end - arc.begin) / (n - 1);
  for (int i = 1; i < n - 1; ++i) points.push_back(arc.curve->point(arc.begin + step * i));
  points.push_back(arc.end_point);
  return points;
}

}  // namespace gearwright
