// Computes the geometry of the teeth of a drive: centre distances, profile shifts, and each mesh as
// a pair of gears.
//
//   a      centre distance, the same for all meshes of a planet with central gears [T13.15]
//   c      least distance between the tips of neighbouring planets, mm [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// If the data of the teeth are missing, a drive has speeds, torques and places, but no geometry. If
// the geometry cannot be built, the drive gets a finding instead of an error, and the other results
// are still computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/assembly.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// The reason why a gear or a mesh is impossible.
struct GeometryFault {
  enum class Kind { not_coaxial, no_gear, no_pair } kind;
  std::string message;

  bool operator==(const GeometryFault&) const = default;
};

struct DriveGeometry {
  std::vector<std::optional<double>> distance;  ///< mm, a of each mesh
  std::vector<std::optional<double>> shift;     ///< x of each gear
  std::vector<std::optional<Gear>> gears;
  std::vector<std::optional<Pair>> pairs;      ///< a pair for each mesh of two gears
  std::vector<std::optional<RackPair>> racks;  ///< a pair for each mesh with a rack
  std::vector<GeometryFault> faults;

  /// Returns the pair of a mesh of two involute gears. Returns null for circular arcs, for a rack,
  /// and if the teeth cannot be mounted. All axes of a drive are parallel.
  const ParallelPair* involutes(std::size_t mesh) const {
    return pairs[mesh] ? pairs[mesh]->parallel() : nullptr;
  }
  std::optional<StatedBacklash> stated_backlash(std::size_t mesh) const;  ///< none without teeth
  bool touches(std::size_t mesh) const;  ///< true if the mesh is mounted and its flanks touch
};

/// Checks that the given centre distances of the meshes of a planet with central gears are equal,
/// because these gears are coaxial with the carrier.
///
/// Errors    `drive.mesh["sun_planet"].center_distance`, with the name of a mesh, if its distance
///           differs from that of an earlier mesh of the planet
/// Domain    a checked graph (contract)
std::optional<Error> check_distances(const DriveGraph& graph);

/// Computes absent shifts from distances, and absent distances from shifts, as complete_shifts()
/// does.
///
///   distances   A given distance applies to all meshes of a planet with central gears. If no
///               distance is given, absent shifts of the first of these meshes are 0, and the
///               backlash-free distance of this mesh applies to all of them. A rack without a given
///               distance is mounted without backlash.
///   shifts      The shift of the pinion of a rack, or of a circular-arc gear, is 0 if none is
///               given.
///   tips        If the tip diameter of a ring is not given, the tips stay 0.02 m_n above the root
///               ends of the flanks of the mating gears. Any other tip without a given diameter or
///               a tip fillet is lowered by the tip shortening k m_n if its clearance is less than
///               0.1 m_n.
///
/// Formula   [T13.15]
/// Domain    a checked graph (contract)
DriveGeometry drive_geometry(const DriveGraph& graph);

/// Returns the graph with new thickness allowances for the gears of all meshes with a
/// DriveMesh::backlash. With these allowances, every such mesh has its backlash. If a gear belongs
/// to several such meshes, the mesh with the least thinning comes first, and its thinning is
/// divided equally between its two gears. In each mesh after it, one gear already has a thinning.
/// The mating gear, which has no thinning yet, gets the remaining thinning of the mesh.
///
/// Formula   dt/dj_n = cos α_wn/cos α_n for t = −(E_sn,a + E_sn,b); [T9.13]
/// Domain    a checked graph (contract). In a closed loop of meshes, the backlash of the last
///           mesh follows from the backlash of the other meshes
/// Accuracy  |j_n − backlash| < 1e-9 mm, if all teeth can be made thin enough
DriveGraph with_backlash(DriveGraph graph);

struct RiderPlace {
  double distance;  ///< mm, distance of the planet from the axis of the carrier
  double angle;     ///< rad, direction to copy 0, counter-clockwise from copy 0 of the first rider
};

/// Computes the positions of the planets of a group from the centre distances of their meshes, in
/// the order of PlanetGroup::riders. Returns none if a distance is missing, or if an idler has no
/// possible position. In the second case, `fault` gives the reason.
std::optional<std::vector<RiderPlace>> rider_places(
    const DriveGraph& graph, const PlanetGroup& group,
    const std::vector<std::optional<double>>& distances, std::optional<GeometryFault>& fault);

struct Neighbours {
  double clearance;  ///< c  mm, < 0 if planets overlap
  int most;          ///< greatest number of planets at equal pitch with c ≥ 0
};

/// Returns Neighbours::most, or none if a distance or a gear is missing.
std::optional<int> most_copies(const DriveGraph& graph, const PlanetGroup& group,
                               const DriveGeometry& geometry);

/// Computes the clearance between planets, and the greatest number of planets. Returns none if a
/// distance or a gear is missing, or if an idler has no possible position. In the last case,
/// `fault` gives the reason.
///
/// Formula   c = min (2 a sin(Δ/2) − d_a) over neighbours at the distance a from the axis of the
///           carrier, at an angle Δ between them. If the distances of the riders differ, the gap
///           between their tips is computed in polar coordinates. N_max = floor(π/asin(d_a/2a));
///           [T13.15b]
std::optional<Neighbours> neighbours(const DriveGraph& graph, const PlanetGroup& group,
                                     const DriveGeometry& geometry, const Assembly& assembly,
                                     std::optional<GeometryFault>& fault);

/// Returns j_bt, the backlash of a mesh along the transverse line of action, mm, or none without
/// involute teeth.
///
/// Formula   [T2.24], [T2.37]; j_bt = j_n cos α_wn/cos β_b
std::optional<double> transverse_base_backlash(const DriveGeometry& geometry, std::size_t mesh);

/// Returns the ratio of thickness to pitch on the working pitch circle of gear 1 or 2 of a pair.
///
/// Formula   s/p = 1/2 + 2 x_E tan α_n/π + z (inv α_t − inv α_wt)/π, where x_E is the generating
///           profile shift
double thickness_share(const InvolutePair& pair, int which);
/// Returns the ratio of tooth thickness to pitch on the reference circle of the pinion of a rack.
double thickness_share(const RackPair& pair);

}  // namespace gearwright
