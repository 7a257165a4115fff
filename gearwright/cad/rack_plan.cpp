#include "gearwright/cad/rack_plan.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr double kNarrow_mm = 1e-6;  // mm, a hundredth of the resolution of manufacturing machines

// Returns all strips of the teeth k_0 … k_1 of an infinite rack. The teeth have the same numbers as
// the teeth of the bar.
std::vector<RackStrip> endless(const ToothedBody& body, int k_0, int k_1) {
  const std::vector<Arc>& arcs = body.outline.arcs;
  const double pitch = body.rack->pitch;
  std::vector<RackStrip> strips;
  const auto add = [&](const RackStrip& strip) {
    const bool same_land = !strips.empty() && strips.back().name == strip.name &&
                           (strip.name == ArcName::root_land || strip.name == ArcName::tip_land);
    if (same_land) {
      strips.back().end = strip.end;
    } else {
      strips.push_back(strip);
    }
  };
  for (int k = k_0; k <= k_1; ++k) {
    const double middle = body.rack->middle_of(k, body.outline.teeth);
    for (const Arc& arc : arcs) {
      // Both teeth next to a space compute the s of the middle of the space by the same expression,
      // so both values are identical.
      const double begin =
          &arc == &arcs.front() ? middle - pitch / 2 : middle - arc.begin_point.y();
      add({arc.name, begin, middle - arc.end_point.y(), &arc, middle, true});
    }
    for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc) {
      const double end = arc + 1 == arcs.rend()
                             ? body.rack->middle_of(k + 1, body.outline.teeth) - pitch / 2
                             : middle + arc->begin_point.y();
      add({arc->name, middle + arc->end_point.y(), end, &*arc, middle, false});
    }
  }
  return strips;
}

}  // namespace

RackPlan::RackPlan(const ToothedBody& body) {
  GW_EXPECTS(body.rack && body.outline.teeth >= 1 && !body.outline.arcs.empty());
  GW_EXPECTS(body.face_width > 0.0 &&
             -body.rack->height < body.outline.arcs.front().begin_point.x());
  length_ = body.outline.teeth * body.rack->pitch;
  width_ = body.face_width;
  slope_ = body.rack->slope;
  const double y = length_ / 2, climb = std::abs(slope_) * width_ / 2;
  corners_ = {-y - climb, std::min(-y + climb, y - climb), std::max(-y + climb, y - climb),
              y + climb};
  // If q > 0, the low end point of the line lies on the end face y = −l/2 of the bar for small
  // s. If q < 0, the low end point lies on the end face y = l/2 for large s.
  low_corner_ = slope_ > 0.0 ? -y + climb : slope_ < 0.0 ? y - climb : first();
  high_corner_ = slope_ > 0.0 ? y - climb : slope_ < 0.0 ? -y + climb : first();

  const int beyond = static_cast<int>(std::ceil(climb / body.rack->pitch)) + 1;
  for (RackStrip strip : endless(body, -beyond, body.outline.teeth - 1 + beyond)) {
    strip.begin = std::max(snapped(strip.begin), first());
    strip.end = std::min(snapped(strip.end), last());
    if (strip.end - strip.begin < kNarrow_mm) {
      if (!strips_.empty() && strip.end > strips_.back().end) strips_.back().end = strip.end;
      continue;
    }
    strip.begin = strips_.empty() ? first() : strips_.back().end;
    strips_.push_back(strip);
  }
  strips_.back().end = last();
}

double RackPlan::snapped(double s) const {
  for (const double corner : corners_)
    if (std::abs(s - corner) < kNarrow_mm) return corner;
  return s;
}

Vec2 RackPlan::at(double s, double z) const {
  return {std::clamp(s + slope_ * z, -length_ / 2, length_ / 2), z};
}

// Returns the low or the high end point of a line of constant s. When s changes, this point passes
// the corner (y, z), at which s has the value `corner`. The point lies on the end face y if s is
// below `corner` and y < 0, or if s is above `corner` and y > 0. In all other cases, and always for
// a spur rack, the point lies on the side z. Corners are exact.
Vec2 RackPlan::end_of_line(double s, double z, double corner, double y) const {
  if (slope_ == 0.0) return at(s, z);
  const double top = std::copysign(width_ / 2, slope_);
  if (s == first()) return {-length_ / 2, top};
  if (s == last()) return {length_ / 2, -top};
  if (s == corner) return {y, z};
  const bool on_end = y < 0.0 ? s < corner : s > corner;
  if (!on_end) return at(s, z);
  return {y, std::clamp((y - s) / slope_, -width_ / 2, width_ / 2)};
}

Vec2 RackPlan::low(double s) const {
  return end_of_line(s, -width_ / 2, low_corner_, std::copysign(length_ / 2, -slope_));
}

Vec2 RackPlan::high(double s) const {
  return end_of_line(s, width_ / 2, high_corner_, std::copysign(length_ / 2, slope_));
}

}  // namespace gearwright
