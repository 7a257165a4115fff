#include "gearwright/generation/circular_fillets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

std::optional<FilletArc> root_fillet_at(const Involute& flank, int teeth, double xi) {
  GW_EXPECTS(teeth >= 1 && xi >= 0.0);
  const double r_b = flank.base_radius();
  const double u = xi + std::numbers::pi / teeth - flank.base_half_angle();
  if (!(u > -kHalfPi && u < kHalfPi)) return std::nullopt;
  const double radius = r_b * (std::tan(u) - xi);
  if (!(radius > 0.0)) return std::nullopt;
  // D − r_r = r_b (1/cos u − tan u + ξ). The difference 1/cos u − tan u is computed as
  // tan((π/2 − u)/2).
  const double end = r_b * (std::tan((kHalfPi - u) / 2) + xi);
  return FilletArc{radius, r_b / std::cos(u), Angle::radians(kHalfPi - u), end};
}

std::optional<FilletArc> tip_fillet_at(const Involute& flank, double xi) {
  GW_EXPECTS(xi >= 0.0);
  const double r_b = flank.base_radius();
  const double delta = flank.base_half_angle() - xi;
  if (!(delta > -kHalfPi && delta < kHalfPi)) return std::nullopt;
  const double radius = r_b * (xi + std::tan(delta));
  if (!(radius > 0.0)) return std::nullopt;
  const double distance = r_b / std::cos(delta);
  return FilletArc{radius, distance, Angle::radians(kHalfPi + delta), distance + radius};
}

CircularFillet tip_corner_at(const Involute& flank, double tip_radius, double radius) {
  const double r_b = flank.base_radius();
  const double distance = tip_radius - radius;
  GW_EXPECTS(radius > 0.0 && distance >= r_b);
  const double along = std::sqrt((distance - r_b) * (distance + r_b));  // r_b ξ − ρ_a
  const double xi = (radius + along) / r_b;
  const double lean = std::atan2(along, r_b);
  return {xi,
          {radius, distance, Angle::radians(kHalfPi - lean), tip_radius,
           Angle::radians(flank.base_half_angle() - xi + lean)}};
}

std::optional<double> roll_of_tip_fillet(const Involute& flank, double radius) {
  GW_EXPECTS(radius > 0.0);
  const double r_b = flank.base_radius();
  const double psi_b = flank.base_half_angle();
  const auto f = [&](double xi) {
    const double t = std::tan(psi_b - xi);
    return Slope<double>{r_b * (xi + t) - radius, -r_b * t * t};
  };
  const double lo = std::max(0.0, psi_b - kHalfPi);
  const double hi = psi_b + kHalfPi;
  if (psi_b < kHalfPi && f(0.0).value < 0.0) return std::nullopt;
  const auto root = newton_in_bracket(f, lo, hi, 0.5 * (lo + hi), false);
  GW_ENSURES(root.found());
  return root.x;
}

namespace {

// Returns the roll angle at which the flanks of the tooth meet, or 0 if they meet on or inside the
// base circle.
double roll_of_point(const Involute& flank) {
  const double psi_b = flank.base_half_angle();
  return psi_b > 0.0 ? std::tan(inverse_involute(psi_b)) : 0.0;
}

Result<CircularFillet> root_fillet(const FlankRuler& ruler, int teeth, const RootFilletSpec& root,
                                   double tip_roll) {
  const Involute& flank = ruler.flank;
  const double l_zero = std::max(ruler.undercut_l(), 0.0);
  const double xi = std::max(0.0, ruler.roll(l_zero + root.offset));
  const double eta = std::numbers::pi / teeth - flank.base_half_angle();
  const double most = std::min(tip_roll, kHalfPi - eta);
  // At the least roll angle, the rack cuts both flanks of the tooth space, so there is a space
  // between these flanks.
  const double least = std::max(0.0, ruler.roll(l_zero));
  const char* const field = "root_fillet.offset";
  if (!(least < most)) {
    return refused(field, root.offset,
                   "no circle centred in the tooth space fits, because the flank ends too early; "
                   "less profile shift or a greater tip diameter would help");
  }
  if (!(xi < most)) {
    return refused(
        field, root.offset, {ruler.l(most) - l_zero},
        "leaves no flank between the root fillet and the tip; the offset must be less than {} mm");
  }
  const auto arc = root_fillet_at(flank, teeth, xi);
  if (!arc || !(arc->end > 0.0)) {
    return refused(field, root.offset, {ruler.l(most) - l_zero},
                   "no circle centred in the tooth space touches the flank at this offset; the "
                   "offset must be less than {} mm");
  }
  return CircularFillet{xi, *arc};
}

// Returns ξ_J of the tip fillet that ends at the radius ρ. The search starts at ξ = ψ_b, because
// for ξ > ψ_b the end of the fillet moves outward with increasing ξ. [T6.6]
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

// Returns the rounding of the tip corners. With the greatest possible radius, either no land is
// left between the two corners or no flank is left below them.
Result<CircularFillet> tip_corner(const FlankRuler& ruler, double radius, double tip_radius,
                                  double least) {
  const Involute& flank = ruler.flank;
  constexpr double kInside = 1 - 1e-12;  // keeps the centre outside the base circle
  const double most = (tip_radius - flank.base_radius()) * kInside;
  const auto room = [&](double rho) {
    const CircularFillet corner = tip_corner_at(flank, tip_radius, rho);
    return std::min(corner.arc.land.rad(), corner.roll - least);
  };
  // Least corner radius, relative to the tip radius. It is smaller than any radius on a drawing.
  constexpr double kSharp = 1e-9;
  const double sharp = kSharp * tip_radius;
  if (!(most > sharp && room(sharp) > 0.0)) {
    return Error{"tip_fillet.corner_radius", "",
                 "there is no tip corner to round, because the tooth is pointed or no flank is "
                 "left below the tip; less profile shift or a smaller tip diameter would help"};
  }
  if (radius < most && room(radius) > 0.0) return tip_corner_at(flank, tip_radius, radius);
  const double greatest = room(most) > 0.0 ? most : find_root(room, sharp, most).x;
  return refused(
      "tip_fillet.corner_radius", radius, {greatest},
      "does not fit between flank and centre line at the tip; the radius must be less than {} mm");
}

Result<double> tip_roll(const FlankRuler& ruler, const TipFilletSpec& tip, double least) {
  const Involute& flank = ruler.flank;
  const double most = std::min(roll_of_point(flank), ruler.roll(ruler.end));
  // For smaller ξ, the normal of the flank points away from the centre line of the tooth.
  least = std::max(least, flank.base_half_angle() - kHalfPi);
  if (!(least < most))
    return Error{"tip_fillet", "", "no flank is left between the root and the point of the tooth"};
  const auto widest = tip_fillet_at(flank, least);
  const auto narrowest = most < roll_of_point(flank) ? tip_fillet_at(flank, most) : std::nullopt;
  const double r_max = widest ? widest->radius : kInfinity;
  const double r_min = narrowest ? narrowest->radius : 0.0;
  switch (tip.by) {
    case TipFilletSpec::By::radius: {
      if (tip.value <= r_max && tip.value > r_min)
        if (const auto xi = roll_of_tip_fillet(flank, tip.value)) return *xi;
      const char* const field = "tip_fillet.radius";
      if (std::isinf(r_max)) {
        return refused(field, tip.value, {r_min},
                       "no circle of this radius touches both flanks of the tooth; the radius must "
                       "be greater than {} mm");
      }
      return refused(field, tip.value, {r_min, r_max},
                     "no circle of this radius touches both flanks of the tooth; the radius must "
                     "be greater than {} mm and at most {} mm");
    }
    case TipFilletSpec::By::l: {
      const double xi = ruler.roll(tip.value);
      if (xi > least && xi < most) return xi;
      return refused("tip_fillet.l", tip.value, {ruler.l(least), ruler.l(most)},
                     "must lie between {} mm, the start of the flank, and {} mm, where the flank "
                     "ends or the tooth is pointed");
    }
    case TipFilletSpec::By::corner: break;  // see tip_corner()
    case TipFilletSpec::By::end_radius: {
      const auto xi = roll_of_end(flank, tip.value);
      if (xi && *xi > least && *xi < most) return *xi;
      const auto from = tip_fillet_at(flank, std::max(least, flank.base_half_angle()));
      const auto to = tip_fillet_at(flank, most);
      return refused("tip_fillet.end_radius", tip.value,
                     {from ? from->end : flank.base_radius(),
                      to ? to->end : flank.base_radius() * std::hypot(1.0, roll_of_point(flank))},
                     "no circle that touches both flanks ends the tooth at this radius; the radius "
                     "must lie between {} mm and {} mm");
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
    // The step in x is one pitch radius. A smaller step would increase the rounding error without
    // any gain, because ξ is linear in x.
    const double one = motion.pitch_radius;
    const double slope = (rack_involute_roll(motion, *line, x + one) - roll) / one;
    const double cos_tau = std::cos(line->tau.rad());
    return {rack_involute(motion, *line), roll, slope * cos_tau,
            (line->end_height - line->begin_height) / cos_tau};
  }
  GW_ENSURES(false);  // every rack has a flank
  return {Involute(1.0, 0.0), 0.0, 1.0, 0.0};
}

Result<CircularFillets> circular_fillets(const FlankRuler& ruler, int teeth,
                                         const std::optional<RootFilletSpec>& root,
                                         const std::optional<TipFilletSpec>& tip,
                                         std::optional<double> tip_radius) {
  CircularFillets fillets;
  double top = std::min(roll_of_point(ruler.flank), ruler.roll(ruler.end));
  if (tip_radius) top = std::min(top, ruler.flank.roll_at(*tip_radius));
  if (tip && tip->by == TipFilletSpec::By::corner) {
    GW_EXPECTS(tip_radius.has_value());
    const double least = std::max(0.0, ruler.roll_at_0);
    auto corner = tip_corner(ruler, tip->value, *tip_radius, least);
    if (!corner) return corner.error();
    fillets.tip = *corner;
    top = std::min(top, corner->roll);
  } else if (tip) {
    const double least = std::max(0.0, ruler.roll_at_0);
    auto xi = tip_roll(ruler, *tip, least);
    if (!xi) return xi.error();
    const auto arc = tip_fillet_at(ruler.flank, *xi);
    if (!arc) {
      return Error{
          "tip_fillet", "",
          "the fillet would have to touch the tooth at a place where the rack leaves no flank"};
    }
    fillets.tip = CircularFillet{*xi, *arc};
    top = std::min(top, *xi);
  }
  if (root) {
    auto fillet = root_fillet(ruler, teeth, *root, top);
    if (!fillet) return fillet.error();
    fillets.root = *fillet;
  }
  return fillets;
}

}  // namespace gearwright
