// The feasible region of the s1–s2 graph: its ends, area, boundary, and its piece of the line of
// Eq. 11.
//
//   lo, hi   middles of the slices at the least and the greatest Σ
//   Eq. 11   x1 = (λ z2 + (Σ − λ) z1)/(z1 + z2): strengths in balance; an internal gear's pinion
//            takes all
//                                              theory: docs/theory/09-design-search.md, 9.4
//
// Points are (x1, x2). Area, corners and roots are solved, not sampled; only the points that draw a
// curved edge are chosen.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// One stretch of the boundary, with the name of its limit.
struct RegionEdge {
  ShiftEdge edge;
  std::vector<Vec2> points;  ///< ends of a straight edge, or points of a curve with its ends
};

/// The requested extent of a region: its existence and a point in it, or also its area.
enum class RegionDetail { point, whole };
/// True if point_off_walls() was searched and does not exist.
enum class OffWalls { sought, none };

struct ShiftRegion {
  RegionDetail detail = RegionDetail::whole;
  std::vector<Interval> sums;            ///< Σ from … to; several if the region is in pieces
  std::array<Vec2, 2> lo_edge, hi_edge;  ///< the whole slices at the ends
  Vec2 lo, hi;
  double area = 0.0;                    ///< with `whole` only
  std::vector<Interval> balanced_sums;  ///< Σ of the feasible points of the line of Eq. 11
  std::optional<Vec2> balanced;         ///< the one of these with Σ nearest 0
  std::optional<Vec2> off_walls;        ///< the one of these off the borders with Σ nearest 0:
                                        ///< point_off_walls()
};

/// The region of a graph; none if nothing is feasible.   Accuracy  ends and corners to rounding,
/// area to 1e-12
std::optional<ShiftRegion> shift_region(const ShiftGraph& graph,
                                        RegionDetail detail = RegionDetail::whole,
                                        OffWalls off_walls = OffWalls::sought);

/// The distance of a design from every border of its region, modules, or half of what the line of
/// Eq. 11 allows, because a limit is only just satisfied at a border. The band of centre distances
/// does not count as a border.
inline constexpr double kWallDistance = 0.05;

/// The point of the line of Eq. 11 with Σ nearest 0 that keeps a distance from the borders; none if
/// the line has no such point. If interference is not excluded, the point may be at a border and is
/// then none, because the region contains it (`balanced`).   Cost  one evaluation of all limits
/// where Σ = 0 will do
std::optional<Vec2> point_off_walls(const ShiftGraph& graph);

/// True if the line of Eq. 11 between the sums a and b is outside a limit that is straight in the
/// plane, so no point of it needs evaluation.
bool line_is_outside(const ShiftGraph& graph, double a, double b);

/// The boundary of each piece, counter-clockwise; for a single centre distance, the segment in both
/// directions.
std::vector<std::vector<RegionEdge>> region_boundary(const ShiftGraph& graph,
                                                     const ShiftRegion& region);

/// A point for a design: the one away from the borders, otherwise the balanced one, otherwise the
/// middle of lo and hi. For a region in pieces, or if that middle is closer to a border than half
/// the possible distance, it is the middle of the longest piece.
Vec2 chosen_point(const ShiftGraph& graph, const ShiftRegion& region);
/// The last of these points.
Vec2 middle_point(const ShiftGraph& graph, const ShiftRegion& region);

/// The point of the line of Eq. 11 with the sum Σ.
Vec2 balanced_point(int z1, int z2, double sum, double lambda);

}  // namespace gearwright
