// Closed triangle meshes of toothed bodies, for printing, viewing and interference checks.
//
//   S(u, ζ)   screw surface: the section point P(u) turned by τζ about z at the height ζ, mm
//   Δ = τh    turn of one step h along the face, rad      a   chord of a section segment, mm
//   d         largest distance of the section from its chord, mm
//
// The walls are grids of vertices that lie on S. A triangle of such a grid deviates from S by at
// most
//
//     d + (2 a |Δ| + ρ Δ²) / 8                                                               (M1)
//
// because P deviates from its chord C by d at most, and linear interpolation of the map R(τζ) C(u)
// over a triangle with legs a and h errs by at most (a²|C_uu| + 2ah|C_uζ| + h²|C_ζζ|)/8 (Filip,
// Magedson and Markot, 1986), where C_uu = 0, |C_uζ| = |τ|, |C_ζζ| ≤ ρτ². Both diagonals obey (M1).
//
// Flanks with modifications are grids on the modified surface (cad/modified_mesh.hpp).
//
// Only one half tooth is meshed. The others are its mirror images, turned by sincos_turn, so tooth k
// is the turned tooth 0 bit for bit. Time and size are proportional to |z|.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

struct MeshOptions {
  double chord_tolerance_mm = 0.005;  ///< largest distance of the triangles from the exact surface
  Angle facet_turn_max =
      Angle::radians(0.26);  ///< largest turn of the surface over one facet (15°)
};

using Triangle = std::array<std::uint32_t, 3>;

/// Laws  (1) every edge belongs to two triangles, once in each direction
///       (2) triangles[i] and shaded_triangles[i] are the same triangle
struct TriangleMesh {
  std::vector<Vec3> vertices;       ///< mm, each corner of the body once
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside

  // The same surface for shading. A vertex on a crease appears once per smooth face.
  std::vector<std::uint32_t> shaded_vertices;  ///< index into `vertices`
  std::vector<Vec3> normals;                   ///< unit, outward, of the exact surface there
  std::vector<Triangle> shaded_triangles;      ///< index into `shaded_vertices`
};

/// A mesh with its name and its place, the input of the writers.
struct MeshPart {
  std::string name;                                        ///< UTF-8
  TriangleMesh mesh;                                       ///< in the gear frame
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< gear frame to the file's frame
  std::optional<std::size_t> colour{};                     ///< for part_colour(); or its index
  std::optional<std::size_t>
      same_as{};  ///< an earlier part that has the mesh; then `mesh` is empty
};

/// The body as a closed oriented mesh in the gear frame; `body.pose` is not applied.
///
/// Accuracy  no point of a wall triangle is farther than chord_tolerance_mm from the exact wall;
///           the caps are plane. If bore (or rim) and root are closer than four tolerances, a
///           quarter of their distance replaces the tolerance
/// Errors    bore.diameter_mm (with the largest that fits), bore.keyway_*, teeth if the outline
///           bounds no body (severed tooth, root beyond the axis), chord_tolerance_mm if the mesh
///           would have more than 2·10⁶ vertices or 20 000 points on half a tooth
/// Domain    face width and tolerances > 0, teeth ≠ 0, an outline that obeys its laws (contract)
Result<TriangleMesh> tessellate(const ToothedBody& body, const MeshOptions& options = {});

/// Volume enclosed, mm³.   Accuracy  rounding: about 1e-15 times the volume times √triangles
double mesh_volume(const TriangleMesh& mesh);

}  // namespace gearwright
