#include "tests/oracle/flank_search.hpp"

#include <algorithm>
#include <numbers>

namespace gearwright::oracle {

using Eigen::Vector3d;

Flank::Flank(const ScrewPair& p, double rotation_1, int sigma, int tooth)
    : pair_(p),
      sigma_(sigma),
      k_1_(turn_per_length(p.first)),
      k_2_(turn_per_length(p.second)),
      start_1_(azimuth_1(p, rotation_1, tooth) +
               sigma * p.first.base_thickness / (2 * p.first.base_radius)),
      start_2_(sigma * p.second.base_thickness / (2 * p.second.base_radius) -
               std::numbers::pi * (2 * tooth + sigma) / p.second.teeth),
      cos_(std::cos(p.shaft_angle)),
      sin_(std::sin(p.shaft_angle)),
      low_1_(roll_at(p.first, p.center_distance - p.second.tip_radius)),
      tip_1_(roll_at(p.first, p.first.tip_radius)),
      tip_2_(roll_at(p.second, p.second.tip_radius)) {}

double Flank::mate_roll(double u, double z) const {
  const Vector3d q = seen(u, z);
  return roll_at(pair_.second, std::hypot(q.x(), q.y()));
}

double Flank::value(double u, double z) const {
  const Vector3d q = seen(u, z);
  const double r_b = pair_.second.base_radius;
  const double square = (q.x() * q.x() + q.y() * q.y()) / (r_b * r_b) - 1;
  if (square < 0 || square > tip_2_ * tip_2_) return kNone;
  // Azimuths are measured from −x. No point lies behind axis 2, because its tip radius is less than
  // a.
  const double point = std::atan2(-q.y(), -q.x());
  const double flank = start_2_ - sigma_ * fallen_back(std::sqrt(square)) + k_2_ * q.z();
  return -sigma_ * (point - flank);
}

std::array<double, 2> Flank::sections_within(double opening, double reach) const {
  const double one = start_1_ - sigma_ * fallen_back(low_1_);
  const double tip = start_1_ - sigma_ * fallen_back(tip_1_);
  const double low = std::min(one, tip), high = std::max(one, tip);
  if (k_1_ == 0.0) {
    const bool is_near = low <= opening && high >= -opening;
    return {is_near ? -reach : 1.0, is_near ? reach : -1.0};
  }
  const double a = (-opening - high) / k_1_, b = (opening - low) / k_1_;
  return {std::max(std::min(a, b), -reach), std::min(std::max(a, b), reach)};
}

Vector3d Flank::seen(double u, double z) const {
  const double angle = start_1_ - sigma_ * u + k_1_ * z, r = pair_.first.base_radius;
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = r * (c - sigma_ * u * s) - pair_.center_distance;
  const double y = r * (s + sigma_ * u * c);
  return {x, cos_ * y - sin_ * z, sin_ * y + cos_ * z};
}

std::array<double, 2> overlap(const Flank& flank, std::array<double, 2> range) {
  constexpr int kSections = 200, kSteps = 24;
  const auto [low, high] = range;
  if (low >= high) return range;
  std::array<double, 2> found = {1.0, -1.0};
  const double step = (high - low) / kSections;
  for (int i = 0; i <= kSections; ++i) {
    const double z = low + step * i;
    bool any = false;
    for (int j = 0; j <= kSteps && !any; ++j) any = flank.value(flank.node(j, kSteps), z) != kNone;
    if (!any) continue;
    if (found[0] > found[1]) found[0] = std::max(low, z - step);
    found[1] = std::min(high, z + step);
  }
  return found;
}

Peak best_in_section(const Flank& flank, double z) {
  constexpr int kSteps = 24;
  const auto value = [&](double u) { return flank.value(u, z); };
  const auto node = [&](int i) { return flank.node(i, kSteps); };
  std::array<double, kSteps + 1> v;
  for (int i = 0; i <= kSteps; ++i) v[i] = value(node(i));
  const int best = static_cast<int>(std::max_element(v.begin(), v.end()) - v.begin());
  if (v[best] == kNone) return {};
  // The bracket extends to the neighbouring points. If a neighbour is outside the cylinders of gear
  // 2, it extends to the last point in that direction that is inside.
  const auto end = [&](int neighbour) {
    if (neighbour < 0 || neighbour > kSteps) return node(best);
    if (v[neighbour] != kNone) return node(neighbour);
    double in = node(best), out = node(neighbour);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (in + out);
      (value(middle) == kNone ? out : in) = middle;
    }
    return in;
  };
  const Peak peak = climb(value, end(best - 1), end(best + 1), kSmooth);
  return peak.value > v[best] ? peak : Peak{v[best], node(best)};
}

}  // namespace gearwright::oracle
