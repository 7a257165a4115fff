// Computes a whole drive: speeds, torques and losses, the places of the planets and the sequence of
// their meshes, teeth and backlash.
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
  std::optional<Neighbours> neighbours;           ///< none for one planet or without geometry
  std::optional<int> sun_teeth, ring_teeth;       ///< of the first sun and the first ring
  std::vector<Rational> sun_phases, ring_phases;  ///< γ_i; empty if there is no such gear
  std::optional<double>
      sun_ring_phase;  ///< γ_rs; none if no planet gear meshes with both, or without geometry
  Phasing phasing;     ///< phasing of the sun's mesh, or of the ring's if there is no sun
};

/// Transmission error at the output while the input turns uniformly.
struct DriveError {
  struct Line {
    double frequency_ratio;  ///< waves per turn of the input
    double amplitude;        ///< rad; of the travel of a rack, 2π per pitch
  };
  /// Peak to peak, rad. For meshes of several frequencies it is the sum over the frequencies, which
  /// is reached when their peaks coincide.
  double peak_to_peak = 0.0;
  std::vector<Line> lines;  ///< by frequency
  /// p_t/2π, if the output is a rack  mm; the product with an error in rad is the error of its travel
  std::optional<double> lever{};
};

/// The shares of the planets of a set under load over one period of its meshes, in the frame of the
/// carrier.
struct PlanetShares {
  std::size_t set = 0;                     ///< index in Drive::sets
  std::vector<std::vector<double>> share;  ///< of the load of all planets, [planet][position]
  double mesh_load_factor = 1.0;        ///< K_γ = N max share, of all meshes of the set [T13.26]
  std::optional<std::size_t> floating;  ///< body that is free to move radially
  std::vector<Vec2> displacement;       ///< of that body, mm, at each position

  double mean(std::size_t planet) const;
  double greatest(std::size_t planet) const;
  double least(std::size_t planet) const;
  /// mm; none if no body floats.
  std::optional<double> greatest_displacement() const;
};

/// The drive under load, drive/loaded_drive.hpp.
struct LoadedDrive {
  /// Rotation of the output over one period of a mesh frequency, from its mean, rad.
  struct Curve {
    double frequency_ratio = 0.0;       ///< teeth per turn of the input
    std::vector<double> loaded, rigid;  ///< at each position
  };
  double torque = 0.0;  ///< N m, on the input
  DriveError error;     ///< under load
  std::vector<Curve> curves;
  std::vector<PlanetShares> sets;
};

/// The rotation of the input or output while the other one is held, rad.
struct DriveBacklash {
  double input, output;
};

/// A mesh rated as a pair, drive/drive_rating.hpp.
struct MeshRating {
  RatedPair pair;
  RatingInput input;  ///< with the life for one engagement per turn and bending in one direction
  Rating rating;      ///< with the actual engagements and bending of each gear
  std::array<int, 2> engagements{1, 1};  ///< engagements of a flank per turn
};

struct Drive {
  DriveGraph graph;
  DriveMotion motion;
  DriveGeometry geometry;
  std::vector<std::optional<MeshEfficiency>> efficiencies;  ///< of each mesh
  std::optional<PowerFlow> flow;  ///< none if an efficiency is unknown, or if meshes are redundant
  std::optional<PowerFlow> backward;  ///< with the output driving; also none with several inputs
  std::vector<PlanetSet> sets;
  std::optional<DriveBacklash> backlash;  ///< none with several inputs, redundant meshes, or
                                          ///< without geometry
  std::optional<DriveError> error;        ///< none as above, or if contact is lost in a mesh
  std::vector<std::optional<MeshRating>> ratings;  ///< of each mesh; empty if they are not rated
  std::optional<LoadedDrive> loaded;               ///< none if no load was requested
  std::vector<Warning> findings;
  std::vector<Drive> stages;  ///< of a train, each as a separate drive

  /// Speed of a body, 1/min; for the body of a rack, pitches per minute. None if the speeds of the
  /// inputs are not given.
  std::optional<double> speed_rpm(std::size_t body) const;
  /// ω of a body divided by ω of the first input. None if there are several inputs and their speeds are
  /// not given.
  std::optional<double> speed_ratio(std::size_t body) const;
  /// p_t of the rack on a body, mm, which its pinion determines. None if there is no rack on the body or
  /// no module.
  std::optional<double> rack_pitch(std::size_t body) const;
  /// Speed v = n p_t of the body of a rack, m/s. None without a speed or without a pitch.
  std::optional<double> linear_speed(std::size_t body) const;
  /// External force on the body of a rack, F = 2π T/p_t, N. None without a torque, a flow or a pitch.
  std::optional<double> force(std::size_t body) const;
  /// ω of a body relative to the frame of its first mesh, divided by ω of the first input. None if
  /// speed_ratio() is none.
  std::optional<double> relative_speed_ratio(std::size_t body) const;
  /// Mesh frequency |z_a (ω_a − ω_c)| per turn of the first input. [T13.4]
  std::optional<double> frequency_ratio(std::size_t mesh) const;
  std::optional<std::size_t> frame_of_body(std::size_t body) const;
};

/// A drive and, for a train, its stages, each of which is a separate graph.
struct DriveInput {
  DriveGraph graph;
  std::vector<DriveGraph> stages{};
  int harmonics = 3;  ///< of phasing and of the transmission error
};

/// Errors    as check_graph, drive_motion, power_flow and assemble
Result<Drive> make_drive(const DriveInput& input);

}  // namespace gearwright
