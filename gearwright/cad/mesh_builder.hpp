// Builds a triangle mesh from walls and caps, together with its shaded copy.
//
//   τ  twist, rad/mm     ζ  height, mm     column  a vertex per level     ring  a level's vertices
//
// A wall is one part of a section, repeated around the axis and screwed along it. A cap is plane
// and uses the end rings of walls. A vertex where the normal jumps is shaded once per side.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/screw.hpp"

namespace gearwright {

/// One column of a wall.
struct Column {
  Vec2 point;   ///< mm, in the section ζ = 0 of the first copy
  Vec2 before;  ///< unit section normal, out of the material, on the side of the previous column
                ///< (clockwise)
  Vec2 after;   ///< the same on the side of the next column (counter-clockwise)
};

struct Levels {
  int steps;  ///< of equal height, ≥ 1
  Band band;

  double z(int level) const {
    return band.middle + band.width * (2 * level - steps) / (2.0 * steps);
  }
};

/// A column at one level, in place.
struct RingPoint {
  Vec2 point;          ///< mm
  Vec3 before, after;  ///< unit normals out of the material
};

/// A level of a wall without a screw motion, with the columns of its first copy.
struct Ring {
  double z;  ///< mm
  std::vector<RingPoint> points;
};

/// The edges of the quads of a wall: creases between them, and their diagonals.
struct WallEdges {
  std::vector<char> crease;  ///< of each column
  std::vector<char> rising;  ///< of each column: true if the next quad's diagonal rises from it
};

/// The edges of a wall with a screw motion.
WallEdges edges_of(const std::vector<Column>& part, int copies, const Levels& levels);

/// The end rings of a wall: column i of copy k is vertex `bottom` (or `top`) + k·columns + i.
struct WallEnds {
  std::uint32_t bottom;
  std::uint32_t top;
};

class MeshBuilder {
 public:
  /// Adds a closed wall of `copies` equal parts. If `inward`, the material lies outside the wall.
  /// Copy k is copy 0 turned by sincos_turn(k, copies), bit for bit. The lowest ring is the top ring
  /// of the wall `below`, which has the same columns there, or a new ring if `below` is null.
  WallEnds add_wall(const std::vector<Column>& part, int copies, const Levels& levels, bool inward,
                    const WallEnds* below = nullptr);

  /// Adds a wall that is given level by level, from below.
  ///
  /// Domain    two rings or more, each with a point for every column (contract)
  WallEnds add_wall(const std::vector<Ring>& rings, const WallEdges& edges, int copies,
                    bool inward);

  /// Vertices inside a cap, `copies` turned copies of `part`; returns the first one's index.
  std::uint32_t add_points(const std::vector<Vec2>& part, int copies, double z);

  /// Begins a cap that faces up (+z) or down.
  void begin_cap(bool up);
  /// Permits the vertices first … first + count − 1 as corners of this cap.
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
  // Shaded columns of one part. `before` belongs to the quad that ends at the column.
  struct Shades {
    std::vector<std::uint32_t> before;
    std::vector<std::uint32_t> after;
    std::uint32_t count = 0;
  };

  static Shades shades(const std::vector<char>& crease);
  void add_ring(const Ring& ring, const std::vector<char>& crease, int copies,
                const WallEnds* below = nullptr);
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
