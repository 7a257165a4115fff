#include "gearwright/tool/straight_rack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

constexpr Angle kRightAngle = Angle::radians(kHalfPi);

EdgeArc line(ArcName cuts, const EdgeLine& piece, bool smooth) { return {cuts, piece, smooth}; }

EdgeArc circle(ArcName cuts, const EdgeCircle& piece, bool smooth) { return {cuts, piece, smooth}; }

std::optional<Error> check_numbers(const StraightRack& rack, double alpha) {
  const double alpha_deg = Angle::radians(alpha).deg();
  if (!(rack.addendum >= 0.0 && rack.addendum <= kMaxModules)) {
    return refused("rack.addendum", rack.addendum, {0.0, kMaxModules},
                   "must lie between {} and {}");
  }
  if (!(rack.dedendum > 0.0 && rack.dedendum <= kMaxModules)) {
    return refused("rack.dedendum", rack.dedendum, {0.0, kMaxModules},
                   "must be greater than {} and at most {}");
  }
  if (!(rack.root_fillet_radius >= 0.0 && rack.root_fillet_radius <= kMaxModules)) {
    return refused("rack.root_fillet_radius", rack.root_fillet_radius, {0.0, kMaxModules},
                   "must lie between {} (a sharp corner) and {}");
  }
  if (!(rack.tip_fillet_radius >= 0.0 && rack.tip_fillet_radius <= kMaxModules)) {
    return refused("rack.tip_fillet_radius", rack.tip_fillet_radius, {0.0, kMaxModules},
                   "must lie between {} (none) and {}");
  }
  if (!(rack.protuberance >= 0.0 && rack.protuberance <= kMaxModules)) {
    return refused("rack.protuberance", rack.protuberance, {0.0, kMaxModules},
                   "must lie between {} (none) and {}");
  }
  if (rack.protuberance > 0.0) {
    const double a = rack.protuberance_angle.deg();
    if (!(a > 0.0 && a < alpha_deg)) {
      return refused("rack.protuberance_angle", a, {0.0, alpha_deg},
                     "must be greater than {} and less than the pressure angle {}°");
    }
  }
  if (rack.tool_addendum && !(std::abs(*rack.tool_addendum) <= kMaxModules)) {
    return refused("rack.tool_addendum", *rack.tool_addendum, {-kMaxModules, kMaxModules},
                   "must lie between {} and {}");
  }
  if (rack.semi_topping_angle) {
    const double a = rack.semi_topping_angle->deg();
    if (!(a > alpha_deg && a < 90.0)) {
      return refused("rack.semi_topping_angle", a, {alpha_deg, 90.0},
                     "must lie between the pressure angle {}° and {}°, the ends excluded");
    }
    if (rack.tip_fillet_radius > 0.0) {
      return refused("rack.semi_topping_angle", a,
                     "cannot be combined with `tip_fillet_radius`, because the bottom of the "
                     "cutter has either a ramp or a rounding; leave one of them out");
    }
    if (!rack.tool_addendum) {
      return refused(
          "rack.semi_topping_angle", a,
          "needs `tool_addendum`, the height above the datum line at which the ramp starts");
    }
  }
  return std::nullopt;
}

// Half width of the cutter's space between the straight flanks at the height x, mm. [T3.1]
double flank_y(double m, double alpha, double x) {
  return std::numbers::pi * m / 4 - x * std::tan(alpha);
}

}  // namespace

std::optional<StraightRack> iso53_rack(std::string_view name) {
  StraightRack rack;
  rack.named = true;
  if (name == "ISO53-A") return rack;
  if (name == "ISO53-B") {
    rack.root_fillet_radius = 0.30;
    return rack;
  }
  if (name == "ISO53-C") {
    rack.root_fillet_radius = 0.25;
    return rack;
  }
  if (name == "ISO53-D") {
    rack.dedendum = 1.40;
    rack.root_fillet_radius = 0.39;
    return rack;
  }
  return std::nullopt;
}

double full_radius(const StraightRack& rack, Angle normal_pressure_angle) {
  // The rounding touches the tip land and, at τ = α_n, a line that is offset from the flank by
  // pr_P*. With the full radius, the centre of the rounding lies in the middle of the cutter's
  // tooth.
  const double s = std::sin(normal_pressure_angle.rad());
  const double c = std::cos(normal_pressure_angle.rad());
  return (std::numbers::pi / 4 * c - rack.dedendum * s + rack.protuberance) / (1 - s);
}

Result<StraightRackEdge> make_edge(const StraightRack& rack, double m,
                                   Angle normal_pressure_angle) {
  const double alpha = normal_pressure_angle.rad();
  if (auto error = check_numbers(rack, alpha)) return *error;
  const double s = std::sin(alpha);
  const double c = std::cos(alpha);

  const double greatest = full_radius(rack, normal_pressure_angle);
  if (!(greatest > 0.0)) {
    const double deepest = (std::numbers::pi / 4 * c + rack.protuberance) / s;
    return refused("rack.dedendum", rack.dedendum, {deepest},
                   fmt::format("the tooth of the cutter becomes pointed before it reaches this "
                               "depth; the limit at α_n = {}° is {{}}",
                               format_number(normal_pressure_angle.deg())));
  }
  StraightRackEdge result;
  double rho = rack.root_fillet_radius;
  if (rho > greatest) {
    if (!rack.named) {
      return refused("rack.root_fillet_radius", rho, {greatest},
                     "does not fit between the flanks at the tip of the cutter; the greatest "
                     "possible radius (full radius) is {}");
    }
    rho = greatest;
    result.became_full_radius = true;
  }
  const bool full = rho == greatest;
  rho *= m;

  CutterEdge& edge = result.edge;
  edge.tip_depth = rack.dedendum * m;
  const double pr = rack.protuberance * m;
  const double x_c = -edge.tip_depth + rho;
  // The centre of a full radius lies exactly in the middle of the cutter's tooth. [T3.3]
  const double y_c =
      full ? std::numbers::pi * m / 2 : std::numbers::pi * m / 4 + (rho - pr - x_c * s) / c;
  edge.tip_land_end = y_c;

  // A small protuberance consists of the rounding only. At τ = α, the circle of the rounding lies
  // at the distance pr from the flank. If it intersects the flank, at ρ cos(α − τ) = ρ − pr, before
  // τ reaches α_pr, the protuberance has no straight line. [T3.4a]
  double round_end = alpha;
  bool proud_line = pr > 0.0;
  if (pr > 0.0) {
    const double a = rack.protuberance_angle.rad();
    const double meets = pr < 2 * rho ? alpha - std::acos(1.0 - pr / rho) : -kHalfPi;
    proud_line = meets < a;
    round_end = proud_line ? a : meets;
  }
  edge.arcs.push_back(circle(ArcName::root_fillet,
                             {{x_c, y_c}, -rho, kRightAngle, Angle::radians(round_end)}, true));
  if (proud_line) {
    // The line of the protuberance is tangent to the rounding at τ = α_pr and ends at the flank.
    // [T3.4]
    const double a = round_end;
    const double x_begin = x_c - rho * std::sin(a);
    const double y_begin = y_c - rho * std::cos(a);
    const double y_datum = y_begin + x_begin * std::tan(a);
    const double x_end = (std::numbers::pi * m / 4 - y_datum) / (std::tan(alpha) - std::tan(a));
    const double meeting = std::numbers::pi * m / 4 / std::tan(alpha);
    if (!(x_end < meeting)) {
      return refused(
          "rack.protuberance", rack.protuberance,
          fmt::format("at `protuberance_angle` = {} the line of the protuberance ends {} modules "
                      "above the datum line, where no flank is left; a smaller protuberance or "
                      "protuberance angle would help",
                      format_number(rack.protuberance_angle.deg()), format_number(x_end / m)));
    }
    edge.arcs.push_back(
        line(ArcName::root_fillet, {Angle::radians(a), y_datum, x_begin, x_end}, true));
    edge.flank_begin_depth = -x_end;
  } else {
    edge.flank_begin_depth = -(x_c - rho * std::sin(round_end));
    if (pr == 0.0) edge.flank_begin_depth = edge.tip_depth - rho * (1 - s);
  }

  // The end of the flank and the part that follows it. [T3.5]
  const double rho_1 = rack.tip_fillet_radius * m;
  if (rack.tool_addendum) {
    edge.flank_end_height = *rack.tool_addendum * m;
  } else if (rho_1 > 0.0) {
    edge.flank_end_height = rack.addendum * m - rho_1 * (1 - s);
  } else {
    edge.flank_end_height = std::numeric_limits<double>::infinity();
  }
  if (!(edge.flank_end_height > -edge.flank_begin_depth)) {
    return refused(
        "rack.tool_addendum", edge.flank_end_height / m, {-edge.flank_begin_depth / m},
        "the straight flank would end below its start, which is {} modules above the datum line");
  }
  edge.arcs.push_back(line(ArcName::flank,
                           {normal_pressure_angle, std::numbers::pi * m / 4,
                            -edge.flank_begin_depth, edge.flank_end_height},
                           !(pr > 0.0)));
  const double y_end =
      std::isinf(edge.flank_end_height) ? 0.0 : flank_y(m, alpha, edge.flank_end_height);
  if (y_end < 0.0) {
    return refused("rack.tool_addendum", edge.flank_end_height / m,
                   {std::numbers::pi / 4 / std::tan(alpha)},
                   "the two flanks of the tooth space of the cutter meet below this height; at "
                   "most {} is allowed");
  }
  if (rho_1 > 0.0) {
    const Vec2 center(edge.flank_end_height - rho_1 * s, y_end - rho_1 * c);
    if (center.y() < 0.0) {
      // If the end of the flank is given, the limit follows from the half width at this end.
      // Otherwise the height of the end itself depends on ρ_1*, and the limit accounts for this.
      const double rho_max_1 = rack.tool_addendum ? y_end / (m * c)
                                                  : (std::numbers::pi / 4 - rack.addendum * s / c) /
                                                        (c - (1 - s) * s / c);
      return refused(
          "rack.tip_fillet_radius", rack.tip_fillet_radius, {rho_max_1},
          "does not fit into the bottom of the cutter; the greatest possible radius is {}");
    }
    edge.arcs.push_back(
        circle(ArcName::tip_fillet, {center, rho_1, normal_pressure_angle, kRightAngle}, true));
    edge.bottom_height = edge.flank_end_height + rho_1 * (1 - s);
  } else if (rack.semi_topping_angle) {
    const Angle a = *rack.semi_topping_angle;
    const double y_datum = y_end + edge.flank_end_height * std::tan(a.rad());
    edge.arcs.push_back(
        line(ArcName::tip_fillet,
             {a, y_datum, edge.flank_end_height, std::numeric_limits<double>::infinity()}, false));
  } else if (rack.tool_addendum) {
    edge.bottom_height = edge.flank_end_height;
  }
  return result;
}

namespace {

AgmaRack rack_of(std::string_view name, double degrees, double addendum, double dedendum,
                 double radius) {
  StraightRack rack;
  rack.addendum = addendum;
  rack.dedendum = dedendum;
  rack.root_fillet_radius = radius;
  rack.named = true;
  return {name, rack, Angle::degrees(degrees)};
}

}  // namespace

const AgmaRack* agma_rack(std::string_view name) {
  static const std::array racks{
      rack_of("AGMA-14.5", 14.5, 1.0, 1.157, 0.209), rack_of("AGMA-20", 20.0, 1.0, 1.25, 0.3),
      rack_of("AGMA-25", 25.0, 1.0, 1.25, 0.3), rack_of("AGMA-stub", 20.0, 0.8, 1.0, 0.3)};
  const auto it =
      std::find_if(racks.begin(), racks.end(), [&](const AgmaRack& r) { return r.name == name; });
  return it == racks.end() ? nullptr : &*it;
}

}  // namespace gearwright
