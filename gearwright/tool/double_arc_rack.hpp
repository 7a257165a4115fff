// The basic rack of double circular-arc gears. It has a convex arc in the addendum, a concave arc
// in the dedendum and a step between the two arcs. Two gears cut by the same rack mesh with each
// other.
//
//   α            pressure angle at the contact with the mating gear
//   ρ_a, ρ_f     radii of the convex arc in the addendum and of the concave arc in the dedendum
//   x_a, x_f     heights of the centres of these arcs above the datum line
//   l_a          distance of the convex arc's centre from the middle of the tooth, > 0 if the
//                centre and the arc are on opposite sides of the middle
//   e_f          width of the space at the contact point of the concave arc
//   h_ja, h_jf   height of the upper end of the step, depth of its lower end
//
// All lengths are in normal modules.               theory: docs/theory/07-circular-arc.md, 7.3
//
// Some of the numbers in the table of the standard follow from the others, because the arcs are
// tangent. These numbers are computed here, and the tests compare them with the table.
#pragma once

#include "gearwright/tool/rack_of_arcs.hpp"

namespace gearwright {

struct DoubleArcRack {
  Angle pressure_angle = Angle::degrees(24);  ///< α
  double addendum = 0.9;                      ///< h_a*
  double dedendum = 1.1;                      ///< h_f*
  double convex_radius = 1.3;                 ///< ρ_a*
  double concave_radius = 1.42;               ///< ρ_f*
  double convex_height = 0.0163;              ///< x_a*
  double concave_height = 0.0325;             ///< x_f*
  double convex_offset = 0.6289;              ///< l_a*
  double space_width = 1.1773;                ///< e_f*
  double step_height = 0.16;                  ///< h_ja*
  double step_depth = 0.2;                    ///< h_jf*
  bool named = false;                         ///< true if the numbers come from the standard
};

/// Returns the rack of GB/T 12759-1991 for a module from 1.5 to 3, over 3 to 6, over 10 to 16 or
/// over 32 to 50 mm.
///
/// Errors    `rack` for a module outside these ranges
Result<DoubleArcRack> gbt12759_rack(double normal_module);

/// Derived values, in modules. [T7.6]…[T7.9]
struct DoubleArcDerived {
  double convex_contact_height;  ///< h_k  height of the contact point of the convex arc above the
                                 ///<      datum line
  double concave_contact_depth;  ///< h_k  depth of the contact point of the concave arc below the
                                 ///<      datum line
  double
      contact_thickness;  ///< S_a*  thickness of the tooth at the contact point of the convex arc
  double concave_offset;  ///< l_f*  distance of the concave arc's centre beyond the space's middle
  double root_radius;     ///< r_g*  full radius of the cutter's tip
  double step_radius;     ///< r_j*  radius of the arc of the step
  Angle convex_begin;     ///< δ_1   normal angle at the lower end of the convex arc
  Angle concave_end;      ///< δ_2   normal angle at the upper end of the concave arc
};

/// Computes the numbers of the rack that follow from the given numbers.
///
/// Errors    the member of `rack` that makes the rack impossible, such as `rack.step_depth`
Result<DoubleArcDerived> derived(const DoubleArcRack& rack);

/// Returns the chain of full-radius tip, concave arc, step and convex arc. The convex arc ends in
/// the middle of the gear tooth, where the arcs of both sides meet, or at a normal angle of 90° if
/// this angle is reached first.
///
/// Errors    as derived(); `rack.addendum`, `rack.step_depth`
Result<RackOfArcs> arcs_of(const DoubleArcRack& rack);

}  // namespace gearwright
