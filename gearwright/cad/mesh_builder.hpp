// Builds a triangle mesh from walls and caps, together with a copy for shading.
//
//   τ        twist, rad/mm                              ζ      height, mm
//   column   the vertices of a section point, one per level   ring   the vertices of a level
//
// A wall is one part of a section, repeated around the axis and moved along the axis by a screw
// motion. A cap is plane and uses the end rings of walls. If the normal jumps at a vertex, the
// shaded copy has this vertex once per side.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/screw.hpp"

namespace gearwright {

struct Column {
  Vec2 point;   ///< mm, in the section ζ = 0 of the first copy
  Vec2 before;  ///< outward unit normal on the side of the previous column (clockwise)
  Vec2 after;   ///< outward unit normal on the side of the next column (counter-clockwise)
};

struct Levels {
  int steps;  ///< number of steps of equal height, ≥ 1
  Band band;

  double z(int level) const {
    return band.middle + band.width * (2 * level - steps) / (2.0 * steps);
  }
};

struct RingPoint {
  Vec2 point;          ///< mm
  Vec3 before, after;  ///< unit normals, pointing out of the material
};

/// One level of a wall that is not a screw surface. It has a point for each column of the first
/// copy of the wall.
struct Ring {
  double z;  ///< mm
  std::vector<RingPoint> points;
};

struct WallEdges {
  std::vector<char> crease;  ///< per column: true if the normal jumps there
  std::vector<char> rising;  ///< per column: true if the diagonal of the next quad rises
};

/// Returns the edges of a wall that is a screw surface.
WallEdges edges_of(const std::vector<Column>& part, int copies, const Levels& levels);

/// The end rings of a wall with n columns in each copy. Column i of copy k is the vertex `bottom` +
/// k n + i of the lower ring, and the vertex `top` + k n + i of the upper ring.
struct WallEnds {
  std::uint32_t bottom;
  std::uint32_t top;
};

class MeshBuilder {
 public:
  /// Adds a closed wall of `copies` equal parts. If `inward` is true, the material lies outside the
  /// wall. Copy k is exactly copy 0 turned by sincos_turn(k, copies). If `below` is given, the wall
  /// begins at the top ring of the wall `below`, which must have the same columns. If `below` is
  /// null, the wall begins with a new ring.
  WallEnds add_wall(const std::vector<Column>& part, int copies, const Levels& levels, bool inward,
                    const WallEnds* below = nullptr);

  /// Adds a wall whose levels are given one by one, from bottom to top. `below` is the same as in
  /// the other add_wall().
  ///
  /// Domain    two rings or more, each with a point for every column (contract)
  WallEnds add_wall(const std::vector<Ring>& rings, const WallEdges& edges, int copies, bool inward,
                    const WallEnds* below = nullptr);

  /// Adds `copies` turned copies of the vertices `part` inside a cap, and returns the index of the
  /// first vertex.
  std::uint32_t add_points(const std::vector<Vec2>& part, int copies, double z);

  /// Begins a cap that faces up (+z) or down.
  void begin_cap(bool up);
  /// Permits the vertices first … first + count − 1 as corners of the current cap.
  void use_in_cap(std::uint32_t first, std::size_t count);
  /// Adds a triangle of the cap, counter-clockwise seen from +z, even if the cap faces down.
  void add_cap_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  TriangleMesh take() && { return std::move(mesh_); }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  struct Range {
    std::uint32_t first;
    std::size_t count;
    std::uint32_t shaded;
  };
  // Indices of the shaded columns of one part. before[i] belongs to the quad that ends at column i,
  // and after[i] belongs to the quad that begins at column i.
  struct Shades {
    std::vector<std::uint32_t> before;
    std::vector<std::uint32_t> after;
    std::uint32_t count = 0;
  };

  static Shades shades(const std::vector<char>& crease);
  void add_ring(const Ring& ring, const std::vector<char>& crease, int copies,
                const WallEnds* below);
  WallEnds add_quads(std::size_t bottom, std::size_t second, std::size_t first_shaded, int steps,
                     const WallEdges& edges, int copies, bool inward);
  void add_shaded(std::uint32_t vertex, const Vec3& normal);
  void add_quad(const std::array<std::uint32_t, 4>& corners,
                const std::array<std::uint32_t, 4>& shaded, bool rising, bool inward);
  std::uint32_t next_vertex() const { return static_cast<std::uint32_t>(mesh_.vertices.size()); }
  std::uint32_t cap_shade(std::uint32_t vertex) const;

  TriangleMesh mesh_;
  std::vector<Range> ranges_;
  bool up_ = false;
};

}  // namespace gearwright
