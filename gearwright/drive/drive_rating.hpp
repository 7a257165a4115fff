// Rates the strength of the meshes of a drive by ISO 6336. Each mesh is a pair in the frame of its carrier.
//
//   T_1    z_1 λ T_in/N: the torque on gear 1 of one of N copies
//   n_1    speed of gear 1 minus that of the carrier
//                                              theory: docs/theory/11-rating.md, 13-drives.md
//
// A tooth of a central gear engages with N planets per turn. A gear that drives in one mesh and is
// driven in another is bent in both directions, like a planet between sun and ring.
#pragma once

#include <functional>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// The load of a drive, and the inputs common to its meshes.
struct DriveLoad {
  double torque = 0.0;          ///< T  N m, on the first input, > 0
  std::optional<double> speed;  ///< n  1/min, of the first input; if absent, ratings without speed
  RatingInput common;           ///< all but torque, speed, materials; K_γ is used if N > 1
};

/// Material of a gear of a mesh, by the number of the gear.
using GearMaterials = std::function<Result<Material>(std::size_t gear)>;

/// The load and speed of a mesh as those of a pair; materials are left out.
///
/// Domain    a drive with a flow that does not lock itself (contract)
RatingInput mesh_load(const Drive& drive, std::size_t mesh, const DriveLoad& load);

/// Engagements of one flank of a gear per turn, and whether the other flank carries load too.
struct FlankUse {
  int engagements = 0;
  bool both = false;
};

/// The use of the flanks of gear a (side 0) or b (side 1) of a mesh.
///
/// Domain    a drive with a flow that does not lock itself (contract)
FlankUse flank_use(const Drive& drive, std::size_t mesh, int side);

/// The ratings of all meshes; none for a mesh that carries no load or has no pair.
///
/// Errors    `drive.mesh` if there is no flow or if the drive locks itself; as rate(), with the name of
///           the mesh
Result<std::vector<std::optional<MeshRating>>> rate_meshes(const Drive& drive,
                                                           const DriveLoad& load,
                                                           const GearMaterials& material);

/// The least S_H or S_F of all meshes; none if no mesh is rated.
std::optional<double> least_safety(const Drive& drive, FactorPair Rating::*safety);

}  // namespace gearwright
