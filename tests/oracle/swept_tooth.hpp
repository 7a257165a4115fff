// The finished tooth from the swept rack: half angles, root radius, form radius and the radius at
// which the tooth is pointed. They are found by walking over the material with
// `SweptRack::clearance` alone.
//
//   ρ, θ     polar coordinates of the gear frame; tooth 0 is centred on θ = 0
//   r_a      radius of the blank
//   r_b      base radius r cos α_t of the main flank's involute
//
// The walk.  The clearance changes by no more than the distance walked. A step as long as the
// clearance therefore cannot pass the surface, so the walk cannot miss the first crossing.
#pragma once

#include <optional>

#include "tests/oracle/swept_rack.hpp"

namespace gearwright::oracle {

struct Neck {
  double radius;      ///< mm
  double half_angle;  ///< rad
};

/// The largest θ for which all points (ρ, |angle| < θ) of tooth 0 are material. It is 0 if the
/// centre line is cut away or ρ > r_a, and π/z if nothing at this radius is cut.
/// Units     mm, rad
/// Accuracy  1e-12 mm of arc over the sine of the angle between the surface and the circle ρ
double material_half_angle(const SweptRack& rack, double radius);

/// The first radius between `from` and `limit` at which the ray with this polar angle meets the
/// surface. Absent if the ray does not meet it; `from` if the point at this radius is itself cut
/// away.
/// Accuracy  1e-12 mm over the sine of the angle between the surface and the ray
std::optional<double> surface_radius(const SweptRack& rack, double angle, double from,
                                     double limit);

/// Radius of the finished root in the middle of the space. It is 0 if the axis itself is cut away.
double root_radius(const SweptRack& rack);

/// Returns true if a point of the centre line of tooth 0 within the reference circle is cut away.
bool severed(const SweptRack& rack);

/// The radius at which the flanks meet on the centre line. Absent if the tooth is severed, or if
/// this radius is not below the blank (without a blank, 2 r + 4 m).
std::optional<double> pointed_radius(const SweptRack& rack);

/// Half angle of the involute of the main flank. Its base radius is r cos α_t, and its thickness on
/// the reference circle equals the space of the rack.
/// Units     mm, rad          Domain    radius ≥ r_b
double involute_half_angle(const SweptRack& rack, double radius);

/// The lowest radius from which the finished surface is this involute. Absent if there is no such
/// radius.
/// Accuracy  if the tooth is undercut, the surface leaves the involute at an angle: 1e-11 mm over
///           the sine of this angle. Otherwise the surface leaves along the tangent, and its
///           quadratic departure is extrapolated: 1e-7 m. Within 1e-3 m of the base circle, it
///           cannot be extrapolated: 1e-6 mm
std::optional<double> form_radius(const SweptRack& rack);

/// The smallest half angle of the tooth below the form radius. Absent for a severed tooth.
/// Accuracy  the half angle 1e-11 rad; its radius, at a flat minimum, 1e-5 m
std::optional<Neck> neck(const SweptRack& rack);

}  // namespace gearwright::oracle
