// Computes the plan view of the bar of a rack. The plan is a rectangle that the lines of the teeth
// cross. Internal to cad/.
//
//   y, z    coordinates along the travel and along the face, mm; −l/2 ≤ y ≤ l/2, −b/2 ≤ z ≤ b/2
//   q       tan β, slope of the teeth        s   y − q z, constant along a tooth, mm
//   strip   the part s_0 ≤ s ≤ s_1 of the rectangle that belongs to one arc of the section
//
// The surface of the teeth is x = h(s). Each face of this surface is therefore a strip, bounded by
// two lines of constant s and by the border of the rectangle. When s increases, a line of constant
// s moves over the rectangle from one corner to the opposite corner. For a spur rack, it moves from
// one end to the other. The two ends of the line run along the border, one on the low side and one
// on the high side of z. Each end of the line passes one corner.
#pragma once

#include <array>
#include <vector>

#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// The strip that belongs to one arc of tooth k, or to both halves of a land.
struct RackStrip {
  ArcName name;
  double begin, end;  ///< s  mm, begin < end
  const Arc* arc;     ///< an arc of the half outline
  double middle;      ///< s of the centre line of the tooth, mm
  bool lower;         ///< true on the side y < 0 of the tooth, where the arc is mirrored
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
  /// Return the values of s at which the line passes a corner, first with its low end point and
  /// then with its high end point. For a spur rack, both values equal first().
  double low_corner() const { return low_corner_; }
  double high_corner() const { return high_corner_; }

  /// Returns the value of s at a corner if this corner is within 1e-6 mm, and otherwise s.
  double snapped(double s) const;

  /// Return the low and the high end point of a line of constant s as (y, z) in mm, exactly on
  /// the border.
  Vec2 low(double s) const;
  Vec2 high(double s) const;

  /// Returns the strips in ascending order of s, from first() to last(). Neighbouring strips share
  /// their limits exactly. A strip narrower than 1e-6 mm is merged into a neighbour.
  const std::vector<RackStrip>& strips() const { return strips_; }

 private:
  Vec2 at(double s, double z) const;
  Vec2 end_of_line(double s, double z, double corner, double y) const;

  double length_, width_, slope_;
  std::array<double, 4> corners_;  // s of the corners, ascending
  double low_corner_, high_corner_;
  std::vector<RackStrip> strips_;
};

}  // namespace gearwright
