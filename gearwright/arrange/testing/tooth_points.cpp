#include "gearwright/arrange/testing/tooth_points.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>

#include "gearwright/base/numbers.hpp"

namespace gearwright::testing {

Tooth::Tooth(const Gear& gear, int points_per_arc)
    : z_(std::abs(gear.spec.teeth)), internal_(gear.internal()) {
  for (const Arc& arc : gear.tooth->outline.arcs)
    for (const Vec2& p : sample(arc, points_per_arc)) {
      const Vec2 polar(p.norm(), std::atan2(p.y(), p.x()));
      if (!polar_.empty() && !((polar_.back() - polar).norm() > 0.0)) continue;
      polar_.push_back(polar);
      points_.push_back(p);
      points_.emplace_back(p.x(), -p.y());
    }
  rises_ = std::is_sorted(polar_.begin(), polar_.end(),
                          [&](const Vec2& a, const Vec2& b) { return is_nearer_root(a, b); });
  middle_ = Vec2((root() + tip()) / 2, 0.0);
  for (const Vec2& p : points_) around_ = std::max(around_, (p - middle_).norm());
}

double Tooth::most(double rho, double spread) const {
  const double outside = internal_ ? tip() - (rho + spread) : rho - spread - tip();
  return outside > 0.0 ? -outside : 1e9;
}

double Tooth::depth(double rho, double psi) const {
  const double pitch = kTurn / z_;
  psi = std::abs(std::remainder(psi, pitch));
  if (internal_ ? rho > root() : rho < root()) return std::abs(rho - root());
  if (internal_ ? rho < tip() : rho > tip()) return -std::abs(rho - tip());
  // The first piece whose end is at least as near the tip as ρ.
  const Vec2 at(rho, 0.0);
  std::size_t i = 1;
  for (std::size_t step = rises_ ? std::bit_floor(polar_.size()) : 0; step > 0; step /= 2)
    if (i + step < polar_.size() && is_nearer_root(polar_[i + step - 1], at)) i += step;
  for (; i < polar_.size(); ++i) {
    const double a = polar_[i - 1].x(), b = polar_[i].x();
    if ((rho - a) * (rho - b) > 0.0 || a == b) continue;
    const double half =
        polar_[i - 1].y() + (rho - a) / (b - a) * (polar_[i].y() - polar_[i - 1].y());
    return (half - psi) * rho;
  }
  return -1.0;
}

double depth_in(const Tooth& a, const PlacedGear& at_a, const Tooth& b, const PlacedGear& at_b,
                double worst) {
  const Vec2 apart = at_a.axis - at_b.axis;
  for (int k = 0; k < a.teeth(); ++k) {
    const Eigen::Rotation2Dd turn(at_a.angle + kTurn * k / a.teeth());
    const auto place = [&](const Vec2& p) -> Vec2 { return apart + turn * p; };
    if (b.most(place(a.middle()).norm(), a.around()) <= worst) continue;
    const Eigen::Matrix2d matrix = turn.toRotationMatrix();
    for (const Vec2& p : a.points()) {
      const Vec2 at = apart + matrix * p;
      const double rho = at.norm();
      if (b.most(rho, 0.0) <= worst) continue;
      worst = std::max(worst, b.depth(rho, std::atan2(at.y(), at.x()) - at_b.angle));
    }
  }
  return worst;
}

}  // namespace gearwright::testing
