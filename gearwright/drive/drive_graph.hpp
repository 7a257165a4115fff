// A drive as a graph: bodies that turn or move, the gears on them, bodies that ride on other bodies, and
// meshes.
//
//   body     turns about an axis, or moves if it has a rack; a planet rides on a carrier, in N copies
//   gear     z > 0 external, z < 0 ring, or a rack; sits on one body
//   mesh     two gears; its frame c is the carrier of one of its bodies, otherwise the housing
//                                              theory: docs/theory/13-drives.md
//
// A planetary set and a train of stages are short forms of such a graph (drive/short_forms.hpp).
// Everything is computed from the graph.
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
  nearest,        ///< at equal pitch if this can be assembled, otherwise at the nearest places
  equal,          ///< at equal pitch; an error if this cannot be assembled
  equal_clocked,  ///< at equal pitch, with each stepped planet clocked for its place
  opposite,       ///< every planet has another one opposite
};

struct DriveBody {
  std::string name;
  std::optional<std::size_t> carrier;  ///< the body on which it rides
  int count = 1;                       ///< N, copies of a body that rides
  std::vector<double> positions_deg;   ///< of the copies, from copy 0; if empty, `spacing` is used
  std::optional<Spacing> spacing{};    ///< by default that of the graph
};

/// The known data of the teeth of a gear; without a module there is no geometry.
struct DriveGear {
  std::string name;
  std::size_t body = 0;
  int teeth = 0;                        ///< z, < 0 for a ring
  std::optional<RackBar> rack{};        ///< of a rack, whose body moves: v/p_t replaces its speed
  std::optional<CylindricalSpec> spec;  ///< all other data, except the shift
  std::optional<double> shift;          ///< x; computed if absent
  std::array<FlankModifications, 2> modifications{};  ///< right flank, left flank
  std::optional<Bore> bore{};                         ///< of the body (internal: rim)
  std::optional<DoubleHelical> double_helical{};      ///< `spec` then has the width of both halves

  /// The factor in [T13.1]: z, or −1 for a rack.
  int factor() const { return rack ? -1 : teeth; }
};

struct DriveMesh {
  std::string name;
  std::array<std::size_t, 2> gears{};
  std::optional<double> efficiency;  ///< η with the frame at rest; by default that of the pair
  std::optional<double> center_distance;  ///< a  mm
  /// Direction from the axis of the first gear to that of the second, counter-clockwise, for meshes
  /// in the housing; planets are placed by their spacing. If absent, the shafts are in one line.
  std::optional<Angle> direction{};
  std::optional<double> friction{};  ///< μ; by default that of the graph
};

/// Gap between the faces of gears beside each other, in m_n.
inline constexpr double kBetweenFaces = 2.0;

struct DriveGraph {
  std::vector<DriveBody> bodies;
  std::vector<DriveGear> gears;
  std::vector<DriveMesh> meshes;
  std::vector<std::size_t> fixed, inputs;  ///< bodies
  std::size_t output = 0;
  std::vector<double> speeds_rpm;   ///< of the inputs; empty if not given
  std::optional<double> torque_Nm;  ///< on the first input
  double friction = 0.05;           ///< μ of meshes without an efficiency
  Spacing spacing = Spacing::nearest;
  bool idler_left = true;  ///< true if an idler is counter-clockwise from its planet

  const DriveGear& gear(const DriveMesh& mesh, int which) const {
    return gears[mesh.gears[static_cast<std::size_t>(which)]];
  }
  const DriveBody& body(const DriveGear& gear) const { return bodies[gear.body]; }
  /// The carrier of a mesh; none for the housing.   Domain  a checked graph
  std::optional<std::size_t> frame(const DriveMesh& mesh) const;
  bool is_fixed(std::size_t body) const;
  bool is_input(std::size_t body) const;
  /// True if a rack is on the body, which then moves instead of turning.
  bool moves(std::size_t body) const;
};

/// Checks that the graph describes a possible drive.
///
/// Errors    `drive.mesh` between riders of two carriers, or of a rack that does not mesh with an
///           external gear in the housing; `drive.gear` without teeth; `drive.body` that rides on
///           itself
std::optional<Error> check_graph(const DriveGraph& graph);

/// A planet, or several planets of one carrier that mesh with each other, with all their meshes. All
/// bodies of a group have the same number of copies.
struct PlanetGroup {
  std::size_t carrier;
  std::vector<std::size_t> riders;  ///< bodies
  std::vector<std::size_t> meshes;
  int count;  ///< N

  /// Number of pins, N for each rider.
  std::size_t pins() const { return riders.size() * static_cast<std::size_t>(count); }
};

/// The groups in the order of their first riders.   Domain  a checked graph
std::vector<PlanetGroup> planet_groups(const DriveGraph& graph);

}  // namespace gearwright
