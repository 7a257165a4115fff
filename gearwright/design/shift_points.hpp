// Lists the feasible points of a grid of shifts.
//
//   h           step of the grid; x1 = i h, x2 = j h
//   candidate   a grid point within the shift limits of both gears and within the range of Σ
//
// Vector code (design/candidate.hpp) computes the values that are compared with the limits. If a
// value is within kSieveDoubt of its limit, or if the axes are crossed, the graph decides. The list
// contains values from the scalar formulas, so it is the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/design/shift_region.hpp"

namespace gearwright {

/// Lengths are in mm, and angles in rad.
struct ShiftPoint {
  std::int64_t trial = 0;
  std::array<double, 2> shift{};
  double center_distance = 0.0;
  Angle working_angle;
  double contact_ratio = 0.0, contact_ratio_true = 0.0;
  std::optional<double> sliding;  ///< greatest |ζ|
  std::array<double, 2> tip_thickness{}, tip_clearance{};
  double backlash_normal = 0.0;
  bool interference = false;
};

struct PointCounts {
  std::int64_t tested = 0, feasible = 0;
  std::int64_t asked = 0;  ///< number of points decided by the graph
};
/// Appends the feasible points of a trial, sorted by x1 and then by x2.
///
/// Domain    step > 0; `region` is the region of `graph` (contract)
PointCounts feasible_points(const ShiftGraph& graph, const ShiftRegion& region, double step,
                            std::vector<ShiftPoint>& points);

}  // namespace gearwright
