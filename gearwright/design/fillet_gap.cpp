#include "gearwright/design/fillet_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/math/lowest.hpp"

namespace gearwright {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The tip corner of the mating gear, in the frame of one gear.
struct Corner {
  double a;      // centre distance
  double u;      // tip radius
  double angle;  // angle from the corner to the middle of its tooth, plus half of the backlash
  double ratio;  // z of the mating gear divided by z of this gear
};

// The root fillet in the transverse section, cut by the tip rounding of the rack. X is measured
// from the middle of the rack's tooth, and Y outwards from the pitch line.
class Fillet {
 public:
  Fillet(const TrialGear& g, double alpha_n, double x) : r_(g.r) {
    cos_beta_ = g.teeth / (2.0 * g.r);
    const double sin_n = std::sin(alpha_n);
    radius_ = (g.dedendum - g.flank_depth) / (1.0 - sin_n);
    const double depth = g.dedendum - radius_;  // depth of the centre of the rounding
    across_ = std::numbers::pi / 4.0 - depth * std::tan(alpha_n) - radius_ / std::cos(alpha_n);
    down_ = depth - x;
    end_ = std::numbers::pi / 2.0 - alpha_n;
  }
  double end() const { return end_; }

  // Returns the gap at a point of the fillet. The rack cuts this point at the angle `tau` of its
  // tip rounding, measured from the deepest point of the rounding. If the corner does not reach the
  // radius of the point, the gap is ∞.
  double gap(double tau, const Corner& c) const {
    const double sine = std::sin(tau);
    const double cosine = std::cos(tau);
    const double X = (across_ + radius_ * sine) / cos_beta_;
    const double Y = -down_ - radius_ * cosine;
    // The rack cuts a point when the normal at this point passes through the pitch point.
    const double roll = X + Y * sine / cosine * cos_beta_;
    const double to = r_ + Y;
    const double side = X - roll;
    const double square = side * side + to * to;
    const double deepest = c.a - c.u;
    if (square < deepest * deepest) return kInfinite;
    const double at = std::sqrt(square);
    const double fillet = roll / r_ + std::atan2(side, to);
    const double cos_mate = (c.a * c.a + c.u * c.u - square) / (2.0 * c.a * c.u);
    const double mate = std::acos(std::clamp(cos_mate, -1.0, 1.0));
    const double seen = std::atan2(c.u * std::sin(mate), c.a - c.u * cos_mate);
    const double corner = std::abs(seen - mate * c.ratio) + c.angle * c.ratio;
    return at * (fillet - corner);
  }

 private:
  double r_, cos_beta_, radius_, across_, down_, end_;
};

double least_gap(const Fillet& fillet, const Corner& corner) {
  constexpr int kNodes = 12;
  const auto node = [&](int i) { return fillet.end() * i / kNodes; };
  // The gap is computed at nodes, from the flank down to the corner's greatest depth.
  std::array<double, kNodes + 1> at;
  at.fill(kInfinite);
  int best = kNodes;
  double least = kInfinite;
  for (int i = kNodes; i >= 0; --i) {
    at[static_cast<std::size_t>(i)] = fillet.gap(node(i), corner);
    const double gap = at[static_cast<std::size_t>(i)];
    if (gap == kInfinite) break;
    if (gap < least) least = gap, best = i;
  }
  if (least == kInfinite) return least;
  // Between nodes, the gap may be smaller than at the lowest node. The decrease is at most the
  // difference between the lowest node and the higher one of its neighbours. If the gap at the
  // lowest node exceeds this difference, no gap is negative. The function then returns the gap at
  // the lowest node.
  const auto rise = [&](int i) {
    const double gap = at[static_cast<std::size_t>(std::clamp(i, 0, kNodes))];
    return gap == kInfinite ? least : gap - least;
  };
  if (best == kNodes || least > std::max(rise(best - 1), rise(best + 1))) return least;
  // Between the neighbours of the lowest node, the gap has one minimum. Golden section locates this
  // minimum to about a thousandth of a step. At a minimum, such an error changes the gap only to
  // second order.
  constexpr int kSteps = 14;
  const double deepest =
      golden_section([&](double t) { return fillet.gap(t, corner); }, node(std::max(best - 1, 0)),
                     node(std::min(best + 1, kNodes)), kSteps);
  return std::min(least, fillet.gap(deepest, corner));
}

}  // namespace

std::optional<double> fillet_gap(const ShiftGraph& graph, const Vec2& shifts) {
  const std::array<TrialGear, 2>& g = graph.gears();
  if (graph.problem().crossed() || g[1].teeth < 0) return std::nullopt;
  const double sum = shifts[0] + shifts[1];
  // If Σ = 0, both gears are conjugate to the same rack. Suppose that no addendum exceeds the depth
  // of the straight edges. The tip corners then touch only flanks that these edges cut. They do not
  // reach the fillets, which the rounding of the rack cuts.
  if (sum == 0.0 &&
      std::max(g[0].addendum, g[1].addendum) <= std::min(g[0].flank_depth, g[1].flank_depth) + 1e-3)
    return std::nullopt;
  const SumPlace at = graph.place(sum);
  const double alpha_n = graph.problem().normal_pressure_angle.rad();
  const double B = g[0].r_b + g[1].r_b;
  const double alpha_w = std::atan2(at.N, B);
  const double inv_t = std::tan(std::asin(g[0].sin_transverse)) - std::asin(g[0].sin_transverse);
  const double inv_w = at.N / B - alpha_w;
  // The backlash along the line of action. It is > 0 if the centre distance exceeds the
  // backlash-free centre distance.
  const double opened = inv_w - inv_t - 2.0 * std::tan(alpha_n) * sum / (g[0].teeth + g[1].teeth);
  const double backlash = std::max(0.0, 2.0 * B * opened);
  double least = kInfinite;
  for (std::size_t i : {0, 1}) {
    const TrialGear& mate = g[1 - i];
    const double x = shifts[static_cast<int>(1 - i)];
    const double u = mate.r + mate.addendum + x + at.k;
    // Half of the transverse tip thickness, computed from s_an and expressed as an angle. [T9.3]
    const double tan_at_tip = mate.tan_base_helix * u / mate.r_b;
    const double cos_at_tip = 1.0 / std::sqrt(1.0 + tan_at_tip * tan_at_tip);
    const double half = tip_thickness(mate, x, at.k) / cos_at_tip / (2.0 * u);
    const Fillet fillet(g[i], alpha_n, shifts[static_cast<int>(i)]);
    const Corner corner{at.a, u, half + backlash / (2.0 * mate.r_b),
                        static_cast<double>(mate.teeth) / g[i].teeth};
    least = std::min(least, least_gap(fillet, corner));
  }
  return least < kInfinite ? std::optional(least) : std::nullopt;
}

bool fillet_is_cut(const ShiftGraph& graph, const Vec2& shifts) {
  if (!graph.problem().limits.clear_fillets) return false;
  constexpr double kClear = 1e-6;  // modules; keeps the gap positive after the values of a printed
                                   // spec are rounded
  const auto gap = fillet_gap(graph, shifts);
  return gap && *gap < kClear;
}

}  // namespace gearwright
