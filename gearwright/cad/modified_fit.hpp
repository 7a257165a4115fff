// The faces of teeth with flank modifications as B-splines. Internal to cad/.
//
//   X(u, v)   point of an arc (u from root to tip) in a layer of the body (v upwards), on the rows
//             of cad/modified_teeth.hpp
//   S(u, v)   tensor product of splines through X at the Greville points
//
// All arcs of a layer have one basis along v, and all layers of an arc one basis along u, so that
// neighbouring faces share the poles of their common edge. The bases are refined until splines along
// the edges and along lines between them meet the targets. Then S is compared with X at 8 × 8 places
// between neighbouring knots. The stated deviation is |S − X|, which is not less than the normal
// distance.
#pragma once

#include <array>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// The face of one arc of one side in one layer, in the frame of the side.
struct ModifiedFace {
  std::vector<std::vector<Vec3>> poles;  ///< [u][v]  mm; none for a land
  double deviation_mm = 0.0;
};

struct ModifiedFit {
  std::vector<ToothLevel> levels;  ///< those of tooth_levels()
  std::vector<WallKnots> along_v;  ///< of each layer, in mm
  /// Of the right and the left side, by arc.
  std::array<std::vector<WallKnots>, 2> along_u;
  /// Of the right and the left side, by layer and arc.
  std::array<std::vector<std::vector<ModifiedFace>>, 2> faces;
};

/// The planes that cut the teeth into slices, and the starts of end reliefs, from below. If one of the
/// planes of the teeth as cut would cross such a start, there are more slices.
std::vector<ToothLevel> tooth_levels(const ModifiedTeeth& teeth, int slices, double face_width);

/// Fits the teeth between these levels.
///
/// Errors    a face for which no spline is within kSectionMax_mm
Result<ModifiedFit> fit_modified(const ModifiedTeeth& teeth, std::vector<ToothLevel> levels);

}  // namespace gearwright
