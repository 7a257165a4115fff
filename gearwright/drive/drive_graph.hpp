// Describes a drive as a graph of bodies, the gears on them, and the meshes of these gears.
//
//   body     turns about an axis, or moves in a line if it has a rack
//   rider    body that turns on a carrier: a planet or an idler; a set has N copies of it
//   gear     z > 0 external, z < 0 ring, or a rack; belongs to one body
//   mesh     two gears; its frame c is the carrier of one of its bodies, otherwise the housing
//                                              theory: docs/theory/13-drives.md
//
// A planetary set and a train of stages are short forms of such a graph (drive/short_forms.hpp).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/double_helical.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Arrangement of the copies of a planet around the carrier.
enum class Spacing {
  nearest,        ///< equal pitch if this is possible; otherwise the nearest places
  equal,          ///< equal pitch; an error if the planets cannot be assembled at equal pitch
  equal_clocked,  ///< equal pitch; the angle between the gears of each stepped planet suits the
                  ///< place of the planet
  opposite,       ///< pairs of opposite planets
};

/// Side of an idler on its carrier. Two triangles with the axes of the carrier, the planet and the
/// idler as corners are possible. They are mirror images, and one turns into the other if the sense
/// of rotation and all hands are reversed.
enum class IdlerSide {
  counter_clockwise,  ///< seen from +z, the idler is counter-clockwise from its planet
  clockwise,
};

struct DriveBody {
  std::string name;
  std::optional<std::size_t> carrier;  ///< the body on which this body turns
  int count = 1;                       ///< N, number of copies of a rider
  std::vector<double> positions_deg;   ///< angle of each copy; if empty, `spacing` is used
  std::optional<Spacing> spacing{};    ///< by default DriveGraph::spacing
  /// Side of this rider as seen from the earlier rider with which it meshes.
  IdlerSide side = IdlerSide::counter_clockwise;
};

/// A gear with the known data of its teeth. If the module is unknown, no geometry is computed.
struct DriveGear {
  std::string name;
  std::size_t body = 0;
  int teeth = 0;                        ///< z, < 0 for a ring
  std::optional<RackBar> rack{};        ///< the rack, if the gear is a rack; the speed of the body
                                        ///< is then v/p_t
  std::optional<CylindricalSpec> spec;  ///< data of the teeth, except z and x
  std::optional<double> shift;          ///< x; computed if absent
  BothFlanks modifications{};           ///< right flank, left flank
  std::optional<Bore> bore{};           ///< bore of the gear body, or rim of a ring
  std::optional<DoubleHelical> double_helical{};  ///< if set, b in `spec` includes the gap

  bool is_ring() const { return teeth < 0; }
  double side() const { return side_of(teeth); }  ///< σ  +1 external, −1 ring
  /// Returns the coefficient of the gear in [T13.1], which is z, or −1 for a rack.
  int factor() const { return rack ? -1 : teeth; }
  /// E_sn  mm.   Domain  a rack, or a gear with `spec`
  double thickness_allowance() const {
    return rack ? rack->thickness_allowance : spec->thickness_allowance;
  }
  double& thickness_allowance() {
    return rack ? rack->thickness_allowance : spec->thickness_allowance;
  }
};

struct DriveMesh {
  std::string name;
  std::array<std::size_t, 2> gears{};
  std::optional<double> efficiency;  ///< η with the frame at rest; by default computed from μ
  std::optional<double> center_distance;  ///< a  mm
  /// Direction from the axis of the first gear to the axis of the second gear, as an angle
  /// counter-clockwise. The direction applies only to meshes in the housing, because the spacing
  /// determines the positions of planets. Without a direction, the shafts are in one line.
  std::optional<Angle> direction{};
  std::optional<double> friction{};  ///< μ; by default DriveGraph::friction
  std::optional<double> backlash{};  ///< j_n  mm; the teeth of both gears are thinned to obtain it
  bool backlash_is_mean = false;     ///< true if `backlash` is the mean of a given band
};

/// Axial gap between the faces of adjacent gears, in m_n.
inline constexpr double kBetweenFaces = 2.0;

struct DriveGraph {
  std::vector<DriveBody> bodies;
  std::vector<DriveGear> gears;
  std::vector<DriveMesh> meshes;
  std::vector<std::size_t> fixed, inputs;  ///< indices of bodies
  std::size_t output = 0;
  std::vector<double> speeds_rpm;   ///< speed of each input; empty if not given
  std::optional<double> torque_Nm;  ///< on the first input
  double friction = 0.05;           ///< μ of meshes whose efficiency is not given
  Spacing spacing = Spacing::nearest;

  const DriveGear& gear(const DriveMesh& mesh, int which) const {
    return gears[mesh.gears[static_cast<std::size_t>(which)]];
  }
  const DriveBody& body(const DriveGear& gear) const { return bodies[gear.body]; }
  /// Returns the carrier that is the frame of a mesh, or none if the frame is the housing.
  ///
  /// Domain    a graph that passes check_graph()
  std::optional<std::size_t> frame(const DriveMesh& mesh) const;
  /// Returns the number of copies of a mesh. This is the number of copies of its planets, or 1
  /// without planets.
  int copies(const DriveMesh& mesh) const;
  bool is_fixed(std::size_t body) const;
  bool is_input(std::size_t body) const;
  /// True if the body carries a rack. Such a body moves instead of turning.
  bool moves(std::size_t body) const;
};

/// Returns the error of a member of a gear of the drive. Its field names the gear, for example
/// `drive.gear["s1_gear1"].double_helical.gap`.
Error of_drive_gear(const DriveGear& gear, Error error);

/// Returns an error if speeds are given, but not one speed for each input. Its field is
/// `drive.speed`.
std::optional<Error> check_speeds(const std::vector<double>& speeds_rpm, std::size_t inputs);

/// Checks that the graph describes a possible drive.
///
/// Errors    `drive.mesh`, for example if the planets of a mesh are on two carriers, or if a rack
///           does not mesh with an external gear in the housing; `drive.gear` if a gear has no
///           teeth or a planet has a rack; those of of_drive_gear() if the halves of a
///           double-helical gear are staggered or its gap is impossible; `drive.body`, for example
///           if a body is its own carrier; those of check_speeds(); `drive.torque` if the torque and
///           the speed of a single input have opposite signs
std::optional<Error> check_graph(const DriveGraph& graph);

/// A planet with all its meshes, or several planets of one carrier that mesh with each other, with
/// all their meshes. All bodies of a group have the same number of copies.
struct PlanetGroup {
  std::size_t carrier;
  std::vector<std::size_t> riders;  ///< indices of the bodies
  std::vector<std::size_t> meshes;
  int count;  ///< N

  /// Returns the number of pins. There are N pins for each rider.
  std::size_t pins() const { return riders.size() * static_cast<std::size_t>(count); }
};

/// Returns the groups in the order of the first body of each group.   Domain  a checked graph
std::vector<PlanetGroup> planet_groups(const DriveGraph& graph);

/// Returns the transverse pitch p_t of the rack on a body, mm, computed from the module of the
/// pinion. Returns none if the body has no rack or the module is unknown. In the graph, the unit of
/// the motion of a rack is one pitch, because the rack moves by one pitch for each tooth of the
/// pinion.
std::optional<double> rack_pitch(const DriveGraph& graph, std::size_t body);

}  // namespace gearwright
