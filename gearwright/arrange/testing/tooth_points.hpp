// Points of teeth and their depth inside other teeth, for tests of drives. They are computed from
// the outlines only, without the code of the overlaps.
#pragma once

#include <vector>

#include "gearwright/drive/drive_layout.hpp"

namespace gearwright::testing {

/// A tooth, described by the points of its half outline from root to tip and by its half angle as a
/// function of the radius.
class Tooth {
 public:
  Tooth(const Gear& gear, int points_per_arc);

  int teeth() const { return z_; }
  /// The points of the whole tooth. The x axis is its centre line.
  const std::vector<Vec2>& points() const { return points_; }
  /// All points lie within a circle about middle() with the radius around().
  const Vec2& middle() const { return middle_; }
  double around() const { return around_; }

  /// An upper limit of the depth of all points at the distances `rho` ± `spread` from the axis. If
  /// all these points are beyond the tip circle, the limit is the negative distance of the nearest
  /// one from this circle. Otherwise there is no limit, and the result is 1e9.
  double most(double rho, double spread) const;
  /// Depth of the point (ρ, ψ) inside the tooth, normal to the flank, in mm; negative outside the
  /// tooth. ψ is measured from the middle of the tooth.
  double depth(double rho, double psi) const;

 private:
  double root() const { return polar_.front().x(); }
  double tip() const { return polar_.back().x(); }
  bool is_nearer_root(const Vec2& a, const Vec2& b) const {
    return internal_ ? a.x() > b.x() : a.x() < b.x();
  }

  int z_;
  bool internal_;
  bool rises_;               // true if the radius never falls from root to tip
  std::vector<Vec2> polar_;  // radius, polar angle from the middle of the tooth
  std::vector<Vec2> points_;
  Vec2 middle_;
  double around_ = 0.0;
};

/// Returns the greatest depth of any point of gear a inside gear b, mm, or `worst` if that is
/// greater. Teeth and points that are too far away to be deeper than `worst` are left out.
double depth_in(const Tooth& a, const PlacedGear& at_a, const Tooth& b, const PlacedGear& at_b,
                double worst);

}  // namespace gearwright::testing
