// A whole drive: its speeds, torques and losses, where its planets stand and how their meshes follow
// each other, its teeth and its play.
//
//   const auto drive = make_drive(graph_of(PlanetarySpec{…}));
//   if (drive) use(*drive->motion.ratio, drive->flow->efficiency);
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/assembly.hpp"
#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/drive/drive_motion.hpp"
#include "gearwright/drive/phasing.hpp"
#include "gearwright/drive/power_flow.hpp"
#include "gearwright/rating/rating.hpp"

namespace gearwright {

/// A group of planets with its places and phases.
struct PlanetSet {
  PlanetGroup group;
  Assembly assembly;
  std::optional<Neighbours> neighbours;           ///< none: one planet, or no geometry
  std::optional<int> sun_teeth, ring_teeth;       ///< of the first central gears of either kind
  std::vector<Rational> sun_phases, ring_phases;  ///< γ_i; empty: there is no such gear
  std::optional<double>
      sun_ring_phase;  ///< γ_rs; none: not both on one planet gear, or no geometry
  Phasing phasing;     ///< of the sun's mesh, without a sun of the ring's
};

/// Transmission error at the output, its input turning evenly.
struct DriveError {
  struct Line {
    double frequency_ratio;  ///< waves per turn of the input
    double amplitude;        ///< rad
  };
  /// Greatest less least, rad; of meshes of several frequencies the sum over the frequencies, which
  /// their waves reach where they meet.
  double peak_to_peak = 0.0;
  std::vector<Line> lines;  ///< by frequency
};

/// The angle that an end turns while all others are held, rad.
struct DriveBacklash {
  double input, output;
};

/// A mesh rated as a pair, drive/drive_rating.hpp.
struct MeshRating {
  RatedPair pair;
  RatingInput input;  ///< its life is that of one engagement per turn, bending one way
  Rating rating;      ///< each gear with its engagements and its bending
  std::array<int, 2> engagements{1, 1};  ///< of a flank per turn
};

struct Drive {
  DriveGraph graph;
  DriveMotion motion;
  DriveGeometry geometry;
  std::vector<std::optional<MeshEfficiency>> efficiencies;  ///< of each mesh
  std::optional<PowerFlow> flow;      ///< none: an efficiency is not known, or meshes are redundant
  std::optional<PowerFlow> backward;  ///< output drives; none: several inputs too
  std::vector<PlanetSet> sets;
  std::optional<DriveBacklash> backlash;  ///< none: several inputs, redundant, or no geometry
  std::optional<DriveError> error;        ///< none: the same, or contact is lost in a mesh
  std::vector<std::optional<MeshRating>> ratings;  ///< of each mesh; empty: they are not rated
  std::vector<Warning> findings;
  std::vector<Drive> stages;  ///< of a train, each by itself

  /// Speeds of all bodies in 1/min, else none: the inputs' are not given.
  std::optional<double> speed_rpm(std::size_t body) const;
  /// ω over that of the first input; none: it needs the speeds of all inputs, and they are not given.
  std::optional<double> speed_ratio(std::size_t body) const;
  /// ω of a body less that of the frame of its first mesh, the same way; none: no gear sits on it.
  std::optional<double> relative_speed_ratio(std::size_t body) const;
  /// |z_a (ω_a − ω_c)| per turn of the first input. [T13.4]
  std::optional<double> frequency_ratio(std::size_t mesh) const;
  std::optional<std::size_t> frame_of_body(std::size_t body) const;
};

/// A drive, and the stages that it consists of if it is a train: `stages` are graphs of their own.
struct DriveInput {
  DriveGraph graph;
  std::vector<DriveGraph> stages{};
  int harmonics = 3;  ///< of phasing and of the transmission error
};

/// Errors    as check_graph, drive_motion, power_flow and assemble
Result<Drive> make_drive(const DriveInput& input);

}  // namespace gearwright
