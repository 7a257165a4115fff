#include "gearwright/cad/flat_cap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a;
  const Vec2 ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

// Returns the quality of a triangle, which is the sine of its smallest angle. This is twice the
// area divided by the product of the two longest sides.
double width(const Vec2& a, const Vec2& b, const Vec2& c) {
  std::array<double, 3> side{(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  std::sort(side.begin(), side.end());
  return turn(a, b, c) / std::sqrt(side[1] * side[2]);
}

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& polygon)
      : points_(polygon),
        next_(polygon.size()),
        previous_(polygon.size()),
        quality_(polygon.size(), kNoEar) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i) rate(i);
  }

  std::optional<std::vector<Triangle>> run() {
    std::vector<Triangle> triangles;
    for (std::size_t left = points_.size(); left > 2; --left) {
      std::size_t best = best_ear();
      if (quality_[best] == kNoEar) {
        // If three corners are collinear, even a corner that is not next to the removed ear can
        // become an ear.
        for (std::size_t i = next_[last_], k = 0; k < left; i = next_[i], ++k) rate(i);
        best = best_ear();
        if (quality_[best] == kNoEar) return std::nullopt;
      }
      const std::size_t before = previous_[best];
      const std::size_t after = next_[best];
      triangles.push_back({static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(best),
                           static_cast<std::uint32_t>(after)});
      next_[before] = after;
      previous_[after] = before;
      quality_[best] = kNoEar;
      last_ = before;
      rate(before);
      rate(after);
    }
    return triangles;
  }

 private:
  static constexpr double kNoEar = 0.0;

  std::size_t best_ear() const {
    return static_cast<std::size_t>(std::max_element(quality_.begin(), quality_.end()) -
                                    quality_.begin());
  }

  void rate(std::size_t i) {
    const std::size_t before = previous_[i];
    const std::size_t after = next_[i];
    const Vec2& a = points_[before];
    const Vec2& b = points_[i];
    const Vec2& c = points_[after];
    quality_[i] = kNoEar;
    if (turn(a, b, c) <= 0.0) return;
    for (std::size_t k = next_[after]; k != before; k = next_[k]) {
      const Vec2& p = points_[k];
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return;
    }
    quality_[i] = width(a, b, c);
  }

  const std::vector<Vec2>& points_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<double> quality_;
  std::size_t last_ = 0;  // a corner that still remains
};

double polar(const Vec2& p) { return std::atan2(p.y(), p.x()); }

// Returns the angle measured from `from`, in [0, 2π).
double ahead(double angle, double from) {
  const double difference = std::remainder(angle - from, 2.0 * std::numbers::pi);
  return difference < 0.0 ? difference + 2.0 * std::numbers::pi : difference;
}

}  // namespace

std::optional<std::vector<Triangle>> clip_ears(const std::vector<Vec2>& polygon) {
  GW_EXPECTS(polygon.size() >= 3);
  return EarClipper(polygon).run();
}

std::vector<Triangle> zip_ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer) {
  const std::size_t n = inner.size();
  const std::size_t m = outer.size();
  GW_EXPECTS(n >= 3 && m >= 3);

  // The first triangle begins at the outer corner with the polar angle of the first inner point. If
  // there is no such corner, it begins at the next corner with a smaller polar angle. All angles
  // are measured from this corner.
  const double start = polar(inner[0]);
  std::size_t first = 0;
  for (std::size_t j = 1; j < m; ++j) {
    if (ahead(start, polar(outer[j])) < ahead(start, polar(outer[first]))) first = j;
  }
  const double origin = polar(outer[first]);
  const auto inner_angle = [&](std::size_t i) {
    return ahead(polar(inner[i % n]), origin) + (i < n ? 0.0 : 2.0 * std::numbers::pi);
  };
  const auto outer_angle = [&](std::size_t j) {
    return 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(m);
  };

  std::vector<Triangle> triangles;
  triangles.reserve(n + m);
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < n || j < m) {
    const Vec2& a = inner[i % n];
    const Vec2& b = outer[(first + j) % m];
    const Vec2& a_next = inner[(i + 1) % n];
    const Vec2& b_next = outer[(first + j + 1) % m];
    const auto id_a = static_cast<std::uint32_t>(i % n);
    const auto id_b = static_cast<std::uint32_t>(n + (first + j) % m);
    const bool inner_turn = i < n && (j == m || inner_angle(i + 1) <= outer_angle(j + 1));
    if (inner_turn && (j == m || turn(a, b, a_next) > 0.0)) {
      GW_EXPECTS(turn(a, b, a_next) > 0.0);
      triangles.push_back({id_a, id_b, static_cast<std::uint32_t>((i + 1) % n)});
      ++i;
    } else {
      GW_EXPECTS(turn(a, b, b_next) > 0.0);
      triangles.push_back({id_a, id_b, static_cast<std::uint32_t>(n + (first + j + 1) % m)});
      ++j;
    }
  }
  return triangles;
}

}  // namespace gearwright
