// The wall of teeth with flank modifications for a mesh, level by level. Internal to cad/.
//
//   ε    chord tolerance of the mesh, mm        c   removed from the flank, mm
//
// The grid of the teeth as cut uses the share kCutShare of ε, and has a line of vertices where a relief
// begins. Segments and steps along the face are halved until c in the middle of a facet differs from the
// mean of its corners by less than the rest of ε, and by less than a tenth of the greatest c. A mesh with
// ε = 5 µm therefore shows a crowning of 5 µm.
#pragma once

#include <array>
#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/section_points.hpp"

namespace gearwright {

/// The part of the chord tolerance that the teeth as cut may use; the rest is for c.
inline constexpr double kCutShare = 0.8;

struct ModifiedGrid {
  std::vector<SectionPoint> half;  ///< of the divided outline as cut
  std::vector<double> levels;      ///< mm, growing
};

/// The grid, made from the section as cut and the step along the face that the twist requires.
///
/// Units     mm
ModifiedGrid modified_grid(const ModifiedTeeth& teeth, std::vector<SectionPoint> half, double width,
                           double step, double tolerance);

/// The rings of one pitch, counter-clockwise from the middle of a space.
std::vector<Ring> modified_rings(const ModifiedTeeth& teeth, const ModifiedGrid& grid, int copies);

/// Marks those columns of the divided outline as creases at which a relief begins.
void crease_at_reliefs(const ModifiedTeeth& teeth, const ModifiedGrid& grid, WallEdges& edges);

/// The half section of one side at the height z, turned back by the twist, root to tip.
std::vector<Vec2> modified_half(const ModifiedSide& side, const ModifiedGrid& grid, double z);

}  // namespace gearwright
