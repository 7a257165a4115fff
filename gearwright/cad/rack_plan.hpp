// Plan view of the bar of a rack: a rectangle crossed by the lines of its teeth. Internal to cad/.
//
//   y, z    along the travel and along the face, −l/2 ≤ y ≤ l/2, −b/2 ≤ z ≤ b/2, mm
//   q       tan β, slope of the teeth        s   y − q z, constant along a tooth, mm
//   strip   the part of one arc of the section: s_0 ≤ s ≤ s_1, cut off by the rectangle
//
// The surface of the teeth is x = h(s), so each of its faces is a strip, bounded by two lines of
// constant s and by the border of the rectangle. As s increases, a line of constant s moves over
// the rectangle from one corner (spur: from one end) to the opposite one. Its two ends run along
// the border, one on the low side and one on the high side of z, and each passes one corner.
#pragma once

#include <array>
#include <vector>

#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// A strip of the section: an arc of tooth k, or the two halves of a land.
struct RackStrip {
  ArcName name;
  double begin, end;  ///< s  mm, begin < end
  const Arc* arc;     ///< of the half outline
  double middle;      ///< s of the middle of its tooth, mm
  bool lower;         ///< on the side y < 0 of its tooth, where the arc is mirrored
};

class RackPlan {
 public:
  /// Domain    a body that is a rack, with a face width > 0 and a back below the roots (contract)
  explicit RackPlan(const ToothedBody& body);

  double length() const { return length_; }  ///< l  mm
  double width() const { return width_; }    ///< b  mm
  double slope() const { return slope_; }    ///< q
  double first() const { return corners_[0]; }
  double last() const { return corners_[3]; }
  /// s of the corner that the low end passes, and s of the corner that the high end passes. For a spur
  /// rack, both are first().
  double low_corner() const { return low_corner_; }
  double high_corner() const { return high_corner_; }

  /// Returns s, or the s of a corner that is within 1e-6 mm of it.
  double snapped(double s) const;

  /// Returns the ends of a line of constant s: (y, z) in mm, exactly on the border.
  Vec2 low(double s) const;
  Vec2 high(double s) const;

  /// Strips in the order of s, from first() to last(). Neighbours share their bounds exactly.
  /// Strips narrower than 1e-6 mm are merged into their neighbours.
  const std::vector<RackStrip>& strips() const { return strips_; }

 private:
  Vec2 at(double s, double z) const;
  Vec2 end_of_line(double s, double z, double corner, double y) const;

  double length_, width_, slope_;
  std::array<double, 4> corners_;  // in the order of s
  double low_corner_, high_corner_;
  std::vector<RackStrip> strips_;
};

}  // namespace gearwright
