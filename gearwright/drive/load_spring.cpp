#include "gearwright/drive/load_spring.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright::detail {

namespace {

constexpr double kSteepest = 3.0;  // greatest slope, relative to the secant; a steeper curve might
                                   // fall

}  // namespace

LoadSpring LoadSpring::linear(double stiffness) {
  return LoadSpring(std::vector<SpringNode>{{1.0, stiffness, stiffness}});
}

LoadSpring::LoadSpring(std::vector<SpringNode> nodes) {
  std::sort(nodes.begin(), nodes.end(),
            [](const SpringNode& a, const SpringNode& b) { return a.force < b.force; });
  nodes_.push_back({0.0, 0.0, 0.0});
  for (const SpringNode& node : nodes)
    if (node.approach > nodes_.back().approach && node.force > nodes_.back().force)
      nodes_.push_back(node);
  GW_EXPECTS(nodes_.size() > 1);
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    SpringNode &a = nodes_[i - 1], &b = nodes_[i];
    const double secant = (b.force - a.force) / (b.approach - a.approach);
    if (i == 1) a.slope = std::clamp(2 * secant - b.slope, 0.0, kSteepest * secant);
    a.slope = std::clamp(a.slope, 0.0, kSteepest * secant);
    b.slope = std::clamp(b.slope, 0.0, kSteepest * secant);
  }
  GW_EXPECTS(nodes_.back().slope > 0.0);
}

LoadSpring::Value LoadSpring::at(double approach) const {
  if (!(approach > 0.0)) return {};
  const SpringNode& last = nodes_.back();
  if (approach >= last.approach)
    return {last.force + last.slope * (approach - last.approach), last.slope};
  const auto above =
      std::upper_bound(nodes_.begin(), nodes_.end(), approach,
                       [](double x, const SpringNode& node) { return x < node.approach; });
  const SpringNode &b = *above, &a = *(above - 1);
  const double h = b.approach - a.approach;
  const double t = (approach - a.approach) / h, s = 1 - t;
  const double secant = (b.force - a.force) / h;
  return {a.force * s * s * (1 + 2 * t) + b.force * t * t * (1 + 2 * s) +
              h * t * s * (s * a.slope - t * b.slope),
          6 * t * s * secant + s * (s - 2 * t) * a.slope + t * (t - 2 * s) * b.slope};
}

double LoadSpring::approach(double force) const {
  GW_EXPECTS(force >= 0.0);
  const SpringNode& last = nodes_.back();
  if (force >= last.force) return last.approach + (force - last.force) / last.slope;
  const auto above =
      std::upper_bound(nodes_.begin(), nodes_.end(), force,
                       [](double f, const SpringNode& node) { return f < node.force; });
  const double lo = (above - 1)->approach, hi = above->approach;
  if (force == (above - 1)->force) return lo;
  const double start =
      lo + (hi - lo) * (force - (above - 1)->force) / (above->force - (above - 1)->force);
  const auto excess = [&](double x) {
    const Value value = at(x);
    return Slope<double>{value.force - force, value.slope};
  };
  return newton_in_bracket(excess, lo, hi, start, true).x;
}

}  // namespace gearwright::detail
