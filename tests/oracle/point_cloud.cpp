#include "tests/oracle/point_cloud.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle::tca {
namespace {

constexpr Real kNothing = -std::numeric_limits<Real>::infinity();
constexpr Real kInverseGolden = 0.618033988749894848204586834365638118L;

// Relative to the flank. A maximum that is nearer to a bound than this counts as lying on the
// bound. Bounds are met to 1e-15, and a smooth peak is located to 1e-9 of its radius of curvature.
constexpr Real kOnBound = 1e-7L;
// If the values of neighbouring sections differ by less than this, they do not form a peak. It is a
// hundred rounding errors of an angle of one turn.
constexpr Real kFlat = 1e-16L;

/// A point of flank 1 and its distance to each bound.
struct Look {
  Real rho_1 = 0, z_1 = 0;
  Vector3 point_f;
  Real x_2 = 0, y_2 = 0, rho_2 = 0, z_2 = 0;
  Real slack = kNothing;  ///< distance to the nearest bound, not counting those of flank 1; < 0 if
                          ///< the point is not admitted
};

/// One tooth pair at one rotation.
class Cloud {
 public:
  Cloud(const CloudPair& pair, Real rotation_1, CloudSteps steps)
      : pair_(pair),
        rotation_1_(rotation_1),
        expected_(rotation_1 * pair.teeth_1 / pair.teeth_2),
        frame_1_(frame_1(pair.mounting, 0)),
        frame_2_(frame_2(pair.mounting, 0)),
        sections_(steps.sections) {
    const CloudFlank& f = pair.flank_1;
    for (int i = 0; i <= steps.radii; ++i) {
      const Real rho = f.rho_low + (f.rho_high - f.rho_low) * i / steps.radii;
      radii_.push_back({rho, f.azimuth(rho)});
    }
  }

  struct Best {
    Real value = kNothing, at = 0;
  };

  /// The greatest φ_2* in one section.
  Best in_section(Real z) const {
    Best best;
    const auto take = [&best](Real rho, Real value) {
      if (value > best.value) best = {value, rho};
    };
    const auto value = [&](Real rho) { return demanded(look(rho, z)); };
    for (const std::vector<Real>& interval : admitted(z)) {
      std::vector<Real> values;
      for (const Real rho : interval) {
        values.push_back(value(rho));
        take(rho, values.back());
      }
      for (std::size_t i = 1; i + 1 < interval.size(); ++i) {
        if (values[i] < std::max(values[i - 1], values[i + 1])) continue;
        const auto [rho, negative] = boost::math::tools::brent_find_minima(
            [&](Real x) { return -value(x); }, interval[i - 1], interval[i + 1], 32);
        take(rho, -negative);
      }
    }
    return best;
  }

  /// The z of the greatest φ_2* of all sections, and its position in that section.
  std::optional<std::pair<Real, Best>> in_all() const {
    const auto range = admitted_sections();
    if (!range) return std::nullopt;
    const auto [low, high] = *range;
    const auto section = [&, low = low, high = high](int j) {
      return low + (high - low) * j / sections_;
    };
    std::vector<Real> values;
    for (int j = 0; j <= sections_; ++j) values.push_back(in_section(section(j)).value);
    const auto top = std::max_element(values.begin(), values.end());
    if (*top == kNothing) return std::nullopt;

    const auto at = [&](int j) { return j < 0 || j > sections_ ? kNothing : values[j]; };
    Real z_best = section(static_cast<int>(top - values.begin()));
    Best best = in_section(z_best);
    for (int j = 0; j <= sections_; ++j) {
      const bool min_below = values[j] > std::min(at(j - 1), at(j + 1)) + kFlat;
      if (values[j] == kNothing || values[j] < std::max(at(j - 1), at(j + 1))) continue;
      if (!min_below && &values[j] != &*top) continue;
      climb(section(std::max(j - 1, 0)), section(j), section(std::min(j + 1, sections_)), best,
            z_best);
    }
    return std::pair{z_best, best};
  }

  Look look(Real rho, Real z) const { return look(rho, pair_.flank_1.azimuth(rho), z); }

  /// φ_2*, for this pair's teeth as if they were pair 0.
  Real demanded(const Look& p) const {
    const CloudFlank& f = pair_.flank_2;
    const Real rho = std::clamp(p.rho_2, f.rho_low, f.rho_high);
    const Real back = f.azimuth(rho) + f.turn(p.z_2) + expected_;
    const Real c = std::cos(back), s = std::sin(back);
    return expected_ + std::atan2(p.y_2 * c - p.x_2 * s, p.x_2 * c + p.y_2 * s);
  }

  /// The bounds on which the position lies.
  CloudKind kind(const Look& p) const {
    const CloudFlank &one = pair_.flank_1, &two = pair_.flank_2;
    const Real height = kOnBound * (one.rho_high - one.rho_low);
    const Real width = kOnBound * (one.z_high - one.z_low);
    const bool faces_1 = std::min(p.z_1 - one.z_low, one.z_high - p.z_1) <= width;
    const bool faces_2 = std::min(p.z_2 - two.z_low, two.z_high - p.z_2) <= width;
    const bool one_plane = faces_1 && faces_2 && std::abs(axis_1().dot(axis_2())) == 1;
    CloudKind found = CloudKind::interior;
    const auto bound = [&found](bool on, CloudKind kind) {
      if (on) found = found == CloudKind::interior ? kind : CloudKind::corner;
    };
    bound(p.rho_1 - one.rho_low <= height, CloudKind::root_1);
    bound(one.rho_high - p.rho_1 <= height, CloudKind::tip_1);
    bound(faces_1, CloudKind::face_1);
    bound(p.rho_2 - two.rho_low <= height, CloudKind::root_2);
    bound(two.rho_high - p.rho_2 <= height, CloudKind::tip_2);
    bound(faces_2 && !one_plane, CloudKind::face_2);
    bound(to_half_turn(p.rho_1, p.z_1) <= kOnBound * p.rho_1, CloudKind::half_turn);
    return found;
  }

 private:
  struct Radius {
    Real rho, azimuth;
  };

  Vector3 axis_1() const { return frame_1_.turn.col(2); }
  Vector3 axis_2() const { return frame_2_.turn.col(2); }

  Real to_half_turn(Real rho, Real z) const {
    const Real psi = pair_.flank_1.azimuth(rho) + pair_.flank_1.turn(z) - rotation_1_;
    return (kLongPi - std::abs(psi)) * rho;
  }

  Look look(Real rho, Real azimuth, Real z) const {
    const CloudFlank& f = pair_.flank_2;
    const Real psi = azimuth + pair_.flank_1.turn(z) - rotation_1_;
    Look p;
    p.rho_1 = rho, p.z_1 = z;
    p.point_f =
        frame_1_.turn * Vector3(rho * std::cos(psi), rho * std::sin(psi), z) + frame_1_.shift;
    const Vector3 seen = frame_2_.turn.transpose() * (p.point_f - frame_2_.shift);
    p.x_2 = seen.x(), p.y_2 = seen.y(), p.z_2 = seen.z();
    p.rho_2 = std::hypot(p.x_2, p.y_2);
    p.slack = std::min({p.rho_2 - f.rho_low, f.rho_high - p.rho_2, p.z_2 - f.z_low,
                        f.z_high - p.z_2, (kLongPi - std::abs(psi)) * rho});
    return p;
  }

  /// The end of the admitted part, between a radius that is admitted and one that is not.
  Real end_between(Real inside, Real outside, Real z) const {
    const auto slack = [&](Real rho) { return look(rho, z).slack; };
    const Real slack_in = slack(inside), slack_out = slack(outside);
    if (slack_in == 0) return inside;
    const bool grows = inside < outside;
    std::uintmax_t steps = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(
        slack, grows ? inside : outside, grows ? outside : inside, grows ? slack_in : slack_out,
        grows ? slack_out : slack_in, boost::math::tools::eps_tolerance<Real>(), steps);
    return grows ? a : b;
  }

  /// The admitted intervals of a section. Each is given by its ends and by the radii in between.
  std::vector<std::vector<Real>> admitted(Real z) const {
    std::vector<Real> slack;
    for (const Radius& r : radii_) slack.push_back(look(r.rho, r.azimuth, z).slack);
    std::vector<std::vector<Real>> found;
    for (std::size_t i = 0; i < radii_.size(); ++i) {
      if (slack[i] < 0) continue;
      if (i == 0 || slack[i - 1] < 0) {
        found.emplace_back();
        if (i > 0) found.back().push_back(end_between(radii_[i].rho, radii_[i - 1].rho, z));
      }
      found.back().push_back(radii_[i].rho);
      if (i + 1 < radii_.size() && slack[i + 1] < 0) {
        found.back().push_back(end_between(radii_[i].rho, radii_[i + 1].rho, z));
      }
    }
    if (!found.empty()) return found;

    // An admitted part may be smaller than a step. It is searched for around the radius that is
    // nearest to being admitted.
    const auto nearest = std::max_element(slack.begin(), slack.end()) - slack.begin();
    const Real low = radii_[std::max<std::ptrdiff_t>(nearest - 1, 0)].rho;
    const Real high = radii_[std::min<std::size_t>(nearest + 1, radii_.size() - 1)].rho;
    const Real step = (high - low) / 2;
    if (slack[nearest] < -step * 4) return found;
    const Real rho = boost::math::tools::brent_find_minima(
                         [&](Real x) { return -look(x, z).slack; }, low, high, 32)
                         .first;
    if (look(rho, z).slack < 0) return found;
    return {{look(low, z).slack < 0 ? end_between(rho, low, z) : low, rho,
             look(high, z).slack < 0 ? end_between(rho, high, z) : high}};
  }

  /// The sections with an admitted point, and one more step on each side.
  std::optional<std::pair<Real, Real>> admitted_sections() const {
    const CloudFlank& f = pair_.flank_1;
    const int steps = 2 * sections_;
    const auto section = [&](int j) { return f.z_low + (f.z_high - f.z_low) * j / steps; };
    int first = -1, last = -1;
    for (int j = 0; j <= steps; ++j) {
      if (admitted(section(j)).empty()) continue;
      if (first < 0) first = j;
      last = j;
    }
    if (first < 0) return std::nullopt;
    return std::pair{section(std::max(first - 1, 0)), section(std::min(last + 1, steps))};
  }

  /// Golden section around a peak at `middle`. If neither probe finds a point, the search continues
  /// towards the best point so far.
  void climb(Real low, Real middle, Real high, Best& best, Real& z_best) const {
    Real top = in_section(middle).value, z_top = middle;
    const auto probe = [&](Real z) {
      const Best here = in_section(z);
      if (here.value > top) top = here.value, z_top = z;
      if (here.value > best.value) best = here, z_best = z;
      return here.value;
    };
    probe(low), probe(high);
    Real a = high - kInverseGolden * (high - low), b = low + kInverseGolden * (high - low);
    Real f_a = probe(a), f_b = probe(b);
    // 0.618^85 = 2e-18 of the bracket, so a bound is met as accurately as possible. On a smooth
    // peak, the values become indistinguishable earlier, at 1e-9 of the face.
    const Real narrow = 1e-9L * (pair_.flank_1.z_high - pair_.flank_1.z_low);
    for (int i = 0; i < 85; ++i) {
      if (high - low < narrow && std::abs(f_a - f_b) < kFlat / 1000) break;
      const bool none = f_a == kNothing && f_b == kNothing;
      if (none ? z_top < (a + b) / 2 : f_a > f_b) {
        high = b, b = a, f_b = f_a;
        a = high - kInverseGolden * (high - low), f_a = probe(a);
      } else {
        low = a, a = b, f_a = f_b;
        b = low + kInverseGolden * (high - low), f_b = probe(b);
      }
    }
  }

  const CloudPair& pair_;
  Real rotation_1_, expected_;
  Frame frame_1_, frame_2_;
  int sections_;
  std::vector<Radius> radii_;
};

}  // namespace

std::optional<CloudTouch> cloud_touch_of_pair(const CloudPair& pair, Real rotation_1, int k,
                                              CloudSteps steps) {
  const Cloud cloud(pair, rotation_1 - 2 * kLongPi * k / pair.teeth_1, steps);
  const auto found = cloud.in_all();
  if (!found) return std::nullopt;
  const Look place = cloud.look(found->second.at, found->first);
  CloudTouch touch;
  touch.rotation_2 = found->second.value + 2 * kLongPi * k / pair.teeth_2;
  touch.pair = k;
  touch.kind = cloud.kind(place);
  touch.rho_1 = place.rho_1, touch.z_1 = place.z_1;
  touch.rho_2 = place.rho_2, touch.z_2 = place.z_2;
  touch.point_f = place.point_f;
  return touch;
}

std::vector<CloudTouch> cloud_touches(const CloudPair& pair, Real rotation_1, CloudSteps steps) {
  const CloudFlank& f = pair.flank_1;
  // An admitted point is nearer to axis 2 than ρ_high of flank 2, so x_f ≥ C − ρ_2. Before the
  // errors tilt and shift it, x is ρ cos ψ.
  const Mounting& m = pair.mounting;
  const Real tilt =
      std::abs(std::sin(m.intersecting)) * std::max(std::abs(f.z_low), std::abs(f.z_high));
  const Real near = m.center_distance + m.d_center - pair.flank_2.rho_high - tilt;
  const Real opening =
      std::acos(std::clamp<Real>(near / f.rho_high, -1, 1)) + std::abs(m.intersecting);
  Real low = std::numeric_limits<Real>::infinity(), high = -low;
  for (int i = 0; i <= 64; ++i) {
    const Real theta = f.azimuth(f.rho_low + (f.rho_high - f.rho_low) * i / 64);
    for (int j = 0; j <= 64; ++j) {
      const Real psi = theta + f.turn(f.z_low + (f.z_high - f.z_low) * j / 64) - rotation_1;
      low = std::min(low, psi), high = std::max(high, psi);
    }
  }
  // psi + 2πk/N within ±opening for some point, and one more pair as a margin for the grid.
  const Real pitch = 2 * kLongPi / pair.teeth_1;
  const int first = static_cast<int>(std::ceil((-opening - high) / pitch)) - 1;
  const int last = static_cast<int>(std::floor((opening - low) / pitch)) + 1;
  std::vector<CloudTouch> found;
  for (int k = first; k <= last; ++k) {
    if (auto touch = cloud_touch_of_pair(pair, rotation_1, k, steps)) found.push_back(*touch);
  }
  return found;
}

std::optional<CloudTouch> cloud_touch(const CloudPair& pair, Real rotation_1, CloudSteps steps) {
  const auto all = cloud_touches(pair, rotation_1, steps);
  const auto best = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.rotation_2 < b.rotation_2;
  });
  if (best == all.end()) return std::nullopt;
  return *best;
}

}  // namespace gearwright::oracle::tca
