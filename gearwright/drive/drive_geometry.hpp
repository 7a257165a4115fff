// The teeth of a drive: distances and shifts of all its meshes, and each mesh as a pair of gears.
//
//   a      centre distance; all meshes of a planet with central gears share one [T13.15]
//   c      least distance of the tips of neighbouring planets, mm [T13.15b]
//                                              theory: docs/theory/13-drives.md
//
// A drive may lack what teeth need: then it has speeds, torques and places, and no geometry. What
// cannot be built is a finding, not an error: the rest of the drive still has its numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/assembly.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Why a part of the teeth cannot be as the drive asks.
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
///           free of backlash with the shifts given, absent ones 0
/// Domain    a checked graph (contract)
DriveGeometry drive_geometry(const DriveGraph& graph);

/// Place of a rider in the frame of its carrier, of copy 0.
struct RiderPlace {
  double distance;      ///< of its axis from the carrier's  mm
  double angle;         ///< rad, counter-clockwise from the first rider of the group
  double tip_diameter;  ///< of its greatest gear  mm
};

/// As the riders of the group. None: a distance or a gear is missing, or an idler finds no place
/// (`fault` then has why).
std::optional<std::vector<RiderPlace>> place_riders(const DriveGraph& graph,
                                                    const PlanetGroup& group,
                                                    const DriveGeometry& geometry,
                                                    std::optional<GeometryFault>& fault);

struct Neighbours {
  double clearance;  ///< c  mm, < 0: planets cut each other
  int most;          ///< greatest number of planets at equal pitch with c ≥ 0
};

/// None: a distance or a gear is missing, or an idler finds no place (`fault` then has why).
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
