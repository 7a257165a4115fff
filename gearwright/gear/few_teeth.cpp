#include "gearwright/gear/few_teeth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gearwright/base/refusal.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/newton.hpp"

namespace gearwright {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kHalfPi = std::numbers::pi / 2;

// Where the flanks of the tooth meet, as a roll angle; infinite where they never do.
double roll_of_point(const Involute& flank) {
  const double psi_b = flank.base_half_angle();
  return psi_b > 0.0 ? std::tan(inverse_involute(psi_b)) : 0.0;
}

Result<double> root_roll(const FlankRuler& ruler, int teeth, const RootFilletSpec& root,
                         double tip_roll) {
  const Involute& flank = ruler.flank;
  const double l_zero = std::max(ruler.undercut_l(), 0.0);
  const double xi = std::max(0.0, ruler.roll(l_zero + root.offset));
  const double eta = std::numbers::pi / teeth - flank.base_half_angle();
  const double most = std::min(tip_roll, kHalfPi - eta);
  // The rack cuts both flanks of the space there, so that it is open.
  const double least = std::max(0.0, ruler.roll(l_zero));
  const char* key = "root_fillet.offset_mm";
  if (!(least < most)) {
    return refused(key, root.offset,
                   "no circle centred in the space fits: the flank ends before it could touch it; "
                   "less profile shift or a greater tip diameter would help");
  }
  if (!(xi < most)) {
    return refused(key, root.offset,
                   fmt::format("leaves no flank between the root fillet and the tip; the greatest "
                               "that fits is just under {} mm",
                               ruler.l(most) - l_zero));
  }
  const auto arc = root_fillet_at(flank, teeth, xi);
  if (!arc || !(arc->end > 0.0)) {
    return refused(key, root.offset,
                   fmt::format("no circle centred in the space touches the flank there; it must be "
                               "less than {} mm",
                               ruler.l(most) - l_zero));
  }
  return xi;
}

// ξ_J ≥ ψ_b of the tip fillet that ends at the radius ρ: there the end moves out with ξ. [T6.6]
std::optional<double> roll_of_end(const Involute& flank, double rho) {
  const double r_b = flank.base_radius();
  const double psi_b = flank.base_half_angle();
  const auto f = [&](double xi) {
    const double d = xi - psi_b;
    const double c = std::cos(d);
    return Slope<double>{r_b * (xi + (1.0 - std::sin(d)) / c) - rho,
                         r_b * std::tan(d) * (1.0 - std::sin(d)) / c};
  };
  const double lo = std::max(0.0, psi_b);
  const double hi = roll_of_point(flank);
  if (!(lo < hi) || f(lo).value > 0.0 || f(hi).value < 0.0) return std::nullopt;
  const auto root = newton_in_bracket(f, lo, hi, 0.5 * (lo + hi), true);
  GW_ENSURES(root.found());
  return root.x;
}

Result<double> tip_roll(const FlankRuler& ruler, const TipFilletSpec& tip, double least) {
  const Involute& flank = ruler.flank;
  const double most = std::min(roll_of_point(flank), ruler.roll(ruler.end));
  // Below that the flank's normal points away from the tooth's centre line.
  least = std::max(least, flank.base_half_angle() - kHalfPi);
  if (!(least < most)) {
    return Error{"tip_fillet", "",
                 "tip_fillet: no flank is left between the root and the point of the tooth for it "
                 "to touch"};
  }
  const auto widest = tip_fillet_at(flank, least);
  const auto narrowest = most < roll_of_point(flank) ? tip_fillet_at(flank, most) : std::nullopt;
  const double r_most = widest ? widest->radius : kInfinity;
  const double r_least = narrowest ? narrowest->radius : 0.0;
  switch (tip.by) {
    case TipFilletSpec::By::radius: {
      if (tip.value <= r_most && tip.value > r_least) {
        if (const auto xi = roll_of_tip_fillet(flank, tip.value)) return *xi;
      }
      return refused(
          "tip_fillet.radius_mm", tip.value,
          fmt::format("no such circle touches both flanks of the tooth; it must be "
                      "greater than {} mm{}",
                      r_least,
                      std::isinf(r_most)
                          ? std::string()
                          : fmt::format(", and the largest that fits is {} mm", r_most)));
    }
    case TipFilletSpec::By::l: {
      const double xi = ruler.roll(tip.value);
      if (xi > least && xi < most) return xi;
      return refused("tip_fillet.l_mm", tip.value,
                     fmt::format("must lie between {} mm, where the flank begins, and {} mm, where "
                                 "it ends or the tooth is pointed",
                                 ruler.l(least), ruler.l(most)));
    }
    case TipFilletSpec::By::end_radius: {
      const auto xi = roll_of_end(flank, tip.value);
      if (xi && *xi > least && *xi < most) return *xi;
      const auto from = tip_fillet_at(flank, std::max(least, flank.base_half_angle()));
      const auto to = tip_fillet_at(flank, most);
      return refused(
          "tip_fillet", 2 * tip.value,
          fmt::format(
              "no circle that touches both flanks ends the tooth at this "
              "diameter; it could lie between {} and {} mm",
              from ? 2 * from->end : 2 * flank.base_radius(),
              to ? 2 * to->end : 2 * flank.base_radius() * std::hypot(1.0, roll_of_point(flank))));
    }
  }
  GW_ENSURES(false);
  return 0.0;
}

}  // namespace

FlankRuler flank_ruler(const CutterEdge& edge, const RackMotion& motion) {
  for (const EdgeArc& arc : edge.arcs) {
    const auto* line = std::get_if<EdgeLine>(&arc.shape);
    if (arc.cuts != ArcName::flank || !line) continue;
    const double x = line->begin_height + motion.shift;
    const double roll = rack_involute_roll(motion, *line, x);
    // One module up: ξ is linear in x, and the difference is exact enough only as a whole.
    const double one = motion.pitch_radius;
    const double slope = (rack_involute_roll(motion, *line, x + one) - roll) / one;
    const double cos_tau = std::cos(line->tau.rad());
    return {rack_involute(motion, *line), roll, slope * cos_tau,
            (line->end_height - line->begin_height) / cos_tau};
  }
  GW_ENSURES(false);  // every rack has a flank
  return {Involute(1.0, 0.0), 0.0, 1.0, 0.0};
}

Result<FilletRolls> fillet_rolls(const FlankRuler& ruler, int teeth,
                                 const std::optional<RootFilletSpec>& root,
                                 const std::optional<TipFilletSpec>& tip,
                                 std::optional<double> tip_radius) {
  FilletRolls rolls;
  double top = std::min(roll_of_point(ruler.flank), ruler.roll(ruler.end));
  if (tip_radius) top = std::min(top, ruler.flank.roll_at(*tip_radius));
  if (tip) {
    const double least = std::max(0.0, ruler.roll_at_0);
    auto xi = tip_roll(ruler, *tip, least);
    if (!xi) return xi.error();
    rolls.tip = *xi;
    top = std::min(top, *xi);
  }
  if (root) {
    auto xi = root_roll(ruler, teeth, *root, top);
    if (!xi) return xi.error();
    rolls.root = *xi;
  }
  return rolls;
}

}  // namespace gearwright
