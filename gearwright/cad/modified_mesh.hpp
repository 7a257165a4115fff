// Meshes the walls of teeth with flank modifications, level by level. Internal to cad/.
//
//   ε    chord tolerance of the mesh, mm        c   material removed from the flank, mm
//
// The first grid represents the teeth as cut and uses the fraction kCutShare of ε. A line of
// vertices is added at each start of a relief. Then segments and steps along the face are halved
// until the error of c in the middle of each facet is small enough. This error is the difference
// between c and the mean of c at the corners. It must be less than the rest of ε, and less than a
// tenth of the greatest c.
#pragma once

#include <vector>

#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/section_points.hpp"

namespace gearwright {

/// The fraction of the chord tolerance for the teeth as cut. The rest is available for c.
inline constexpr double kCutShare = 0.8;

struct ModifiedGrid {
  std::vector<SectionPoint> half;  ///< half section of the divided outline as cut
  std::vector<double> levels;      ///< mm, in ascending order
};

/// Makes the grid from the section as cut and the step along the face that the twist requires.
///
/// Units     mm
ModifiedGrid modified_grid(const ModifiedTeeth& teeth, std::vector<SectionPoint> half, double width,
                           double step, double tolerance);

/// Returns the rings of one pitch, counter-clockwise from the middle of a tooth space.
std::vector<Ring> modified_rings(const ModifiedTeeth& teeth, const ModifiedGrid& grid, int copies);

void crease_at_reliefs(const ModifiedTeeth& teeth, const ModifiedGrid& grid, WallEdges& edges);

/// Returns the half section of one side at the height z, from root to tip, turned back by the
/// twist.
std::vector<Vec2> modified_half(const ModifiedSide& side, const ModifiedGrid& grid, double z);

// The closed triangle mesh of a rack.
//
// Every strip of the plan view (cad/rack_plan.hpp) is a plane quadrilateral. A fillet is divided
// into strips that deviate from the cylinder by at most the tolerance. The back has one vertex
// below each vertex on the border of the teeth. The ends and sides of the bar connect these
// vertices.

/// Works like tessellate() (cad/mesh.hpp), for a body that is a rack.
///
/// Accuracy  planes are exact; a fillet deviates by ρ_f (1 − cos Δ/2) ≤ chord_tolerance_mm, where Δ
///           is the change of its direction over one strip
/// Errors    chord_tolerance_mm if the mesh would have more than 2·10⁶ vertices
Result<TriangleMesh> tessellate_rack(const ToothedBody& body, const MeshOptions& options);

}  // namespace gearwright
