// Represents the faces of teeth with flank modifications as B-splines. Internal to cad/.
//
//   X(u, v)   point of an arc (u from root to tip) in a layer of the body (v upwards), on the rows
//             of cad/modified_teeth.hpp
//   S(u, v)   tensor product of splines through X at the Greville points
//
// All arcs of a layer share one basis along v, and all layers of an arc share one basis along u.
// Neighbouring faces therefore share the poles of their common edge. The bases are refined until
// the splines meet the targets along the edges, and along lines between the edges. Then S is
// compared with X at 8 × 8 points between neighbouring knots. The stated deviation is |S − X|,
// which is at least the normal distance.
#pragma once

#include <array>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// The face of one arc on one side in one layer, in the frame of the side.
struct ModifiedFace {
  std::vector<std::vector<Vec3>> poles;  ///< [u][v]  mm; none for a land
  double deviation_mm = 0.0;
};

struct ModifiedFit {
  std::vector<ToothLevel> levels;  ///< the levels from tooth_levels()
  std::vector<WallKnots> along_v;  ///< knots along v of each layer, mm
  /// Knots along u of each arc on both sides (right, left).
  std::array<std::vector<WallKnots>, 2> along_u;
  /// The faces of both sides (right, left), in the order side, layer, arc.
  std::array<std::vector<std::vector<ModifiedFace>>, 2> faces;
};

/// Returns the levels from bottom to top. These are the planes that cut the teeth into slices, and
/// the heights at which end reliefs begin. `slices` is the number of slices that the teeth as cut
/// need. If a plane between slices is too near to the start of a relief, up to four more slices are
/// tried. If this does not help, the number of slices remains `slices`.
std::vector<ToothLevel> tooth_levels(const ModifiedTeeth& teeth, int slices, double face_width);

/// Fits the teeth between these levels.
///
/// Errors    a face that no spline approximates within kSectionMax_mm
Result<ModifiedFit> fit_modified(const ModifiedTeeth& teeth, std::vector<ToothLevel> levels);

/// Returns the mirror image of a fit in the plane z = 0.
ModifiedFit in_mirror(ModifiedFit fit);

}  // namespace gearwright
