// A rack whose edge is a chain of circular arcs. All lengths are in normal modules.
//
//   x, y   height above the datum line and distance from the middle of the gear's tooth, as in
//          tool/cutter_edge.hpp                           theory: docs/theory/07-circular-arc.md
//   q      signed radius: q > 0 cuts a convex part of the tooth, q < 0 a concave part,
//          q = 0 a corner
//   τ      normal angle; the points of an arc are  centre + q (sin τ, cos τ)
//
// The arcs follow each other from the cutter's tip, which lies one dedendum below the datum line,
// to the end of the edge, where a land ends the tooth. All racks of circular-arc gears are
// converted to this form.
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
  bool working = true;         ///< true for a flank; false for a tip rounding or for a joint
                               ///< between two flanks
};

struct RackOfArcs {
  double addendum = 1.0;  ///< addendum of the gear tooth above the datum line, modules
  double dedendum = 1.0;  ///< depth of the cutter below the datum line, modules
  std::vector<RackArc> arcs;
};

/// Largest permitted gap between arcs, modules. The later arc is moved to close the gap.
constexpr double kSameRackPoint = 1e-6;

Vec2 point_at(const RackArc& arc, Angle tau);

/// Returns the rounding of the cutter's tip, from its lowest point to the normal angle `end`. Its
/// centre is `height` above the datum line.
RackArc tip_rounding(double height, double offset, double radius, Angle end);

/// Returns the height of the end of the edge above the datum line, modules.
double reach(const RackOfArcs& rack);

/// Returns half of the tooth thickness on the datum line, modules, or none if no arc crosses it.
std::optional<double> half_thickness_on_datum(const RackOfArcs& rack);

/// Returns the edge in mm, for a gear tooth with a thickness allowance. An allowance E_sn < 0 moves
/// every arc by |E_sn|/2 towards the middle of the gear tooth. If the normal angle decreases from
/// one arc to the next, the corner between the two arcs also cuts and becomes an arc of radius 0.
/// [T7.3]
///
/// Units     mm
/// Errors    `rack.arcs`, `rack.arcs[N]`, `rack.addendum` or `rack.dedendum` if a length is too
///           great, if no arc cuts the flank, or if the edge violates a law of CutterEdge
Result<CutterEdge> make_edge(const RackOfArcs& rack, double normal_module,
                             double thickness_allowance);

}  // namespace gearwright
