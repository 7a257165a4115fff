// Computes which gear of each mesh drives, and the delays of the meshes and of the planets.
//
//   t      time in periods of the mesh, 0 when the loaded flanks of planet 0 touch at the pitch
//          point
//   γ_i    delay of the mesh of planet i, in periods [T13.16]
//                                              theory: docs/theory/13-drives.md, 13.4 and 13.6
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/rack_contact.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright::detail {

/// Which gear of a mesh drives, and from which face the contact analysis sees the gears.
struct MeshSense {
  bool first_drives = true;
  /// True if gear 1 turns counter-clockwise in the frame of the mesh. The contact analysis requires
  /// that gear 1 turns clockwise. If `turned` is true, the mesh is therefore analysed as seen from
  /// the other face.
  bool turned = false;
};

/// The phase of a mesh. The curve of a mesh is a function of x, the rotation of gear 1 in pitches
/// from the centre line. The mesh reaches x at the time x − event + time + γ_i.
struct MeshPhase : MeshSense {
  double weight = 0.0;           ///< rotation of the output per mm of the curve, rad
  double event = 0.0;            ///< position of the pitch point in the curve, in periods
  double time = 0.0;             ///< delay after the first mesh with this frequency, in periods
  std::size_t first = 0;         ///< index of the first mesh with this frequency; for an idle mesh,
                                 ///< the index of this mesh
  double sense = 1.0;            ///< −1 if the delays of the planets are −γ_i
  std::vector<Rational> phases;  ///< γ_i for sense 1; empty if the mesh is not in a planet set

  bool idle() const { return weight == 0.0; }  ///< true if the mesh does not move the output
};

/// Returns ω of a body relative to the frame of the mesh.   Domain  one input (contract)
double turning(const Drive& drive, std::size_t body, std::size_t mesh);

/// True if the first gear of the mesh drives. If the drive has no power flow, the function uses
/// `load`, the lossless load of the mesh per unit torque on the input.
///
/// Domain    one input (contract)
bool first_drives(const Drive& drive, std::size_t mesh, double load);

/// Returns the sense of a mesh. Returns none for a mesh without load, and if there are several
/// inputs, several degrees of freedom or redundant meshes.
std::optional<MeshSense> sense_of(const Drive& drive, std::size_t mesh);

/// Returns the time at which the loaded flank of a gear passes the pitch point, in periods
/// [T13.17]. The sign of `turning` is the sense of rotation of the gear in the frame of the mesh.
/// `theta` is the direction to the mesh in turns, and `half` is half of the tooth thickness in
/// pitches.
double passing_time(double turning, int teeth, double theta, bool drives, double half);

/// Sets the delays γ of the copies of a planet, and their sign. A mesh between two planets has the
/// delays of the mesh of the same frequency between a planet and a central gear.
void find_delays(const Drive& drive, std::size_t mesh, MeshPhase& phase);

/// Returns the planet set that contains the mesh, or null if there is none.
const PlanetSet* set_of(const Drive& drive, std::size_t mesh);

/// Returns the position of copy 0 of a body of the set in the frame of the carrier, mm. Returns
/// none if a centre distance is missing, or if an idler has no possible place.
std::optional<std::complex<double>> place_of(const Drive& drive, const PlanetSet& set,
                                             std::size_t body);

/// Returns the direction from the axis of a gear to one of its meshes, in turns. For planets, copy
/// 0 is used. Returns none if place_of() returns none.
std::optional<double> direction(const Drive& drive, std::size_t mesh, std::size_t gear);

/// Returns the phases of all meshes. Returns none if a load exceeds the range of exact fractions.
/// Also returns none if a mesh that moves the output has no involute teeth or has an idler without
/// a possible place, or if two meshes that move the output share a rack.
///
/// Formula   meshes that share a gear have one frequency, and their phase follows from the angle
///           between them on this gear [T13.17]
/// Domain    one degree of freedom, independent meshes (contract)
std::optional<std::vector<MeshPhase>> phases_of(const Drive& drive);

/// Returns the contact setup of a mesh with its modifications and errors of mounting. If `turned`
/// is true, the gears are seen from the other face, so that gear 1 turns clockwise. Returns none if
/// the flanks cannot be computed, or if a measured gear is loaded on a flank without readings.
std::optional<ContactSetup> mesh_contact(const Drive& drive, std::size_t mesh,
                                         const ContactErrors& errors, bool turned);
/// Returns the contact pair of a pinion and a rack, with its modifications and errors of mounting.
/// Returns null if the flanks cannot be computed.
std::shared_ptr<const ContactPair> rack_contact(const Drive& drive, std::size_t mesh,
                                                const ContactErrors& errors,
                                                const MeshPhase& phase);

}  // namespace gearwright::detail
