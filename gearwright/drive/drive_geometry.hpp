// The teeth of a drive: distances and shifts of all its meshes, and each mesh as a pair of gears.
//
//   a      centre distance; all meshes of a planet with central gears share one [T13.15]
//   c      least distance of the tips of neighbouring planets, mm [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// If a drive lacks the data of its teeth, it has speeds, torques and places, but no geometry.
// Geometry that cannot be built is a finding, not an error, and the other numbers are still
// computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/assembly.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The reason why a part of the teeth is impossible.
struct GeometryFault {
  enum class Kind { not_coaxial, no_gear, no_pair } kind;
  std::string message;
};

struct DriveGeometry {
  std::vector<std::optional<double>> distance;  ///< a of each mesh  mm
  std::vector<std::optional<double>> shift;     ///< x of each gear
  std::vector<std::optional<Gear>> gears;
  std::vector<std::optional<Pair>> pairs;  ///< of each mesh
  std::vector<GeometryFault> faults;
};

/// Formula   Sums of shifts from distances and the other way, as complete_shifts; [T13.15]: a given
///           distance holds for all central meshes of its planet; without one the first of them is
///           free of backlash with the shifts given, absent ones 0. A ring without a tip diameter
///           ends where contact is on the flanks of its mating gears, 0.02 m_n clear of their ends;
///           another tip with less than 0.1 m_n of clearance is lower by k m_n
/// Domain    a checked graph (contract)
DriveGeometry drive_geometry(const DriveGraph& graph);

/// Position of a planet in the frame of its carrier.
struct RiderPlace {
  double distance;  ///< from the carrier's axis to its own  mm
  double angle;     ///< of copy 0, counter-clockwise from copy 0 of the first rider  rad
};

/// The planets of a group in order, from the distances of their meshes. None if a distance is
/// missing, or if an idler has no possible position (`fault` gives the reason).
std::optional<std::vector<RiderPlace>> rider_places(
    const DriveGraph& graph, const PlanetGroup& group,
    const std::vector<std::optional<double>>& distances, std::optional<GeometryFault>& fault);

struct Neighbours {
  double clearance;  ///< c  mm, < 0 if planets overlap
  int most;          ///< greatest number of planets at equal pitch with c ≥ 0
};

/// None if a distance or a gear is missing, or if an idler has no place (`fault` then has the
/// reason).
///
/// Formula   c = min 2 a sin(Δ/2) − d_a over neighbours, of riders at several distances tip to tip
///           from their polar coordinates; N_max = floor(π/asin(d_a/2a)); [T13.15b]
std::optional<Neighbours> neighbours(const DriveGraph& graph, const PlanetGroup& group,
                                     const DriveGeometry& geometry, const Assembly& assembly,
                                     std::optional<GeometryFault>& fault);

/// Tooth thickness over pitch of gear 1 or 2 of a pair on its working circle.
///
/// Formula   s/p = 1/2 + 2 x tan α_n/π + z (inv α_t − inv α_wt)/π
double thickness_share(const InvolutePair& pair, int which);

}  // namespace gearwright
