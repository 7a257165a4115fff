// Describes the edge of a cutter in its normal section by a chain of named arcs from the middle of
// the cutter's tooth to the middle of the cutter's space.
//
//   x    height above the datum line, away from the gear axis, mm
//   y    coordinate along the datum line, mm; y = 0 in the middle of the cutter's space, which is
//        the middle of the gear tooth
//   τ    normal angle: (sin τ, cos τ) is the outward normal of the gear surface that the point cuts
//                                              theory: docs/theory/03-rack-and-generation.md
//
// A new kind of cutter requires only a function that returns such a chain. The code in generation/
// computes the tooth from the chain.
//   Laws  (1) arcs follow each other without a gap   (2) 0 < τ ≤ π/2
//         (3) x never decreases along the chain      (4) y decreases along the chain
//         (5) y ≥ 0, except on a line without an end
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/curve/curve.hpp"

namespace gearwright {

inline constexpr double kMaxModules = 1e4;  ///< upper limit of every length of a cutter

/// A straight piece. `end_height` is infinite for a flank that extends beyond every tip.
struct EdgeLine {
  Angle tau;            ///< τ  constant
  double y_datum;       ///< y of the extended line at x = 0, mm:  y = y_datum − x tan τ
  double begin_height;  ///< x  mm
  double end_height;    ///< x  mm
};

/// A circular piece with the points  centre + q (sin τ, cos τ).
struct EdgeCircle {
  Vec2 center;  ///< (x, y) mm
  double
      q;  ///< mm; < 0 for a convex arc of the cutter (tip), > 0 for a concave arc (bottom), 0 for a
          ///< corner
  Angle begin_tau;
  Angle end_tau;
};

struct EdgeArc {
  ArcName cuts;  ///< the part of the gear tooth that the arc cuts
  std::variant<EdgeLine, EdgeCircle> shape;
  bool smooth_start = true;  ///< true if the arc starts at the point and with the normal at which
                             ///< the preceding arc ends
};

struct CutterEdge {
  double tip_depth;  ///< depth of the tip land below the datum line, mm
  double
      tip_land_end;  ///< y where the tip land ends and the first arc begins, mm; the land starts at
                     ///< πm/2
  std::vector<EdgeArc> arcs;
  double bottom_height =
      std::numeric_limits<double>::infinity();  ///< height of the bottom land, mm
  double flank_begin_depth;  ///< h_Ff  mm, start of the flank below the datum line
  double flank_end_height;   ///< mm, end of the flank above the datum line; infinite if the flank
                             ///< has no end
};

}  // namespace gearwright
