// The feasible region of the s1–s2 graph: its ends, its area, its boundary, and the part of the line of
// Eq. 11 inside it.
//
//   lo, hi   middles of the slices at the least and the greatest Σ
//   Eq. 11   x1 = (λ z2 + (Σ − λ) z1)/(z1 + z2), with which the strengths of both gears are balanced;
//            x1 = Σ for an internal pair
//                                              theory: docs/theory/09-design-search.md, 9.4
//
// Points are (x1, x2). Area, corners and roots are solved, not sampled. Only curved edges are sampled,
// for drawing.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// One part of the boundary, with the name of its limit.
struct RegionEdge {
  ShiftEdge edge;
  std::vector<Vec2>
      points;  ///< the two ends of a straight edge, or points of a curve with its ends
};
/// The extent of the computation: a point in the region, or also its area.
enum class RegionDetail { point, whole };
/// `sought` if point_off_walls() shall be computed; `none` if it is known not to exist.
enum class OffWalls { sought, none };

struct ShiftRegion {
  RegionDetail detail = RegionDetail::whole;
  std::vector<Interval> sums;            ///< ranges of Σ; several if the region is in pieces
  std::array<Vec2, 2> lo_edge, hi_edge;  ///< the whole slices at the ends
  Vec2 lo, hi;
  double area = 0.0;                    ///< only with RegionDetail::whole
  std::vector<Interval> balanced_sums;  ///< Σ of the feasible points of the line of Eq. 11
  std::optional<Vec2> balanced;         ///< the feasible point of this line with Σ nearest 0
  std::optional<Vec2> off_walls;        ///< point_off_walls()
};
/// The region of a graph; none if no point is feasible.
///
/// Accuracy  ends and corners to rounding, area to 1e-12
std::optional<ShiftRegion> shift_region(const ShiftGraph& graph,
                                        RegionDetail detail = RegionDetail::whole,
                                        OffWalls off_walls = OffWalls::sought);

/// The least distance of a design from the borders of its region, modules, because limits are only just
/// met at a border. If the line of Eq. 11 does not reach this distance, half of the greatest distance on
/// the line is used. The band of centre distances does not count as a border.
inline constexpr double kWallDistance = 0.05;
/// The point of the line of Eq. 11 with Σ nearest 0 that keeps a distance from the borders; none if the
/// line has no such point. If interference is not excluded, the point need not keep the distance; if it
/// lies at a border, the result is none, and ShiftRegion::balanced contains the point. If Σ = 0 is
/// feasible, all limits are usually evaluated only once.
std::optional<Vec2> point_off_walls(const ShiftGraph& graph);
/// True if the line of Eq. 11 between the sums a and b lies outside a limit that is a straight line in
/// the plane, so that no point of it needs to be evaluated.
bool line_is_outside(const ShiftGraph& graph, double a, double b);
/// The boundary of each piece, counter-clockwise. If only one centre distance is possible, the boundary
/// is a segment in both directions.
std::vector<std::vector<RegionEdge>> region_boundary(const ShiftGraph& graph,
                                                     const ShiftRegion& region);

/// The point of a design: `off_walls` if it exists, otherwise `balanced` if it exists, otherwise
/// middle_point().
Vec2 chosen_point(const ShiftGraph& graph, const ShiftRegion& region);
/// The middle between lo and hi. If the region is in pieces, or if that middle is too close to a border,
/// the result is the middle of the slice at the middle Σ of the longest piece.
Vec2 middle_point(const ShiftGraph& graph, const ShiftRegion& region);

/// The point of the line of Eq. 11 with the sum Σ.
Vec2 balanced_point(int z1, int z2, double sum, double lambda);

}  // namespace gearwright
