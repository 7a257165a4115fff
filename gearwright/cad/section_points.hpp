// Places as few points on the section of half a tooth as the chord tolerance permits.
//
//   κ   curvature, 1/mm      a   chord of a segment, mm     Δ   turn between adjacent levels of the
//       grid, rad
//   ε   chord tolerance, mm  ρ   largest radius, mm
//
// The density of points follows from (M1) of mesh.hpp, as an equation with d = κa²/8:
//     κa² + 2a|Δ| + ρΔ² = 8ε   =>   1/a = (|Δ| + √(Δ² + κE)) / E,   E = 8ε − ρΔ².
// The density is at least κ divided by facet_turn. The integral of the density along an arc is the
// number of segments. The points divide this integral into equal parts.
#pragma once

#include <cstddef>
#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct SectionPoint {
  Vec2 point;        ///< mm
  Vec2 root_normal;  ///< unit vector, out of the material, for the side towards the root
  Vec2 tip_normal;   ///< unit vector for the side towards the tip; differs from root_normal at a
                     ///< corner
  std::size_t arc;   ///< index of the arc of the outline on which the point lies
  double u;          ///< position on that arc, from 0 to 1
};

struct SectionTolerance {
  double chord;       ///< ε  mm
  double facet_turn;  ///< rad, greatest change of the tangent direction over a segment
  double level_turn;  ///< |Δ|  rad
  double radius;      ///< ρ  mm
};

/// Returns the points from the middle of the space to the centre line of the tooth. The first point
/// lies exactly on the ray π/|z|, and the last one exactly on the x axis. Neighbouring points that
/// are closer than ε/50 are merged, which moves the boundary by less than this distance. If more
/// than `most` points are needed, the list is incomplete and has more than `most` points.
///
/// Accuracy  (M1) < ε on every segment, with d measured at five points inside it
/// Domain    ρΔ² < 8ε; the ends lie within 1e-6 ρ of their rays (contract)
std::vector<SectionPoint> section_points(const Outline& outline, const SectionTolerance& tolerance,
                                         std::size_t most);

}  // namespace gearwright
