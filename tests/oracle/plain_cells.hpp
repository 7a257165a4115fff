// Cells of the shift graph, and what no pair of shifts in one can exceed. Each margin is made of
// terms that only rise or only fall with S, x_1 or x_2 alone:
//
//   C, N      with S: rising, ring falling          ρ_1E, ρ_F1   rising with x_1
//   ρ_2A      with x_2: rising, ring falling        ρ_F2         rising with x_2
//   clearance h_f − h_a + σ(C − C_0) − S, C_0 the centres without shifts: of S alone; its slope is
//             sin α_t/sin α_wt − 1 on tight centres, 0 on extended ones, so it is least or greatest
//             at S = 0 and at the ends of an interval
//
// so a cell of (S, x_1) has an upper bound at the ends of its intervals, and the bound comes down
// to the margin as the cell shrinks.
#pragma once

#include "tests/oracle/plain_pair.hpp"

namespace gearwright::oracle::plain {

/// Shifts that their own limits and the centre distances leave: a polygon in (S, x_1).
struct Box {
  Interval s, x1, x2;

  Interval x1_at(long double sum) const;
};

struct Cell {
  Interval s, x1;
  long double max = 0;  ///< its upper bound
};

/// The least margin of all but the shifts' own limits.
long double contact_margin(const Pair& pair, long double x1, long double x2);

/// What `contact_margin` cannot exceed at the points of the box in a cell; −∞: there are none.
long double upper_bound(const Pair& pair, const Box& box, const Cell& cell);

}  // namespace gearwright::oracle::plain
