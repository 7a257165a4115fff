// The wall of teeth with flank modifications for a mesh, level by level. Internal to cad/.
//
//   ε    chord tolerance of the mesh, mm        c   removed from the flank, mm
//
// The grid is that of the teeth as cut, with a share of ε kept back, and with a line of vertices
// where a relief begins. Its segments and its steps along the face are halved until c, between the
// corners of a facet, differs from its mean by less than that share, and by less than a tenth of
// the greatest c: a crowning of 5 µm is in a mesh of 5 µm.
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

/// The grid, from the section as cut and the step along the face that the twist needs.
///
/// Units     mm
ModifiedGrid modified_grid(const ModifiedTeeth& teeth, std::vector<SectionPoint> half, double width,
                           double step, double tolerance);

/// The rings of one pitch, counter-clockwise from the middle of a space.
std::vector<Ring> modified_rings(const ModifiedTeeth& teeth, const ModifiedGrid& grid, int copies);

/// The columns of the divided outline that are creases, because a relief begins there.
void crease_at_reliefs(const ModifiedTeeth& teeth, const ModifiedGrid& grid, WallEdges& edges);

/// The half section of one side at the height z, turned back by the twist, root to tip.
std::vector<Vec2> modified_half(const ModifiedSide& side, const ModifiedGrid& grid, double z);

}  // namespace gearwright
