// Rates the strength of the meshes of a drive according to ISO 6336. Each mesh is rated as a pair
// in the frame of its carrier.
//
//   T_1    z_1 λ T_in/N, the torque on gear 1 in one copy of a mesh with N copies; λ is the tooth
//          load of drive/power_flow.hpp
//   n_1    speed of gear 1 minus speed of the carrier
//                                              theory: docs/theory/11-rating.md, 13-drives.md
//
// Per turn, a tooth of a central gear engages with N planets. A planet between a sun and a ring is
// driven in one mesh and drives in the other, so its teeth are bent in both directions.
#pragma once

#include <functional>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// The load of a drive, and the inputs common to its meshes.
struct DriveLoad {
  double torque = 0.0;          ///< T  N m, on the first input, > 0
  std::optional<double> speed;  ///< n  1/min, of the first input; if absent, meshes are rated
                                ///<    without speed
  RatingInput common;           ///< all other inputs; K_γ applies only to meshes with N > 1
  std::vector<double> mesh_load_factors{};  ///< K_γ of each mesh; if empty, K_γ of `common` is used
  const char* factor_origin = nullptr;      ///< source of `mesh_load_factors`; null if the user
                                            ///< gives the factors
};

/// A function that returns the material of a gear, by its index in the graph.
using GearMaterials = std::function<Result<Material>(std::size_t gear)>;

/// Returns the inputs of a mesh for its rating as a pair, without the materials.
///
/// Domain    a drive that is not self-locking and has a power flow (contract)
RatingInput mesh_load(const Drive& drive, std::size_t mesh, const DriveLoad& load);

/// The number of engagements of one flank of a gear per turn. `both` is true if the other flank
/// also carries load.
struct FlankUse {
  int engagements = 0;
  bool both = false;
};

/// Returns the use of the flanks of gear a (side 0) or gear b (side 1) of a mesh.
///
/// Domain    a drive that is not self-locking and has a power flow (contract)
FlankUse flank_use(const Drive& drive, std::size_t mesh, int side);

/// Returns the ratings of all meshes, with none for a mesh that carries no load or has no pair.
///
/// Errors    `drive.mesh` if teeth are circular arcs, if there is no power flow or if the drive is
///           self-locking; the errors of rated_pair() and rate(), with the name of the mesh; the
///           errors of `material`
Result<std::vector<std::optional<MeshRating>>> rate_meshes(const Drive& drive,
                                                           const DriveLoad& load,
                                                           const GearMaterials& material);

/// The sentence about a rating for which rates_equal_shares() is true.
inline constexpr const char* kEqualShares =
    "The rating uses K_γ = 1 (the default), as if the planets carried equal loads. To change it, "
    "give mesh_load_factor in [rating].";

/// True if all meshes of several planets are rated with K_γ = 1, without a computation of K_γ.
bool rates_equal_shares(const Drive& drive);

/// Returns the least S_H or S_F of all meshes, or none if no mesh is rated.
std::optional<double> least_safety(const Drive& drive, FactorPair Rating::*safety);

/// Returns the greatest specific sliding |ζ| at the ends of the paths of contact of all involute
/// meshes. It is infinite if a path ends at a base circle. Returns none without such meshes.
std::optional<double> greatest_sliding(const DriveGeometry& geometry);

}  // namespace gearwright
