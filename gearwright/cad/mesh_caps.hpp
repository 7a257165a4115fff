// Triangulates the plane end faces of toothed meshes. Internal to cad/.
//
//   n    segments of the section of half a tooth      q    points on the circle per half pitch
//
// A circle divides each cap. The triangles between the teeth and the circle are computed for one
// half pitch and repeated for all others. For an internal gear, the circle is the rim or the
// groove. For an external gear, the cap also contains the inner part. This is the ring between the
// circle and the bore or the groove, or the full disc inside the circle.
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

/// Returns the circle halfway between the roots and the hole or the groove. Its angular step is
/// small enough for zip_ring (cad/flat_cap.hpp).
Circle hub_circle(double hole_reach, double root_reach, int copies);

/// Returns the outer circle of the material of an internal gear. As for the tip land of an external
/// gear, the angular step follows from (M1) in mesh.hpp with d = a²/(8ρ).
Circle rim_circle(double radius, int copies, const SectionTolerance& tolerance);

/// A plane in which walls end.
struct CapPlace {
  bool up;  ///< true if the material lies below
  double z;
  double angle;           ///< rad, rotation of the section in this plane
  std::uint32_t outline;  ///< first vertex of the ring of the teeth, as in WallEnds
};

class Cap {
 public:
  /// Makes a cap. Returns none if the outline crosses itself.
  ///
  /// Domain    lower, upper: corners of the two halves of a tooth from root to tip, both mirrored
  ///           to the upper half, in the section z = 0, mm
  static std::optional<Cap> divide(const std::vector<Vec2>& lower, const std::vector<Vec2>& upper,
                                   const Circle& circle, int teeth);

  /// Returns the circle as columns of one pitch, for a wall along the circle.
  std::vector<Column> circle_columns(bool inward) const;

  /// Adds the cap of an internal gear. The circle of the cap is a ring of a wall, and the argument
  /// `circle` is the first vertex of this ring.
  void add(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const;

  /// Adds the cap of an external gear. `columns` are the columns of the wall of the hole. They are
  /// empty if the cap has no hole. `hole` is the first vertex of the ring at the end of this wall.
  void add(MeshBuilder& builder, const CapPlace& place, const std::vector<Column>& columns,
           std::uint32_t hole) const;

 private:
  void add_teeth(MeshBuilder& builder, const CapPlace& place, std::uint32_t circle) const;

  int copies_ = 0;
  std::size_t n_ = 0;
  Circle circle_{};
  std::vector<Column> pitch_;  // columns on the circle with normals pointing away from the axis
  std::array<std::vector<Triangle>, 2> half_;  // triangles at the lower and the upper half tooth
};

}  // namespace gearwright
