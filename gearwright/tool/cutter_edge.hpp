// A cutter's edge in its normal section: a chain of named arcs from the middle of the cutter's
// tooth to the middle of its space.
//
//   x    height above the datum line, away from the gear axis, mm
//   y    along the datum line, 0 in the middle of the cutter's space (= of the gear tooth), y ≥ 0
//        here
//   τ    normal angle: the outward normal of the gear surface cut there is (sin τ, cos τ)
//                                              theory: docs/theory/03-rack-and-generation.md
//
// A new cutter is a function that returns such a chain, and generation/ computes the tooth.
//   Laws  (1) arcs follow each other without a gap   (2) 0 < τ ≤ π/2
//         (3) heights never decrease along the chain     (4) y ≥ 0, falling
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/curve/arc_name.hpp"
#include "gearwright/curve/curve.hpp"

namespace gearwright {

inline constexpr double kMaxModules = 1e4;  ///< upper limit of every length of a cutter

/// A straight piece; `end_height` may be infinite (a flank that extends beyond every tip).
struct EdgeLine {
  Angle tau;       ///< τ  constant
  double y_datum;  ///< y where the (prolonged) line crosses x = 0, mm:  y = y_datum − x tan τ
  double begin_height;  ///< x  mm
  double end_height;    ///< x  mm
};

/// A circular piece, points  centre + q (sin τ, cos τ).
struct EdgeCircle {
  Vec2 center;  ///< (x, y) mm
  double q;     ///< mm; < 0 the cutter's convex tip rounding, > 0 its concave bottom, 0 a corner
  Angle begin_tau;
  Angle end_tau;
};

struct EdgeArc {
  ArcName cuts;  ///< the part of the tooth it cuts
  std::variant<EdgeLine, EdgeCircle> shape;
  bool smooth_start = true;  ///< same point and same normal as the end of the preceding arc
};

struct CutterEdge {
  double tip_depth;  ///< depth of the tip land below the datum line, mm
  double
      tip_land_end;  ///< y where the tip land ends and the first arc begins, mm; it starts at πm/2
  std::vector<EdgeArc> arcs;
  double bottom_height = std::numeric_limits<double>::infinity();  ///< of the bottom land, mm
  double flank_begin_depth;  ///< h_Ff  mm below the datum line: where the straight flank starts
  double flank_end_height;   ///< mm above it, where the flank ends; infinite without an end
};

}  // namespace gearwright
