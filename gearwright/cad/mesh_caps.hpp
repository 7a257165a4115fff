// The plane ends of toothed meshes. Internal to cad/.
//
//   n    segments of the section of half a tooth      q    points of the circle per half pitch
//
// A circle divides a cap. The triangles between the teeth and the circle are made for one half pitch and
// repeated for all others. The cap of an external gear also has a ring inside the circle down to the bore
// or the groove, or a full disc. The circle of an internal gear is its rim or its groove.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/section_points.hpp"

namespace gearwright {

struct Circle {
  double radius;  ///< mm
  int q;
};

/// The circle halfway between the hole, or the groove, and the roots. Its step δ satisfies R cos δ ≥ r,
/// which zip_ring requires.
Circle hub_circle(double hole_reach, double root_reach, int copies);

/// The outer circle of an internal gear's material. Its step follows from (M1) with d = a²/(8ρ), as for
/// the tip land of an external gear.
Circle rim_circle(double radius, int copies, const SectionTolerance& tolerance);

/// A plane in which walls end.
struct CapPlace {
  bool up;  ///< true if the material lies below
  double z;
  double angle;           ///< rad, by which the section is turned
  std::uint32_t outline;  ///< the teeth's ring, as in WallEnds
};

class Cap {
 public:
  /// Returns no cap if the outline crosses itself.
  ///
  /// Domain    lower, upper: corners of the two halves of a tooth from root to tip, both as the upper
  ///           half in the section z = 0, mm
  static std::optional<Cap> divide(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper,
                                   const Circle& circle, int teeth);

  /// The circle as columns of one pitch, for a wall along it.
  std::vector<Column> circle_columns(bool inward) const;

  /// Adds the cap of an internal gear, whose circle is a ring of a wall.
  void add(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const;

  /// Adds the cap of an external gear with a hole whose wall ends in the ring `hole`, or without one.
  void add(MeshBuilder& builder, const CapPlace& place, const std::vector<Column>& columns,
           std::uint32_t hole) const;

 private:
  void add_teeth(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const;

  int copies_ = 0;
  std::size_t n_ = 0;
  Circle circle_{};
  std::vector<Column> pitch_;  // columns of the circle, their normals away from the axis
  std::array<std::vector<Triangle>, 2>
      half_;  // of the lower halves of the teeth, of the upper ones
};

}  // namespace gearwright
