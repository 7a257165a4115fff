// The rack cutters F and P of circular-arc (Wildhaber-Novikov) gears.
//
//   ρ*, a*, b*   radius of the flank's arc and place of its centre, in the notation of the paper of
//                Litvin and Tsay: rack points  x = ρ sin θ − b, |y| = ρ cos θ − a, from the axis of
//                gear 1 towards that of gear 2 and from the middle of F's space = P's tooth
//   ψ_c          pressure angle where the two racks touch    theory: docs/theory/07-circular-arc.md
//
// F cuts the convex teeth of one gear, P the concave ones of its mating gear; θ is the normal angle
// τ of tool/cutter_edge.hpp on both. Everything is in normal modules.
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
  std::optional<Angle> pressure_angle{};  ///< ψ_c from the drawing, used as a check only
  double addendum = 0.9;                  ///< of the gear's tooth above the pitch cylinder
  double dedendum = 0.3;                  ///< depth of the cutter below the datum line
  double root_fillet_radius = 0.35;       ///< the cutter's tip rounding; 0 is a sharp corner
};

/// Default addendum, dedendum and tip rounding: F 0.9, 0.3, 0.35; P 0, 1.05, 0.5. (These numbers
/// are in the figures of the paper, not in its text.)
ArcRack default_arc_rack(ArcRack::Cutter cutter);

/// The greatest tip rounding, whose two sides meet in the middle of the cutter's tip. [T7.5]
double full_radius(const ArcRack& rack);

/// Tip rounding and flank as a chain of arcs. The arc of the flank extends beyond the tip: for F
/// until both sides meet, for P until its normal is at 1° to the datum line. [T7.1], [T7.2], [T7.4]
///
/// Errors    `rack.arc_radius`, `rack.center_a`, `rack.dedendum`, `rack.root_fillet_radius`,
///           `rack.addendum` with a value that fits; `rack.pressure_angle` when the arc has no such
///           point
Result<RackOfArcs> arcs_of(const ArcRack& rack);

}  // namespace gearwright
