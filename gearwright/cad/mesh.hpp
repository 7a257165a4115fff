// Makes closed triangle meshes of toothed bodies, for printing, viewing and interference checks.
//
//   S(u, ζ)   screw surface: the section point P(u), turned by τζ about z, at the height ζ, mm
//   Δ = τh    turn of one step h along the face, rad      a   chord of a section segment, mm
//   d         largest distance of the section from its chord, mm     ρ   largest radius, mm
//
// The walls are grids of vertices that lie on S. A triangle of such a grid deviates from S by at
// most
//
//     d + (2 a |Δ| + ρ Δ²) / 8                                                               (M1)
//
// P deviates by at most d from its chord C. The screw surface T(u, ζ) of this chord is interpolated
// linearly over a triangle with legs a and h. The error of this interpolation is at most (a²|T_uu|
// + 2ah|T_uζ| + h²|T_ζζ|)/8 (Filip, Magedson and Markot, 1986), where T_uu = 0, |T_uζ| = |τ| and
// |T_ζζ| ≤ ρτ². (M1) is the sum of d and this error, and holds for both diagonals of a grid cell.
//
// Only one half tooth is meshed or, if the flanks are modified, both halves of one tooth. All other
// teeth are made by mirroring and by turning with sincos_turn, so every tooth is an exact copy of
// tooth 0. Time and size are proportional to |z|.
#pragma once

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
  Angle facet_turn_max = Angle::radians(0.26);  ///< largest turn of the normal over a facet
};

using Triangle = std::array<std::uint32_t, 3>;

/// Laws  (1) every edge belongs to two triangles, once in each direction
///       (2) triangles[i] and shaded_triangles[i] are the same triangle
struct TriangleMesh {
  std::vector<Vec3> vertices;       ///< mm, each vertex of the body occurs once
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside

  // The same surface for shading. A vertex on a crease occurs once for each adjacent smooth face.
  std::vector<std::uint32_t> shaded_vertices;  ///< index into `vertices`
  std::vector<Vec3> normals;                   ///< outward unit normals of the exact surface
  std::vector<Triangle> shaded_triangles;      ///< index into `shaded_vertices`
};

/// A mesh with its name and its pose, as input of the file writers.
struct MeshPart {
  std::string name;   ///< UTF-8
  TriangleMesh mesh;  ///< mesh in the frame of the solid
  SolidPose pose{};
  std::optional<std::size_t> colour{};   ///< for part_colour(); by default the index of the part
  std::optional<std::size_t> same_as{};  ///< earlier part with the same mesh; if set, `mesh` is
                                         ///< empty
};

/// Returns the body as a closed oriented mesh in the gear frame, without `body.pose`. The gears in
/// `body.above` belong to the same mesh.
///
/// Accuracy  no point of a wall triangle is farther than chord_tolerance_mm from the exact wall;
///           the caps are plane. If the distance from the bore (or rim) to the root is less than
///           four tolerances, a quarter of this distance replaces the tolerance
/// Errors    bore.diameter_mm (with the largest permissible value); bore.keyway_*; teeth if the
///           outline does not enclose a body (severed tooth, root beyond the axis);
///           chord_tolerance_mm if the mesh would have more than 2·10⁶ vertices or 20 000 points on
///           half a tooth
/// Domain    face width and tolerances > 0, teeth ≠ 0, the laws of the outline hold (contract)
Result<TriangleMesh> tessellate(const ToothedBody& body, const MeshOptions& options = {});

/// Returns the enclosed volume, mm³.   Accuracy  limited by rounding: about 1e-15 times the volume
/// times √(number of triangles)
double mesh_volume(const TriangleMesh& mesh);

}  // namespace gearwright
