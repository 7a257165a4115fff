// Computes the transmission error over a pitch. Many positions are searched at once, one in each
// SIMD lane (touch_lanes.hpp).
//
//   m    position of tooth pair 0, at the rotation first + m·pitch/n. The touch of pair 0 at m is
//        the touch of pair (i − m)/n at position i = m mod n of the pitch
//                                              theory: docs/theory/14-scatter.md, section 14.4
//
// The touches at positions an eighth of a pitch apart are computed first. Each of these searches
// starts in the middle of the line of contact. The touches between these positions are computed
// next. Their searches start from a polynomial through the touches already found. Because the slope
// of T is exact at every touch, two or three steps find each extreme between the positions.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/touch_lanes.hpp"

namespace gearwright::detail {

class LaneTrack {
 public:
  /// Returns none if the axes are crossed, if LaneSearch does not apply to the flanks, if T may
  /// have several maxima on a flank, or if no touch is found at a position.
  static std::optional<LaneTrack> of(Transmission& transmission, double first, int n);

  /// Returns the same touches as Transmission::over_a_pitch().
  const std::vector<PairTouch>& touches() const { return best_; }
  /// Returns the same extremes as continuous_extremes(). Returns none if a branch that begins or
  /// ends has the greatest T at that rotation, or if a third tooth pair may have the greatest T at
  /// a handover. Also returns none if LaneSearch did not find a touch or does not converge.
  std::optional<CurveExtremes> extremes() const;

 private:
  struct Path;
  struct Rough;
  struct Candidate;
  LaneTrack(Transmission& transmission, const LaneSearch& search, double first, int n);
  double own(int m) const { return first_ + m * step_; }
  const PairTouch* at(int m) const;
  int leader(int i) const;
  PairTouch start_between(const PairTouch& a, const PairTouch& b, double part, double phi) const;
  Rough search_path(const Path& path) const;
  std::optional<std::array<int, 2>> window_of(const Rough& rough) const;
  PairTouch start_at(int m, const Rough& rough) const;
  void search_window(const Rough& rough, const std::array<int, 2>& window);
  void cross_seams(std::vector<PairTouch>& touches) const;
  void extend(int direction);
  void offer(int m, const PairTouch& t);

  Transmission* transmission_;
  LaneSearch search_;
  double first_, step_;
  int n_, lo_ = 0, whole_ = 0;
  std::vector<PairTouch> track_;  // touches of tooth pair 0, from position lo_ on
  std::vector<PairTouch> best_;
};

}  // namespace gearwright::detail
