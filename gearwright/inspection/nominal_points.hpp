// Nominal points of a flank for a measuring machine, with their normals.
//
//   ξ, z   roll angle, rad, and height from the middle of the face, mm      n   unit normal, outward
//   φ      polar angle of the base tangent point, rad                       c   material removed, mm
//                                              theory: docs/theory/10-inspection.md
//
// Points lie in the gear frame: z along the axis, tooth 0 on the x axis in the middle of the face. A
// modified flank has moved by c along −n, and its normal has turned with c's slopes.
#pragma once

#include <array>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"

namespace gearwright {

/// Seen from +z with the tooth pointing up.
enum class FlankSide { right, left };

struct NominalPoint {
  Vec3 point;       ///< mm
  Vec3 normal;      ///< unit, out of the material
  double diameter;  ///< d_y  mm, of the unmodified point
  double height;    ///< z    mm
};

struct PointGrid {
  int profile = 9;  ///< from root to tip, equal steps of roll
  int helix = 5;    ///< along the face, equal steps
};

/// The point of the flank of tooth 0 at a roll angle and a height.
///
/// Formula   φ = ±(ψ_b − σ ξ) + z 2π/p_z, point r_b (u ± σ ξ e), n = ±(cos β_b e − sin β_b k);
///           [T10.26], modified [T10.27]
/// Units     rad, mm
NominalPoint nominal_point(const Gear& gear, const RemovalField& removal, FlankSide side,
                           double roll, double height);

/// The grid over the evaluation ranges, tooth by rows of growing height.
///
/// Domain    both numbers of the grid ≥ 2 (contract)
std::vector<NominalPoint> nominal_points(const Gear& gear, const RemovalField& removal,
                                         FlankSide side, const EvaluationRanges& ranges,
                                         const PointGrid& grid);

/// The root fillet next to a flank of tooth 0, as cut (modifications apply to the flank only), from
/// the root land to d_Ff, in rows of growing height over the same part of the face.
///
/// Formula   P = R(2π z/p_z) p + z k with p on the outline's fillet and e its normal there,
///           n ∝ e − (2π/p_z)(e · k × p) k; [T10.29]
/// Accuracy  points lie on the outline of the tooth as generated, equally spaced along the fillet to
///           1e-3 of their distance
/// None      the outline has no fillet, or the gear no outline
/// Domain    both numbers of the grid ≥ 2 (contract)
std::vector<NominalPoint> fillet_points(const Gear& gear, FlankSide side,
                                        const EvaluationRanges& ranges, const PointGrid& grid);

}  // namespace gearwright
