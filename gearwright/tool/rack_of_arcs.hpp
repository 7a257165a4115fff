// A rack whose edge is a chain of circular arcs, given by its numbers in normal modules.
//
//   x, y   height above the datum line and distance from the middle of the gear's tooth, as in
//          tool/cutter_edge.hpp                           theory: docs/theory/07-circular-arc.md
//   q      signed radius: > 0 cuts a convex part of the tooth, < 0 a concave one, 0 is a corner
//   τ      normal angle; an arc is  centre + q (sin τ, cos τ)
//
// The arcs follow each other from the cutter's tip, dedendum below the datum line, to the end of
// its edge, where a land ends the tooth. All circular-arc gears are reduced to this form.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

struct RackArc {
  ArcName cuts = ArcName::flank;
  double center_height = 0.0;  ///< x  modules
  double center_offset = 0.0;  ///< y  modules
  double radius = 0.0;         ///< q  modules
  Angle begin, end;            ///< τ at the root side and at the tip side
  bool working = true;         ///< true for a flank; false for a joint between two flanks
};

struct RackOfArcs {
  double addendum = 1.0;  ///< of the gear tooth above the datum line, modules
  double dedendum = 1.0;  ///< depth of the cutter, modules
  std::vector<RackArc> arcs;
};

/// Ends of neighbouring arcs this close, in modules, are one point: the later arc is moved there.
constexpr double kSameRackPoint = 1e-6;

/// The point of an arc at τ, modules.
Vec2 point_at(const RackArc& arc, Angle tau);

/// Height of the edge above the datum line, modules.
double reach(const RackOfArcs& rack);

/// Half the gear tooth's thickness of the rack on the datum line, modules; none if no arc crosses
/// it.
std::optional<double> half_thickness_on_datum(const RackOfArcs& rack);

/// The edge in mm, thinned by the allowance: E_sn < 0 moves every arc towards the middle of the
/// tooth by half of it. If the normal angle decreases from one arc to the next, the corner between
/// them cuts too and is an arc of radius 0. [T7.3]
///
/// Units     mm
/// Errors    `rack.arcs`, `rack.addendum`, `rack.dedendum` that violates a law of an edge
Result<CutterEdge> make_edge(const RackOfArcs& rack, double normal_module,
                             double thickness_allowance);

}  // namespace gearwright
