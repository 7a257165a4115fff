// Computes the feasible region of the s1–s2 graph: its ends, its area, its boundary, and the part
// of the line of balanced strength inside the region.
//
//   lo, hi   middles of the slices with the least and with the greatest Σ
//   Eq. 11   x1 = (λ z2 + (Σ − λ) z1)/(z1 + z2), the line on which the strengths of both gears are
//            balanced; x1 = Σ for an internal pair
//                                              theory: docs/theory/09-design-search.md, 9.4
//
// Points are (x1, x2). Area, corners and roots are computed without sampling. Curved edges are
// sampled, but only for drawing.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// One part of the boundary and the limit that defines it.
struct RegionEdge {
  ShiftEdge edge;
  std::vector<Vec2>
      points;  ///< both ends of a straight edge, or points on a curve including its ends
};
/// `whole` computes the area of the region, and `point` omits the area.
enum class RegionDetail { point, whole };
/// `sought` computes off_walls by point_off_walls(). With `none`, the caller states that
/// point_off_walls() has no result; off_walls then stays empty.
enum class OffWalls { sought, none };

struct ShiftRegion {
  RegionDetail detail = RegionDetail::whole;
  std::vector<Interval> sums;            ///< ranges of Σ; more than one if the region consists of
                                         ///< several pieces
  std::array<Vec2, 2> lo_edge, hi_edge;  ///< ends of the slices with the least and the greatest Σ
  Vec2 lo, hi;
  double area = 0.0;                    ///< computed only with RegionDetail::whole
  std::vector<Interval> balanced_sums;  ///< Σ of the feasible points on the line of Eq. 11
  std::optional<Vec2> balanced;         ///< the point of balanced_sums with Σ nearest 0
  std::optional<Vec2> off_walls;        ///< point_off_walls()
};
/// Returns the region of a graph, or none if no point is feasible.
///
/// Accuracy  ends and corners are exact except for rounding; the area is accurate to 1e-12
std::optional<ShiftRegion> shift_region(const ShiftGraph& graph,
                                        RegionDetail detail = RegionDetail::whole,
                                        OffWalls off_walls = OffWalls::sought);

/// The desired distance of a design from the borders of its region, modules. At a border, a limit
/// is only just met. If no point on the line of balanced strength has this distance, half of the
/// greatest distance on the line is used. The band of centre distances does not count as a border.
inline constexpr double kWallDistance = 0.05;
/// Returns the point on the line of balanced strength with Σ nearest 0 whose distance from the
/// borders is at least kWallDistance. If no point of the line has this distance, half of the
/// greatest distance is required instead. The result is absent if all points of the line lie at a
/// border or outside the region.
///
/// If interference is permitted, no distance is required. The result is then absent if the point
/// with Σ nearest 0 lies at a border or outside the region. In this case, the caller uses
/// ShiftRegion::balanced if it exists. If Σ = 0 is feasible, all limits are usually evaluated only
/// once.
std::optional<Vec2> point_off_walls(const ShiftGraph& graph);
/// True if the line of balanced strength is certainly infeasible between the sums a and b. The
/// reason is that the line violates a limit of x1 or x2 alone. No point of this part of the line
/// then needs to be evaluated.
bool line_is_outside(const ShiftGraph& graph, double a, double b);
/// Returns the boundary of each piece of the region, counter-clockwise. If only one centre distance
/// is possible, the boundary is a segment that is traversed in both directions.
std::vector<std::vector<RegionEdge>> region_boundary(const ShiftGraph& graph,
                                                     const ShiftRegion& region);

/// Returns the point of a design: `off_walls`, or `balanced` if `off_walls` is absent, or
/// middle_point() if both are absent.
Vec2 chosen_point(const ShiftGraph& graph, const ShiftRegion& region);
/// Returns the middle between lo and hi if the region is one piece and this middle is far enough
/// from the borders. Otherwise, the function returns a point of the longest piece, the middle of
/// the slice at the mean Σ of this piece.
Vec2 middle_point(const ShiftGraph& graph, const ShiftRegion& region);

/// The point on the line of balanced strength (Eq. 11) with the given sum Σ.
Vec2 balanced_point(int z1, int z2, double sum, double lambda);

}  // namespace gearwright
