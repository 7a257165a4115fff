#include "gearwright/cad/testing/outline_distance.hpp"

#include <algorithm>
#include <cmath>

namespace gearwright::testing {

namespace {

constexpr int kSteps = 400;

}  // namespace

OutlineDistance::OutlineDistance(const Outline& outline) : outline_(outline) {
  for (const Arc& arc : outline_.arcs) {
    samples_.push_back(sample(arc, kSteps + 1));
    const std::vector<Vec2>& p = samples_.back();
    for (std::size_t k = 1; k < p.size(); ++k) gap_ = std::max(gap_, (p[k] - p[k - 1]).norm());
  }
}

double OutlineDistance::operator()(Vec2 q) const {
  q.y() = std::abs(q.y());
  struct Nearest {
    double distance;
    std::size_t arc, sample;
  };
  std::vector<Nearest> nearest;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t k = 0; k < samples_[i].size(); ++k) {
      const double here = (samples_[i][k] - q).squaredNorm();
      if (here < least) {
        least = here;
        best = k;
      }
    }
    nearest.push_back({std::sqrt(least), i, best});
  }
  double found = 1e300;
  for (const Nearest& n : nearest) found = std::min(found, n.distance);
  for (const Nearest& n : nearest) {
    if (n.distance - gap_ <= found) found = std::min(found, refined(n.arc, n.sample, q));
  }
  return found;
}

double OutlineDistance::refined(std::size_t arc, std::size_t sample, const Vec2& q) const {
  const auto distance = [&](double u) { return (outline_.arcs[arc].point(u) - q).norm(); };
  double lo = std::max(0.0, (static_cast<double>(sample) - 1.0) / kSteps);
  double hi = std::min(1.0, (static_cast<double>(sample) + 1.0) / kSteps);
  for (int k = 0; k < 45; ++k) {
    const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
    if (distance(a) < distance(b)) {
      hi = b;
    } else {
      lo = a;
    }
  }
  return distance(0.5 * (lo + hi));
}

}  // namespace gearwright::testing
