// Upper bounds of the margins in a cell, which is a rectangle of S and x_1 in the shift graph. Each
// margin consists of terms that are monotone in S, x_1 or x_2:
//
//   C, N       increase with S, decrease for an internal gear      ρ_1E, ρ_F1   increase with x_1
//   ρ_2A       increases with x_2, decreases for an internal gear  ρ_F2         increases with x_2
//   clearance  h_f − h_a + σ(C − C_0) − S depends on S alone; C_0 is the centre distance without
//              shifts. Its slope is sin α_t/sin α_wt − 1 at tight centres and 0 at extended ones,
//              so its extrema are at S = 0 and at the ends of an interval
//
// The terms at the ends of the intervals therefore give an upper bound for the whole cell. This
// bound converges to the margin as the cell shrinks.
#pragma once

#include "tests/oracle/plain_pair.hpp"

namespace gearwright::oracle::plain {

/// The shifts within their own limits and those of the centre distance: a polygon in (S, x_1).
struct Box {
  Interval s, x1, x2;

  Interval x1_at(long double sum) const;
};

struct Cell {
  Interval s, x1;
  long double max = 0;  ///< its upper bound
};

/// The least of all margins except those of the limits of the shifts themselves.
long double contact_margin(const Pair& pair, long double x1, long double x2);

/// An upper bound of `contact_margin` at the points of the box in a cell. −∞ if there are none.
long double upper_bound(const Pair& pair, const Box& box, const Cell& cell);

}  // namespace gearwright::oracle::plain
