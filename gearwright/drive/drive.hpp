// Computes speeds, torques, losses, teeth and backlash of a whole drive, and the places and phases
// of its planets.
//
//   const auto graph = graph_of(set);  // a PlanetarySpec
//   const auto drive = make_drive({*graph});
//   if (drive) use(*drive->motion.ratio, drive->flow->efficiency);
//                                              theory: docs/theory/13-drives.md
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact_view.hpp"
#include "gearwright/drive/assembly.hpp"
#include "gearwright/drive/drive_geometry.hpp"
#include "gearwright/drive/drive_motion.hpp"
#include "gearwright/drive/phasing.hpp"
#include "gearwright/drive/power_flow.hpp"
#include "gearwright/rating/sizing.hpp"

namespace gearwright {

struct PlanetSet {
  PlanetGroup group;
  Assembly assembly;
  std::optional<Neighbours> neighbours;           ///< none for a single planet or without geometry
  std::vector<Rational> sun_phases, ring_phases;  ///< γ_i of the meshes with the sun and with the
                                                  ///< ring
  std::optional<double>
      sun_ring_phase;  ///< γ_rs; none without geometry, or if no planet gear meshes with a sun and
                       ///< also with a ring
  Phasing phasing;     ///< phasing of the meshes with the sun or, without a sun, with the ring
};

/// The transmission error at the output, if the input turns uniformly.
struct DriveError {
  struct Line {
    double frequency_ratio;  ///< cycles per turn of the input
    double amplitude;        ///< amplitude, rad; for a rack, 2π is a travel of one pitch
  };
  /// Peak-to-peak value, rad. If the meshes have several frequencies, the values of all frequencies
  /// are added. The error reaches this sum at times at which all peaks coincide. The loaded meshes
  /// of one set have a common value, the range over all combinations of their positions [T13.26b].
  double peak_to_peak = 0.0;
  std::vector<Line> lines;  ///< lines in the order of frequency
  /// p_t/2π mm, set if the output is a rack. The error of the rack's travel in mm is `lever` times
  /// the error in rad.
  std::optional<double> lever{};
};

/// The shares of the planets of a set under load, over one period of the meshes, in the frame of
/// the carrier. If the meshes have several frequencies, the period is that of the first frequency.
/// Each value is then a mean over all positions of the other meshes.
struct PlanetShares {
  std::size_t set = 0;  ///< index in Drive::sets
  /// The share of each planet in the mesh with the greatest force, [planet][position].
  std::vector<std::vector<double>> share;
  std::vector<double> least, greatest;  ///< least and greatest share of each planet in this mesh
  /// The index and the mesh load factor K_γ = N max share of each loaded mesh [T13.26]. All meshes
  /// of a set have the same K_γ, except if a planet has more than two meshes.
  std::vector<std::pair<std::size_t, double>> mesh_load_factors;
  std::optional<std::size_t> floating;  ///< body that is free to move radially
  std::vector<Vec2> displacement;       ///< displacement of the floating body, mm, at each position
  std::optional<double> greatest_displacement;  ///< mm, over all positions; none if no body floats

  double mean(std::size_t planet) const;
  /// Returns the mesh with the greatest K_γ, and its K_γ.
  std::pair<std::size_t, double> mesh_load_factor() const;
};

/// Results for the drive under load, computed by drive/loaded_drive.hpp.
struct LoadedDrive {
  /// Deviation of the output rotation from its mean, rad, over one period of a mesh frequency. If
  /// planets have several frequencies, each value is a mean over the positions of the other meshes.
  struct Curve {
    double frequency_ratio = 0.0;       ///< teeth per turn of the input
    std::vector<double> loaded, rigid;  ///< with elastic and with rigid teeth, at each position
  };
  double torque = 0.0;  ///< N m, on the input
  DriveError error;     ///< under load
  std::vector<Curve> curves;
  std::vector<PlanetShares> sets;
};

/// Backlash, rad. `input` is the motion of the input while the output is held, and `output` is the
/// motion of the output while the input is held. The motion of a rack is its travel, where 2π is
/// one pitch.
struct DriveBacklash {
  double input, output;
  std::optional<double> input_lever{}, output_lever{};  ///< as DriveError::lever, for a rack
};

/// Rating of a mesh as a pair of gears, computed by drive/drive_rating.hpp.
/// `input` applies to one engagement per turn and to bending in one direction, and `rating` to the
/// actual engagements and directions of bending of each gear. The required safety factors are
/// arguments of the functions that judge a drive.
struct MeshRating : PairRating {
  std::array<int, 2> engagements{1, 1};  ///< engagements of a flank per turn
};

/// Contact of a mesh under errors of mounting. For a double-helical pair, the result is the contact
/// of the whole gears.
struct MeshContact {
  ContactResult driving, other;     ///< contact of the working flanks, and contact of the
                                    ///< non-working flanks
  std::optional<Angle> least_play;  ///< least play of gear 2 or of the rack; none if the working or
                                    ///< the non-working flanks never touch
  ContactResult on_halves;          ///< contact of the working flanks of a double-helical pair

  /// Returns the contact that the verdict judges. For a double-helical pair, this is the contact of
  /// its halves. For any other pair, it is the contact of the working flanks.
  const ContactResult& judged() const { return on_halves.positions.empty() ? driving : on_halves; }
};

struct Drive {
  DriveGraph graph;
  DriveMotion motion;
  DriveGeometry geometry;
  std::vector<std::optional<MeshEfficiency>> efficiencies;  ///< one efficiency for each mesh
  /// The power flow. None if an efficiency is unknown, if meshes are redundant, or if several
  /// inputs have no given speeds.
  std::optional<PowerFlow> flow;
  std::optional<PowerFlow> backward;  ///< power flow if the output drives; none without `flow` or
                                      ///< with several inputs
  std::vector<PlanetSet> sets;
  std::optional<DriveBacklash> backlash;  ///< none if there are several inputs, redundant meshes,
                                          ///< or a loaded mesh without geometry
  std::optional<DriveError> error;        ///< none under the conditions of transmission_error()
  std::vector<std::optional<MeshRating>> ratings;  ///< one rating for each mesh; empty if the drive
                                                   ///< is not rated
  std::optional<LoadedDrive> loaded;               ///< none if no load was requested
  /// Contact of each mesh under the errors of the spec. The list is empty if the spec has no
  /// errors. The contact is none for a mesh with unknown flanks or an unknown sense of rotation.
  std::vector<std::optional<MeshContact>> contacts;
  /// The contact analysis of each mesh as a separate pair, with the table [contact] of the spec. The
  /// list is empty if the analysis was not requested. The analysis is none if no teeth touch.
  std::vector<std::optional<ContactView>> analyses;
  std::vector<Warning> findings;
  std::vector<Drive> stages;  ///< stages of a train; each is a separate drive

  /// Returns the speed of a body, 1/min. For the body of a rack, returns pitches per minute.
  /// Returns none if the speeds of the inputs are not given.
  std::optional<double> speed_rpm(std::size_t body) const;
  /// Returns ω of a body divided by ω of the first input. Returns none if there are several inputs
  /// without given speeds, or if the first input is at rest.
  std::optional<double> speed_ratio(std::size_t body) const;
  /// Returns the transverse pitch p_t of the rack on a body, mm, computed from the module of the
  /// pinion. Returns none if the body has no rack or the module is unknown.
  std::optional<double> rack_pitch(std::size_t body) const;
  /// Returns p_t/2π, mm. A travel that is stored as an angle is multiplied by this factor to
  /// convert it to mm. Returns none if rack_pitch() is none.
  std::optional<double> lever(std::size_t body) const;
  /// Returns the speed v = n p_t of a rack, m/s, or none if the speed or the pitch is unknown.
  std::optional<double> linear_speed(std::size_t body) const;
  /// Returns the external force on the body of a rack, F = 2π T/p_t, N. Returns none if the torque,
  /// the power flow or the pitch is unknown, or if the drive is self-locking.
  std::optional<double> force(std::size_t body) const;
  /// Returns ω of a body relative to the frame of its first mesh, divided by ω of the first input.
  /// Returns none if speed_ratio() is none.
  std::optional<double> relative_speed_ratio(std::size_t body) const;
  /// Returns the mesh frequency |z_a (ω_a − ω_c)| per turn of the first input. [T13.4]
  std::optional<double> frequency_ratio(std::size_t mesh) const;
  /// Returns the play of a body, rad, if the body `held` does not move. `held` is the input or the
  /// output. The play of a rack is its travel, where 2π is one pitch. Returns none if there are
  /// several inputs or redundant meshes, or if a mesh between the two bodies has no involute teeth.
  /// [T13.20]
  std::optional<double> play(std::size_t body, std::size_t held) const;
  /// Returns γ_i of all copies if a planet meshes with a central gear, and an empty list for any
  /// other mesh. [T13.16]
  std::vector<Rational> phases(std::size_t mesh) const;
  std::optional<std::size_t> frame_of_body(std::size_t body) const;
};

/// The graph of a drive and, for a train, the separate graph of each stage.
struct DriveInput {
  DriveGraph graph;
  std::vector<DriveGraph> stages{};
  int harmonics = 3;  ///< number of harmonics of the phasing and the transmission error
  /// If true, and if the teeth are impossible, the fault lists changes that make the drive
  /// possible. The search for these changes takes as long as the computation of up to 80 drives.
  bool remedies = false;
};

/// Computes the drive of a graph. The load and the ratings are not included.
///
/// Errors    as check_graph, check_distances, drive_motion, power_flow and assemble
Result<Drive> make_drive(const DriveInput& input);

}  // namespace gearwright
