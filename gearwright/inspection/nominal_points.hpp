// Computes nominal points of a flank, with their normals, for a measuring machine.
//
//   ξ, z   roll angle, rad, and height from the middle of the face, mm    n   unit normal, outward
//   φ      polar angle of the base tangent point, rad                     c   material removed, mm
//                                              theory: docs/theory/10-inspection.md
//
// Points are given in the gear frame. In this frame, z is the axis, and tooth 0 is centred on the x
// axis in the middle of the face. Points of a modified flank are displaced by c along −n. Their
// normals are inclined in accordance with the slopes of c.
#pragma once

#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"

namespace gearwright {

/// The sides of a tooth seen from +z, with the tooth pointing up.
enum class FlankSide { right, left };

struct NominalPoint {
  Vec3 point;       ///< mm
  Vec3 normal;      ///< unit vector, out of the material
  double diameter;  ///< d_y  mm, of the unmodified point
  double height;    ///< z    mm
};

struct PointGrid {
  int profile = 9;  ///< number of points along the profile, in equal steps of ascending roll length
  int helix = 5;    ///< number of points along the face, in equal steps
};

/// Returns the point of the flank of tooth 0 at a roll angle and a height.
///
/// Formula   φ = ±(ψ_b − σ ξ) + z 2π/p_z, point r_b (u ± σ ξ e) + z k, n = ±(cos β_b e − sin β_b k)
///           with unit vectors u radial and e tangential at φ, and k along the axis; [T10.26]. For
///           a modified flank, [T10.27]
/// Units     rad, mm
NominalPoint nominal_point(const Gear& gear, const RemovalField& removal, FlankSide side,
                           double roll, double height);

/// Returns the points of the grid over the evaluation ranges, in rows of ascending height.
///
/// Domain    both numbers of the grid ≥ 2 (contract)
std::vector<NominalPoint> nominal_points(const Gear& gear, const RemovalField& removal,
                                         FlankSide side, const EvaluationRanges& ranges,
                                         const PointGrid& grid);

/// Returns points of the root fillet next to a flank of tooth 0, from the root land to d_Ff. Rows
/// are in order of ascending height and cover the evaluation range of the helix. Modifications do
/// not change the fillet.
///
/// Formula   P = R(2π z/p_z) p + z k with a point p of the fillet in the section z = 0 and its
///           normal e, n ∝ e − (2π/p_z)(e · k × p) k; [T10.29]
/// Accuracy  points lie on the generated outline and are equally spaced along the fillet, with an
///           error of at most 1e-3 of the spacing
/// None      if the outline has no fillet, or the gear has no outline
/// Domain    both numbers of the grid ≥ 2 (contract)
std::vector<NominalPoint> fillet_points(const Gear& gear, FlankSide side,
                                        const EvaluationRanges& ranges, const PointGrid& grid);

}  // namespace gearwright
