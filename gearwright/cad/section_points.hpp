// Places the fewest points on the section of half a tooth that a chord tolerance permits.
//
//   κ   curvature, 1/mm      a   chord of a segment, mm     Δ   turn between adjacent levels of the
//       grid, rad
//   ε   chord tolerance, mm  ρ   largest radius, mm
//
// The density of points solves (M1) of mesh.hpp for equality with d = κa²/8:
//     κa² + 2a|Δ| + ρΔ² = 8ε   =>   1/a = (|Δ| + √(Δ² + κE)) / E,   E = 8ε − ρΔ².
// The integral of the density along an arc is the number of segments. Equal parts of the integral
// give the positions of the points.
#pragma once

#include <cstddef>
#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct SectionPoint {
  Vec2 point;        ///< mm
  Vec2 root_normal;  ///< unit, out of the material, on the side of the root
  Vec2 tip_normal;   ///< the same on the side of the tip; differs at a corner of the outline
  std::size_t arc;   ///< index of the arc of the outline on which the point lies
  double u;          ///< position on that arc, from 0 to 1
};

struct SectionTolerance {
  double chord;       ///< ε  mm
  double facet_turn;  ///< rad, largest turn of the tangent over a segment (by the curvature)
  double level_turn;  ///< |Δ|  rad
  double radius;      ///< ρ  mm
};

/// Returns the points from the middle of the space to the middle of the tooth. The first lies
/// exactly on the ray π/|z| and the last exactly on the x axis. Neighbours that are closer than
/// chord/50 are joined, which moves the boundary by less than that distance. Points beyond the
/// number `most` are omitted.
///
/// Accuracy  (M1) < ε on every segment, with d measured at five points inside it
/// Domain    ρΔ² < 8ε, the ends lie on their rays within 1e-6 ρ (contract)
std::vector<SectionPoint> section_points(const Outline& outline, const SectionTolerance& tolerance,
                                         std::size_t most);

}  // namespace gearwright
