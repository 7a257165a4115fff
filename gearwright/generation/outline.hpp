// Describes the transverse outline of half a tooth by named arcs from the middle of the space to
// the middle of the tooth. The centre line of the tooth is the x axis, and the half tooth lies on
// the side y > 0.
//
//   Laws  (1) each arc ends at the start of the next arc, to the last bit
//         (2) the polar angle is π/|z| at the first point and 0 at the last point
//         (3) radii never decrease from the first arc to the last (external teeth)
#pragma once

#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/curve/curve.hpp"

namespace gearwright {

struct Arc {
  ArcName name;
  CurvePtr curve;
  double begin;      ///< curve parameter at the root side
  double end;        ///< curve parameter at the tip side
  Vec2 begin_point;  ///< equals the end_point of the previous arc to the last bit
  Vec2 end_point;

  /// Returns the point at u, where u increases from 0 at begin_point to 1 at end_point.
  Vec2 point(double u) const;
  CurvePoint at(double u) const;
};

struct Outline {
  int teeth = 0;  ///< z, negative for an internal gear
  std::vector<Arc> arcs;

  double side() const { return side_of(teeth); }  ///< σ
  const Arc* find(ArcName name) const;            ///< first arc of that name; null if none
};

/// Returns n points of an arc, including both ends.   Domain: n ≥ 2 (contract)
std::vector<Vec2> sample(const Arc& arc, int n);

}  // namespace gearwright
