#include "tests/oracle/plane_mesh.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace gearwright::oracle {

namespace {

using Complex = std::complex<double>;

// The shortest element at a load, relative to the half width of the load.
constexpr double kLength = 0.25;
constexpr double kGrowth = 0.22;  // growth of the element size per length, away from a load
// Element sizes relative to half the tooth height: at the root of a loaded tooth, the first of the
// body, and all others.
constexpr double kRoot = 0.035, kCrown = 0.08, kLong = 0.3;

// The outline as a function of its length from the middle of the space.
class Outline {
 public:
  explicit Outline(const PlaneGear& g) : points_(g.outline), to_{0.0} {
    for (std::size_t i = 1; i < points_.size(); ++i)
      to_.push_back(to_.back() + std::abs(points_[i] - points_[i - 1]));
    flank_ = to_[g.root_points];
  }
  double length() const { return to_.back(); }
  double flank() const { return flank_; }
  Complex at(double l) const {
    const auto i =
        std::clamp<std::ptrdiff_t>(std::upper_bound(to_.begin(), to_.end(), l) - to_.begin() - 1, 0,
                                   static_cast<std::ptrdiff_t>(to_.size()) - 2);
    return points_[i] + (l - to_[i]) / (to_[i + 1] - to_[i]) * (points_[i + 1] - points_[i]);
  }
  double at_radius(double r, bool ring) const {
    double lo = flank_;
    double hi = length();
    for (int i = 0; i < 60; ++i) {
      const double mid = 0.5 * (lo + hi);
      ((std::abs(at(mid)) < r) != ring ? lo : hi) = mid;
    }
    return lo;
  }
  // The normal that points into the tooth. The centre line of the tooth is y = 0.
  Complex inward(double l) const {
    constexpr double kStep = 0.004;  // relative to the length; much greater than the distance of
                                     // the points
    const Complex d = at(l + kStep * length()) - at(l - kStep * length());
    const Complex normal = d / std::abs(d) * Complex(0, 1);
    return normal.imag() > 0.0 ? -normal : normal;
  }

 private:
  std::vector<Complex> points_;
  std::vector<double> to_;
  double flank_ = 0.0;
};

// Points from `from` to `to`: ends and middles of elements whose length is approximately `size`.
std::vector<double> places(double from, double to, const std::function<double(double)>& size) {
  constexpr int kSteps = 4000;
  std::vector<double> count{0.0};
  const auto at = [&](double i) { return from + (to - from) * i / kSteps; };
  for (int i = 0; i < kSteps; ++i)
    count.push_back(count.back() + std::abs(to - from) / kSteps / size(at(i + 0.5)));
  const int n = std::max(1, static_cast<int>(std::ceil(count.back())));
  std::vector<double> ends{from};
  int i = 0;
  for (int e = 1; e < n; ++e) {
    const double want = count.back() * e / n;
    while (count[i + 1] < want) ++i;
    ends.push_back(at(i + (want - count[i]) / (count[i + 1] - count[i])));
  }
  ends.push_back(to);
  std::vector<double> all{from};
  for (std::size_t k = 1; k < ends.size(); ++k) {
    all.push_back(0.5 * (ends[k - 1] + ends[k]));
    all.push_back(ends[k]);
  }
  return all;
}

class Builder {
 public:
  Builder(const PlaneGear& gear, const std::vector<PlaneLoad>& loads, double fineness)
      : gear_(gear), outline_(gear), loads_(loads), fineness_(fineness) {}
  PlaneMesh build();

 private:
  Complex turn(int tooth) const {
    return std::polar(1.0, 2 * std::numbers::pi * tooth / gear_.teeth);
  }
  double half_height() const {
    return std::abs(outline_.at(outline_.length()) - outline_.at(0.0)) / 2;
  }
  int add(const Complex& w) {
    mesh_.nodes.push_back(w);
    return static_cast<int>(mesh_.nodes.size()) - 1;
  }
  std::vector<int> build_tooth(int k, const std::vector<int>& first);
  std::vector<int> build_ray(const Complex& top);
  void cut(const std::vector<std::vector<int>>& grid);
  void triangle(std::array<int, 6> t);

  const PlaneGear& gear_;
  Outline outline_;
  const std::vector<PlaneLoad>& loads_;
  double fineness_;
  std::vector<double> depth_;  // depths of the nodes on a ray, 0 … 1
  PlaneMesh mesh_;
};

void Builder::triangle(std::array<int, 6> t) {
  const Complex a = mesh_.nodes[t[1]] - mesh_.nodes[t[0]];
  const Complex b = mesh_.nodes[t[2]] - mesh_.nodes[t[0]];
  if ((std::conj(a) * b).imag() < 0.0) t = {t[0], t[2], t[1], t[5], t[4], t[3]};
  mesh_.triangles.push_back(t);
}

void Builder::cut(const std::vector<std::vector<int>>& g) {
  for (std::size_t i = 0; i + 2 < g.size(); i += 2) {
    for (std::size_t j = 0; j + 2 < g[i].size(); j += 2) {
      triangle(
          {g[i][j], g[i + 2][j], g[i + 2][j + 2], g[i + 1][j], g[i + 2][j + 1], g[i + 1][j + 1]});
      triangle(
          {g[i][j], g[i + 2][j + 2], g[i][j + 2], g[i + 1][j + 1], g[i + 1][j + 2], g[i][j + 1]});
    }
  }
}

// The nodes below a point of the top row, down to the circle at which the body is fixed.
std::vector<int> Builder::build_ray(const Complex& top) {
  const Complex foot = std::polar(gear_.held, std::arg(top));
  std::vector<int> ray;
  for (const double d : depth_) ray.push_back(add(top * (1 - d) + foot * d));
  mesh_.held.push_back(ray.back());
  return ray;
}

// Makes tooth k and the body below it, starting at the existing ray `first`. Returns the last ray.
std::vector<int> Builder::build_tooth(int k, const std::vector<int>& first) {
  const double unit = half_height();
  double at = -1.0;
  double half = 0.0;
  for (const PlaneLoad& load : loads_)
    if (load.tooth == k) {
      at = outline_.at_radius(load.radius, gear_.ring);
      half = load.half_width;
    }
  const double length = outline_.length();
  const double least = half * kLength;
  const auto along = [&](double l) {
    const double most = unit * (at >= 0.0 && l < outline_.flank() ? kRoot : kLong);
    return std::min(most, at < 0.0 ? most : least + kGrowth * std::abs(l - at)) / fineness_;
  };
  PlaneTooth tooth;
  tooth.loaded = at;
  if (at < 0.0) {
    tooth.place = places(0.0, length, along);
  } else {
    tooth.place = places(0.0, at, along);
    const auto beyond = places(at, length, along);
    tooth.place.insert(tooth.place.end(), beyond.begin() + 1, beyond.end());
  }
  const double out = gear_.ring ? -1.0 : 1.0;
  const double root = std::abs(outline_.at(0.0));
  const double foot = root - out * std::min(unit, 0.5 * std::abs(root - gear_.held));
  const double tip = std::abs(outline_.at(length));
  const auto across = [&](double s) {
    const double most = kLong / 2;
    return std::min(most, at < 0.0 ? most : least / unit + kGrowth * (1 - s)) / fineness_;
  };
  const std::vector<double> rung = places(-1.0, 1.0, across);
  std::vector<std::vector<int>> rays;
  std::vector<std::vector<int>> rows;
  for (std::size_t i = 0; i < tooth.place.size(); ++i) {
    const Complex side = outline_.at(tooth.place[i]);
    const double middle = foot + (tip - foot) * tooth.place[i] / length;
    std::vector<int> row;
    for (std::size_t j = 0; j < rung.size(); ++j) {
      const double s = rung[j];
      const Complex w = turn(k) * Complex(middle + (side.real() - middle) * s * s, side.imag() * s);
      if (i > 0) {
        row.push_back(add(w));
      } else {
        rays.push_back(j == 0 ? first : build_ray(w));
        row.push_back(rays.back().front());
      }
    }
    tooth.node.push_back(row.back());
    rows.push_back(row);
  }
  cut(rows);
  cut(rays);
  tooth.root_nodes = static_cast<std::size_t>(
      std::lower_bound(tooth.place.begin(), tooth.place.end(), outline_.flank()) -
      tooth.place.begin());
  if (at >= 0.0) tooth.normal = outline_.inward(at) * turn(k);
  mesh_.teeth[k] = tooth;
  return rays.back();
}

PlaneMesh Builder::build() {
  const double root = std::abs(outline_.at(0.0));
  const double unit = half_height();
  const double deep = std::abs(root - gear_.held);
  depth_ =
      places(0.0, 1.0, [&](double d) { return (kCrown * unit / deep + 0.25 * d) / fineness_; });
  const std::vector<int> begin =
      build_ray(outline_.at(0.0) * std::conj(turn(gear_.real_teeth + 1)));
  std::vector<int> last = begin;
  for (int k = -gear_.real_teeth; k <= gear_.real_teeth; ++k) last = build_tooth(k, last);
  const double pi = std::numbers::pi;
  const double from = pi * (2 * gear_.real_teeth + 1) / gear_.teeth;
  const auto around = [&](double f) {
    return std::min(0.2, unit / root + 0.3 * std::min(f - from, 2 * pi - from - f)) / fineness_;
  };
  const std::vector<double> angles = places(from, 2 * pi - from, around);
  std::vector<std::vector<int>> rays{last};
  for (std::size_t i = 1; i + 1 < angles.size(); ++i)
    rays.push_back(build_ray(std::polar(root, angles[i])));
  rays.push_back(begin);
  cut(rays);
  return mesh_;
}

}  // namespace

PlaneMesh plane_mesh(const PlaneGear& gear, const std::vector<PlaneLoad>& loads, double fineness) {
  return Builder(gear, loads, fineness).build();
}

}  // namespace gearwright::oracle
