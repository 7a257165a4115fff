// Cells of the shift graph, and upper bounds of the margins in a cell. Each margin consists of
// terms that only increase or only decrease with S, x_1 or x_2:
//
//   C, N      with S: rising, ring falling          ρ_1E, ρ_F1   rising with x_1
//   ρ_2A      with x_2: rising, ring falling        ρ_F2         rising with x_2
//   clearance h_f − h_a + σ(C − C_0) − S, C_0 the centres without shifts: of S alone; its slope is
//             sin α_t/sin α_wt − 1 on tight centres, 0 on extended ones, so it is least or greatest
//             at S = 0 and at the ends of an interval
//
// so a cell of (S, x_1) has an upper bound at the ends of its intervals, and this bound converges
// to the margin as the cell shrinks.
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
