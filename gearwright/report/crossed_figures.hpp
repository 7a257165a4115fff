// Draws figures of a crossed pair, which are its plan, its section, the use of its faces, and
// curves over the pressure angle of the common rack.
//
//   A–E       leading line of action    T_1, T_2  base tangent points    C  pitch point of gear 1
//   A′–E′     trailing line of action: the leading line turned by 180° about the centre line
//   plan      view along the centre line from the side of gear 2, true to scale: y points to the
//             right, z up, and axis 1 is upright
//   section   cut by the plane of the leading line, normal to the teeth of the common rack. The
//             section shows the rack without distortion, the line of action in true length at the
//             angle α_wn, and cylinders as ellipses. The trailing line lies in a parallel plane and
//             is projected along the teeth.
//   h         to the right, in the direction of motion of the rack    x   up, along the centre
//             line, from gear 1 to gear 2
//   z_L       offset of the plane along the teeth from the centre line, mm
//   f, f′     face widths required by one flank, and by both flanks about the common
//             perpendicular, mm
//   s_i       axial position on gear i, from the middle of its face, mm
#pragma once

#include <array>
#include <string>

#include "gearwright/base/vector.hpp"
#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/report/page_parts.hpp"

namespace gearwright {

/// Returns a point of the housing, seen in plan, mm: (y, z).
Vec2 in_plan(const Point<Housing>& p);

/// Returns the corners in plan of the cylinder of gear `which` (0, 1) with `radius` and face width.
std::array<Vec2, 4> face_in_plan(const CrossedPair& pair, std::size_t which, double radius);

/// Draws the lines of action in plan, and both whole gears in plan.
std::array<Figure, 2> plan_figures(const CrossedPair& pair);

std::string plan_part(const CrossedPair& pair, const FigureForm& form = {});

/// Returns the projection of a point of the housing onto the section, (h, x) in mm.
///
/// Formula   h = −σ y cos β_1 + z sin β_1; σ = −1 if gear 2 is internal, else 1
Vec2 in_section(const CrossedPair& pair, const Point<Housing>& p);

struct SectionEllipse {
  Vec2 center;         ///< (h, x)  mm
  double half_width;   ///< along h, mm
  double half_height;  ///< along x, mm
};

/// Returns the cylinder of `radius` about the axis of gear `which` (0, 1), cut by the plane of the
/// section.
///
/// Formula   centre (z_L tan β_1, 0), (−σ z_L tan β_2, a); half width r/cos β_i, half height r
/// Domain    radius > 0 (contract)
SectionEllipse section_of_cylinder(const CrossedPair& pair, std::size_t which, double radius);

Figure section_figure(const CrossedPair& pair);

/// Draws the centre distance, the shaft angle and the contact ratio of the pair without backlash in
/// three panels. They are functions of the pressure angle α_wn of the common rack. Marks show the
/// least centre distance, its approximations, and the mounted pair.
std::string range_figure(const CrossedPair& pair, UnitSystem units = UnitSystem::mm);

/// Draws the required face widths f and f′ as functions of α_wn, with the actual face widths.
Figure face_width_figure(const CrossedPair& pair);

/// Draws the faces from end to end, with the parts that the leading and the trailing line use.
///
/// Domain    the flanks meet (contract)
Figure face_use_figure(const CrossedPair& pair);

/// Draws the sliding of the flanks, across the teeth (as on parallel axes) and along the teeth (as
/// in a screw), mm per radian of gear 1.
///
/// Domain    the flanks meet (contract)
Figure speed_figure(const CrossedPair& pair);

/// Writes a table of the speeds at which the contact moves over each flank, at the points A, C and
/// E.
///
/// Domain    the flanks meet (contract)
std::string speed_table(const CrossedPair& pair, UnitSystem units = UnitSystem::mm);

/// Draws the exact least centre distance, and approximations for manual calculation. The solutions
/// of pair/series.hpp are marked on a magnified part of the curve a(α_wn). The result is empty if
/// there is no least centre distance, if the gears have different racks, or if all solutions agree
/// within 1e-6 µm.
std::string min_distance_figure(const CrossedPair& pair, UnitSystem units = UnitSystem::mm);

/// Writes a table of the exact least centre distance and its approximations. Each row shows the
/// α_wn of one solution, the exact shaft angle and centre distance at this α_wn, and the
/// differences Δ from the exact solution. If all solutions agree (the sum of shifts is 0), a
/// sentence replaces the table. The result is empty if there are no approximations.
std::string min_distance_table(const CrossedPair& pair, UnitSystem units = UnitSystem::mm);

/// Writes table and figure of the least centre distance, in a folded section for manual checks.
/// Without a figure, the table is not folded.
std::string min_distance_part(const CrossedPair& pair, UnitSystem units);

}  // namespace gearwright
