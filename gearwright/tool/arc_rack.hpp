// Describes the rack cutters F and P of circular-arc (Wildhaber-Novikov) gears.
//
//   ρ*, a*, b*   radius of the flank's arc and position of its centre, in the notation of Litvin
//                and Tsay: rack points  x = ρ sin θ − b, |y| = ρ cos θ − a. x is 0 on the datum
//                line and > 0 away from the axis of the gear that F cuts. |y| is measured from the
//                middle of the space of F, which is the middle of the tooth of P
//   ψ_c          pressure angle where the two racks touch    theory: docs/theory/07-circular-arc.md
//
// F cuts the convex teeth of one gear, and P cuts the concave teeth of the mating gear. On both
// racks, θ is the normal angle τ of tool/cutter_edge.hpp. All lengths are in normal modules.
#pragma once

#include <optional>

#include "gearwright/tool/rack_of_arcs.hpp"

namespace gearwright {

struct ArcRack {
  enum class Cutter { F, P };
  Cutter cutter = Cutter::F;
  double arc_radius = 1.4;                ///< ρ*
  double center_a = 0.0;                  ///< a*
  double center_b = 0.0;                  ///< b*
  std::optional<Angle> pressure_angle{};  ///< ψ_c from the drawing, used only for a check
  double addendum = 0.9;                  ///< addendum of the gear tooth above the pitch cylinder
  double dedendum = 0.3;                  ///< depth of the cutter below the datum line
  double root_fillet_radius = 0.35;       ///< radius of the cutter's tip rounding; 0 for a sharp
                                          ///< corner
};

/// Returns the rack with the default addendum, dedendum and tip rounding. They are 0.9, 0.3 and
/// 0.35 for F, and 0, 1.05 and 0.5 for P, as in the figures of the paper by Litvin and Tsay. Its
/// text does not contain these numbers.
ArcRack default_arc_rack(ArcRack::Cutter cutter);

/// Returns the greatest radius of the tip rounding. With this radius, the roundings of both sides
/// meet in the middle of the cutter's tip. [T7.5]
double full_radius(const ArcRack& rack);

/// Returns tip rounding and flank as a chain of arcs. The arc of the flank extends beyond the tip
/// of the gear tooth to the middle of the tooth, where the arcs of both sides meet. The arc ends at
/// a normal angle of 90° on F and of 1° on P if this angle is reached first. [T7.1], [T7.2], [T7.4]
///
/// Errors    `rack.arc_radius`, `rack.center_a`, `rack.center_b`, `rack.dedendum`,
///           `rack.root_fillet_radius`, `rack.addendum`, usually with the allowed limit;
///           `rack.pressure_angle` if no point of the arc has this angle
Result<RackOfArcs> arcs_of(const ArcRack& rack);

}  // namespace gearwright
