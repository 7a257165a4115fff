// Computes the distances between the flanks of two finished outlines when these are turned against
// each other.
//
//   φ       rotation of gear 1, clockwise, rad     p   a point of one outline, mm
//   q       p in the frame of the mating gear
//   d       signed distance from q to the outline of the mating gear, mm, < 0 inside its material
//   leading    the flanks by which gear 1 pushes: y < 0 on its teeth in its own frame
//
// When p moves, d changes by at most the same distance. If d > kNear at a point, the walk along an
// outline can therefore skip the next d − kNear. If d is smaller, every sample is evaluated, and
// the minimum is refined around the smallest sample. Both outlines are walked, each past the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

#include "gearwright/pair/pair.hpp"
#include "tests/oracle/engine_curves.hpp"

namespace gearwright::property {

/// Least signed distance, mm, for each side of gear 1's teeth. A value above the reach of the walk
/// (a twentieth of a module) only means that nothing is closer than the reach.
struct Nearness {
  double leading = std::numeric_limits<double>::infinity();
  double trailing = std::numeric_limits<double>::infinity();

  double min() const { return std::min(leading, trailing); }
};

/// The outline of one gear, both as material and as a list of points to walk along.
class FinishedOutline {
 public:
  struct Place {
    const Arc* arc;
    double u;  ///< on the arc, 0 … 1
    Vec2 p;
    double s;  ///< mm from the middle of the space
  };

  /// The distance between samples is at most `step`.
  FinishedOutline(const Outline& outline, double step)
      : ring_(outline.teeth < 0), material_(std::abs(outline.teeth), oracle::curves_of(outline)) {
    for (const Arc& arc : outline.arcs) {
      constexpr int kRough = 64;
      double length = 0.0;
      for (int i = 0; i < kRough; ++i)
        length += (arc.point((i + 1.0) / kRough) - arc.point(i / (1.0 * kRough))).norm();
      const int n = 8 + static_cast<int>(length / step);
      for (int i = 0; i <= n; ++i) {
        const double u = static_cast<double>(i) / n;
        const Vec2 p = arc.point(u);
        const double s =
            places_.empty() ? 0.0 : places_.back().s + 1.01 * (p - places_.back().p).norm();
        places_.push_back({&arc, u, p, s});
      }
    }
    inner_radius_ = places_.back().p.norm();  // of a ring: nothing of it is nearer to the axis
  }

  const std::vector<Place>& places() const { return places_; }

  /// A lower bound of the signed distance that is cheap to compute.
  double lower_bound(const Vec2& q) const {
    return ring_ ? inner_radius_ - q.norm() : q.norm() - material_.outer_radius();
  }

  /// Signed distance. `start` is an index that speeds up the next search.
  double distance(const Vec2& q, std::size_t& start) const {
    const auto foot = material_.foot(q, start);
    start = foot.piece;
    return ring_ ? -foot.distance : foot.distance;
  }

 private:
  bool ring_;
  oracle::ToothedOutline material_;
  std::vector<Place> places_;
  double inner_radius_;
};

class TurnedOutlines {
 public:
  /// Domain    both gears have outlines; the axes are parallel; `pair` outlives this object
  explicit TurnedOutlines(const InvolutePair& pair)
      : pair_(pair),
        near_(0.05 * pair.gears[0].spec.normal_module),
        gears_{FinishedOutline(pair.gears[0].tooth->outline, kStep * near_),
               FinishedOutline(pair.gears[1].tooth->outline, kStep * near_)} {
    const Eigen::Matrix4d one = pair.pose_1().isometry().matrix();
    const Eigen::Matrix4d two = pair.pose_2().isometry().matrix();
    rest_ = {std::atan2(one(1, 0), one(0, 0)), std::atan2(two(1, 0), two(0, 0))};
  }

  double reach() const { return near_; }
  double step() const { return kStep * near_; }  ///< between samples, mm

  /// Least distance of all samples, without skipping.
  double min_of_all(double phi, double turn) const {
    double least = std::numeric_limits<double>::infinity();
    for_each_flank(phi, turn, [&](const Flank& flank) {
      Seen seen(*this, flank);
      Nearness nearness;
      for (const auto& place : gears_[flank.which].places()) seen.take(place.p, nearness);
      least = std::min(least, nearness.min());
    });
    return least;
  }

  /// Angle of gear 2 from the middle of the play to the contact of the leading flanks, rad.
  double to_leading() const {
    return -0.5 * pair_.mesh.backlash.rotation[1] * (pair_.gears[1].internal() ? -1.0 : 1.0);
  }

  /// The least distances after the rotation φ, with gear 2 turned by an additional angle `turn`.
  Nearness at(double phi, double turn) const {
    Nearness nearness;
    for_each_flank(phi, turn, [&](const Flank& flank) { walk(flank, nearness); });
    return nearness;
  }

 private:
  static constexpr double kStep = 0.2;  // distance between samples, relative to the reach

  struct Flank {
    int which;     ///< gear whose outline is walked
    double side;   ///< of its tooth, ±1
    double angle;  ///< of that tooth in the housing
    double mate;   ///< angle of the mating gear
  };

  template <class Visit>
  void for_each_flank(double phi, double turn, Visit visit) const {
    const auto teeth = [&](int i) { return static_cast<double>(pair_.gears[i].spec.teeth); };
    const std::array<double, 2> angle{rest_[0] - phi, rest_[1] + phi * teeth(0) / teeth(1) + turn};
    for (const int which : {0, 1}) {
      const int z = std::abs(pair_.gears[which].spec.teeth);
      for (int k = 0; k < z; ++k) {
        for (const double side : {-1.0, 1.0}) {
          visit({which, side, angle[which] + 2 * std::numbers::pi * k / z, angle[1 - which]});
        }
      }
    }
  }

  static Vec2 turned(const Vec2& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {p.x() * c - p.y() * s, p.x() * s + p.y() * c};
  }

  /// Points of a flank in the frame of its mating gear.
  struct Seen {
    const TurnedOutlines& pair;
    const Flank& flank;
    Vec2 by_turn, by_shift;  ///< q = p·by_turn + by_shift, as complex numbers
    std::size_t start = 0;

    Seen(const TurnedOutlines& all, const Flank& f) : pair(all), flank(f) {
      by_turn = turned({1.0, 0.0}, f.angle - f.mate);
      const double a = all.pair_.center_distance;
      by_shift = turned({f.which == 0 ? -a : a, 0.0}, -f.mate);
    }
    Vec2 q(const Vec2& p) const {
      const double y = flank.side * p.y();
      return {p.x() * by_turn.x() - y * by_turn.y() + by_shift.x(),
              p.x() * by_turn.y() + y * by_turn.x() + by_shift.y()};
    }
    /// Signed distance at p. It is stored for the side on which p lies.
    double take(const Vec2& p, Nearness& nearness) {
      const Vec2 at = q(p);
      const double d = pair.gears_[1 - flank.which].distance(at, start);
      double y = flank.side;
      if (flank.which == 1) {
        const double pitch = 2 * std::numbers::pi / pair.pair_.gears[0].spec.teeth;
        y = std::remainder(std::atan2(at.y(), at.x()), pitch);
      }
      double& least = y < 0.0 ? nearness.leading : nearness.trailing;
      least = std::min(least, d);
      return d;
    }
  };

  void walk(const Flank& flank, Nearness& nearness) const {
    const auto& places = gears_[flank.which].places();
    Seen seen(*this, flank);
    std::vector<std::size_t> visited;
    std::vector<double> d;
    for (std::size_t i = 0; i < places.size();) {
      double here = gears_[1 - flank.which].lower_bound(seen.q(places[i].p));
      if (here < near_) here = seen.take(places[i].p, nearness);
      visited.push_back(i);
      d.push_back(here);
      const double to = places[i].s + here - near_;
      do ++i;
      while (i < places.size() && places[i].s < to);
    }
    for (std::size_t k = 0; k < d.size(); ++k) {
      if (d[k] >= near_) continue;
      if ((k > 0 && d[k - 1] < d[k]) || (k + 1 < d.size() && d[k + 1] < d[k])) continue;
      search(seen, places, visited[k], nearness);
    }
  }

  /// Golden section between the neighbours of the smallest sample, on the same arc.
  void search(Seen& seen, const std::vector<FinishedOutline::Place>& places, std::size_t i,
              Nearness& nearness) const {
    const Arc& arc = *places[i].arc;
    const auto on_arc = [&](std::size_t k) { return places[k].arc == &arc; };
    double lo = i > 0 && on_arc(i - 1) ? places[i - 1].u : places[i].u;
    double hi = i + 1 < places.size() && on_arc(i + 1) ? places[i + 1].u : places[i].u;
    constexpr double kGolden = 0.6180339887498949;
    double u = hi - kGolden * (hi - lo), v = lo + kGolden * (hi - lo);
    double d_u = seen.take(arc.point(u), nearness), d_v = seen.take(arc.point(v), nearness);
    for (int k = 0; k < 45; ++k) {
      if (d_u < d_v) {
        hi = v, v = u, d_v = d_u;
        u = hi - kGolden * (hi - lo);
        d_u = seen.take(arc.point(u), nearness);
      } else {
        lo = u, u = v, d_u = d_v;
        v = lo + kGolden * (hi - lo);
        d_v = seen.take(arc.point(v), nearness);
      }
    }
  }

  const InvolutePair& pair_;
  double near_;
  std::array<FinishedOutline, 2> gears_;
  std::array<double, 2> rest_;
};

}  // namespace gearwright::property
