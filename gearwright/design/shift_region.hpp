// The feasible region of the s1–s2 graph: its ends, area, boundary, and its piece of the line of
// Eq. 11.
//
//   lo, hi   middles of the slices at the least and the greatest Σ
//   Eq. 11   x1 = (λ z2 + (Σ − λ) z1)/(z1 + z2): strengths in balance; an internal gear's pinion
//                                              takes all theory: docs/theory/09-design-search.md,
//                                              9.4
//
// Points are (x1, x2). Area, corners and roots are solved, not sampled; only the points that draw a
// curved edge are chosen.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// One stretch of the boundary, named after the limit that it is.
struct RegionEdge {
  ShiftEdge edge;
  std::vector<Vec2> points;  ///< ends of a straight one; of a curve points on it, ends included
};

struct ShiftRegion {
  std::vector<Interval> sums;            ///< Σ from … to; more than one: the region is in pieces
  std::array<Vec2, 2> lo_edge, hi_edge;  ///< the whole slices at the ends
  Vec2 lo, hi;
  double area = 0.0;
  std::vector<Interval> balanced_sums;  ///< Σ of the feasible points of the line of Eq. 11
  std::optional<Vec2> balanced;         ///< of them the one with Σ nearest 0
};

/// Its numbers; none: nothing is feasible.   Accuracy  ends and corners to rounding, area to 1e-12
std::optional<ShiftRegion> shift_region(const ShiftGraph& graph);

/// The boundary of each piece, counterclockwise; of a band that is one distance the segment there
/// and back.
std::vector<std::vector<RegionEdge>> region_boundary(const ShiftGraph& graph,
                                                     const ShiftRegion& region);

/// A point for a design: the balanced one, else the middle of lo and hi, of a region in pieces or
/// not convex the middle of its longest piece.
Vec2 chosen_point(const ShiftGraph& graph, const ShiftRegion& region);

/// The point of the line of Eq. 11 with the sum Σ.
Vec2 balanced_point(int z1, int z2, double sum, double lambda);

}  // namespace gearwright
