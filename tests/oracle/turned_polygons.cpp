#include "tests/oracle/turned_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle {

using Eigen::Vector2d;

TurnedPolygons::Gear TurnedPolygons::gear_of(const ToothedPolygon& polygon) {
  Gear gear{std::abs(polygon.teeth), polygon.teeth < 0, polygon.half_tooth.back().norm(), {}};
  const double pitch = 2 * kPi / gear.teeth;
  const double c = std::cos(pitch), s = std::sin(pitch);
  const auto& half = polygon.half_tooth;
  for (std::size_t i = half.size(); i-- > 0;) gear.pitch.push_back(half[i]);
  // The other side of the next tooth.
  for (std::size_t i = 1; i < half.size(); ++i) {
    const Vector2d m(half[i].x(), -half[i].y());
    gear.pitch.push_back({c * m.x() - s * m.y(), s * m.x() + c * m.y()});
  }
  return gear;
}

TurnedPolygons::TurnedPolygons(ToothedPolygon gear_1, ToothedPolygon gear_2, double a, int lines)
    : one_(gear_of(gear_1)),
      two_(gear_of(gear_2)),
      a_(a),
      lines_(static_cast<std::size_t>(lines)),
      cuts_1_(lines_),
      cuts_2_(lines_),
      starts_1_(lines_),
      starts_2_(lines_) {
  // x from the intersection of the tip circles (for external gears, from the tip of the mating
  // gear) to tip 1.
  from_ = two_.ring
              ? std::max(-one_.tip, (two_.tip * two_.tip - a * a - one_.tip * one_.tip) / (2 * a))
              : a - two_.tip;
  step_ = (one_.tip - from_) / lines;
  if (two_.ring) return;
  // Points nearer to their axis than all lines remain outside the lines at every rotation.
  for (Gear* gear : {&one_, &two_}) {
    const double least = gear == &one_ ? from_ : a - one_.tip;
    std::vector<Vector2d> kept;
    const auto& all = gear->pitch;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool beside = i > 0 && i + 1 < all.size() && all[i - 1].norm() < least &&
                          all[i].norm() < least && all[i + 1].norm() < least;
      if (!beside) kept.push_back(all[i]);
    }
    gear->pitch = kept;
  }
}

void TurnedPolygons::cut(const Gear& gear, double turn, double sign, double offset, Cuts& cuts,
                         std::vector<char>& starts) const {
  for (auto& c : cuts) c.clear();
  const double pitch = 2 * kPi / gear.teeth;
  // The teeth near the x axis: those within the common part of the tip circles, and one more on
  // each side. If that is a large part of the circle, all teeth are used.
  const double nearest = sign * from_ + offset;
  double widest = kPi;
  if (sign < 0.0 || nearest > 0.0) {
    widest = 0.0;
    constexpr int kPlaces = 256;
    for (int i = 0; i <= kPlaces; ++i) {
      const double x = from_ + (one_.tip - from_) * i / kPlaces;
      const double here = sign * x + offset;
      widest = std::max(widest, std::atan2(half_length(x), here));
    }
  }
  const int reach = static_cast<int>(std::min(1e6, (widest + 0.1) / pitch)) + 2;
  const bool all = (reach + 0.5) * pitch > 1.5;  // a ray in that direction would miss the lines
  const double base = std::remainder(turn, pitch);
  const int begin = all ? 0 : -reach;
  const int end = all ? gear.teeth : reach;
  // Each line starts below, either far away or on the ray through the middle of the first tooth.
  for (std::size_t i = 0; i < lines_; ++i) {
    const double x = sign * line(i) + offset;
    const double rho =
        all ? std::numeric_limits<double>::infinity() : x / std::cos(base + begin * pitch);
    starts[i] = gear.ring ? rho > gear.tip : rho < gear.tip;
  }
  for (int k = begin; k < end; ++k) {
    const double angle = base + k * pitch;
    const double c = std::cos(angle), s = std::sin(angle);
    const auto place = [&](const Vector2d& p) { return sign * (c * p.x() - s * p.y() - offset); };
    const double scale = 1.0 / step_;
    double before = (place(gear.pitch.front()) - from_) * scale - 0.5;
    for (std::size_t j = 1; j < gear.pitch.size(); ++j) {
      const double after = (place(gear.pitch[j]) - from_) * scale - 0.5;
      const double lo = std::floor(std::min(before, after));
      const double hi = std::floor(std::max(before, after));
      if (lo != hi && hi >= 0.0 && lo < static_cast<double>(lines_) - 1) {
        const Vector2d& p = gear.pitch[j - 1];
        const Vector2d& q = gear.pitch[j];
        const double y_p = s * p.x() + c * p.y(), y_q = s * q.x() + c * q.y();
        for (double i = std::max(0.0, lo + 1); i <= hi && i < static_cast<double>(lines_); ++i)
          cuts[static_cast<std::size_t>(i)].push_back(y_p + (y_q - y_p) * (i - before) /
                                                                (after - before));
      }
      before = after;
    }
  }
  if (!all) return;
  for (auto& c : cuts) std::sort(c.begin(), c.end());
}

double TurnedPolygons::half_length(double x) const {
  const auto chord = [](double r, double d) { return std::sqrt(std::max(0.0, (r - d) * (r + d))); };
  const double in_1 = chord(one_.tip, x);
  return two_.ring ? in_1 : std::min(in_1, chord(two_.tip, a_ - x));
}

double TurnedPolygons::shared_area(double phi, double turn) const {
  const double ratio = static_cast<double>(one_.teeth) / two_.teeth;
  cut(one_, phi, 1.0, 0.0, cuts_1_, starts_1_);
  // Gear 2 has a space on the x axis. An external gear is viewed from its own side, so it is turned
  // by half a turn.
  const double half = kPi / two_.teeth;
  const double rolled = (two_.ring ? ratio : -ratio) * phi + turn;
  if (two_.ring)
    cut(two_, half + rolled, 1.0, a_, cuts_2_, starts_2_);
  else
    cut(two_, half + rolled, -1.0, a_, cuts_2_, starts_2_);
  double length = 0.0;
  std::vector<double> seen;
  for (std::size_t i = 0; i < lines_; ++i) {
    auto& one = cuts_1_[i];
    seen = cuts_2_[i];
    bool in_2 = starts_2_[i] != 0;
    if (!two_.ring) {  // y has the opposite direction for an external gear
      if (seen.size() % 2 == 1) in_2 = !in_2;
      std::reverse(seen.begin(), seen.end());
      for (double& y : seen) y = -y;
    }
    const double x = line(i);
    const double half_line = half_length(x);
    bool in_1 = starts_1_[i] != 0;
    double y = -half_line;
    std::size_t j = 0, k = 0;
    while (j < one.size() || k < seen.size()) {
      const bool first = k == seen.size() || (j < one.size() && one[j] < seen[k]);
      const double next = std::clamp(first ? one[j] : seen[k], -half_line, half_line);
      if (in_1 && in_2) length += std::max(0.0, next - y);
      y = std::max(y, next);
      if (first) {
        in_1 = !in_1;
        ++j;
      } else {
        in_2 = !in_2;
        ++k;
      }
    }
    if (in_1 && in_2) length += std::max(0.0, half_line - y);
  }
  return length * step_;
}

}  // namespace gearwright::oracle
