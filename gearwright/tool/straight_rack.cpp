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
  struct Length {
    const char* member;
    double value;
    bool positive;
    const char* rule;
  };
  for (const auto& [member, value, positive, rule] :
       {Length{"rack.addendum", rack.addendum, false, "must lie between {} and {}"},
        Length{"rack.dedendum", rack.dedendum, true, "must be greater than {} and at most {}"},
        Length{"rack.root_fillet_radius", rack.root_fillet_radius, false,
               "must lie between {} (a sharp corner) and {}"},
        Length{"rack.tip_fillet_radius", rack.tip_fillet_radius, false,
               "must lie between {} (none) and {}"},
        Length{"rack.protuberance", rack.protuberance, false, "must lie between {} (none) and {}"}})
    if (!((positive ? value > 0.0 : value >= 0.0) && value <= kMaxModules))
      return refused(member, value, {0.0, kMaxModules}, rule);
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
                     "must be greater than the pressure angle {}° and less than {}°");
    }
    if (rack.tip_fillet_radius > 0.0) {
      return refused("rack.semi_topping_angle", a,
                     "cannot be combined with `tip_fillet_radius`, because the bottom of the "
                     "cutter has either a ramp or a rounding; leave out one of the two");
    }
    if (!rack.tool_addendum) {
      return refused(
          "rack.semi_topping_angle", a,
          "needs `tool_addendum`, the height above the datum line at which the ramp starts");
    }
  }
  return std::nullopt;
}

// Returns half of the cutter's space width between the straight flanks at the height x, mm. [T3.1]
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

namespace {

// Computes the edge of one half tooth of the cutter piece by piece, from the tip to the bottom.
class EdgeMaker {
 public:
  EdgeMaker(const StraightRack& rack, double m, Angle normal_pressure_angle)
      : rack_(rack), m_(m), angle_(normal_pressure_angle), alpha_(angle_.rad()) {}

  Result<StraightRackEdge> make() {
    if (auto error = check_numbers(rack_, alpha_)) return *error;
    if (auto error = add_tip()) return *error;
    if (auto error = add_flank()) return *error;
    if (auto error = add_bottom()) return *error;
    return result_;
  }

 private:
  std::optional<Error> set_rounding();
  std::optional<Error> add_tip();
  std::optional<Error> add_protuberance(Angle angle, const Vec2& begin);
  std::optional<Error> add_flank();
  std::optional<Error> add_bottom();

  const StraightRack& rack_;
  double m_;
  Angle angle_;
  double alpha_;
  double s_ = std::sin(alpha_), c_ = std::cos(alpha_);
  double quarter_ = std::numbers::pi * m_ / 4;  // half a tooth at the datum line
  double rho_ = 0.0;                            // radius of the rounding at the tip, mm
  bool full_ = false;                           // true if the rounding has the full radius
  double y_end_ = 0.0;                          // y at the end of the flank
  StraightRackEdge result_;
  CutterEdge& edge_ = result_.edge;
};

std::optional<Error> EdgeMaker::set_rounding() {
  const double greatest = full_radius(rack_, angle_);
  if (!(greatest > 0.0)) {
    if (rack_.named) {
      const double limit = Angle::radians(std::atan(std::numbers::pi / 4 / rack_.dedendum)).deg();
      return refused(
          "normal_pressure_angle", angle_.deg(), {limit},
          fmt::format("must be less than {{}}°, because the tooth of the cutter becomes pointed "
                      "before it reaches the dedendum {} m_n; a smaller `rack.dedendum` would help",
                      format_number(rack_.dedendum)));
    }
    const double deepest = (std::numbers::pi / 4 * c_ + rack_.protuberance) / s_;
    return refused("rack.dedendum", rack_.dedendum, {deepest},
                   fmt::format("the tooth of the cutter becomes pointed before it reaches this "
                               "dedendum; at α_n = {}°, the greatest dedendum is {{}}",
                               format_number(angle_.deg())));
  }
  rho_ = rack_.root_fillet_radius;
  if (rho_ > greatest) {
    if (!rack_.named) {
      return refused("rack.root_fillet_radius", rho_, {greatest},
                     "does not fit between the flanks at the tip of the cutter; the greatest "
                     "possible radius (full radius) is {}");
    }
    rho_ = greatest;
    result_.became_full_radius = true;
  }
  full_ = rho_ == greatest;
  rho_ *= m_;
  return std::nullopt;
}

// Adds the rounding at the tip and the protuberance.
std::optional<Error> EdgeMaker::add_tip() {
  if (auto error = set_rounding()) return error;
  edge_.tip_depth = rack_.dedendum * m_;
  const double pr = rack_.protuberance * m_;
  const double x_c = -edge_.tip_depth + rho_;
  // The centre of a full radius lies exactly in the middle of the cutter's tooth. [T3.3]
  const double y_c = full_ ? std::numbers::pi * m_ / 2 : quarter_ + (rho_ - pr - x_c * s_) / c_;
  edge_.tip_land_end = y_c;

  // A small protuberance consists of the rounding only. At τ = α, the circle of the rounding lies
  // at the distance pr from the flank. If it intersects the flank, at ρ cos(α − τ) = ρ − pr, before
  // τ reaches α_pr, the protuberance has no straight line. [T3.4a]
  double round_end = alpha_;
  bool proud_line = pr > 0.0;
  if (pr > 0.0) {
    const double a = rack_.protuberance_angle.rad();
    const double meets = pr < 2 * rho_ ? alpha_ - std::acos(1.0 - pr / rho_) : -kHalfPi;
    proud_line = meets < a;
    round_end = proud_line ? a : meets;
  }
  edge_.arcs.push_back(circle(ArcName::root_fillet,
                              {{x_c, y_c}, -rho_, kRightAngle, Angle::radians(round_end)}, true));
  if (proud_line) {
    const Vec2 begin(x_c - rho_ * std::sin(round_end), y_c - rho_ * std::cos(round_end));
    return add_protuberance(Angle::radians(round_end), begin);
  }
  edge_.flank_begin_depth = -(x_c - rho_ * std::sin(round_end));
  if (pr == 0.0) edge_.flank_begin_depth = edge_.tip_depth - rho_ * (1 - s_);
  return std::nullopt;
}

// Adds the line of the protuberance, which is tangent to the rounding at τ = α_pr and ends at the
// flank. [T3.4]
std::optional<Error> EdgeMaker::add_protuberance(Angle angle, const Vec2& begin) {
  const double slope = std::tan(angle.rad());
  const double y_datum = begin.y() + begin.x() * slope;
  const double x_end = (quarter_ - y_datum) / (std::tan(alpha_) - slope);
  const double meeting = quarter_ / std::tan(alpha_);
  if (!(x_end < meeting)) {
    return refused(
        "rack.protuberance", rack_.protuberance,
        fmt::format("at `protuberance_angle` = {} the line of the protuberance ends {} modules "
                    "above the datum line, where no flank is left; a smaller protuberance or "
                    "protuberance angle would help",
                    format_number(rack_.protuberance_angle.deg()), format_number(x_end / m_)));
  }
  edge_.arcs.push_back(line(ArcName::root_fillet, {angle, y_datum, begin.x(), x_end}, true));
  edge_.flank_begin_depth = -x_end;
  return std::nullopt;
}

// Adds the straight flank. [T3.5]
std::optional<Error> EdgeMaker::add_flank() {
  const double rho_1 = rack_.tip_fillet_radius * m_;
  if (rack_.tool_addendum) {
    edge_.flank_end_height = *rack_.tool_addendum * m_;
  } else if (rho_1 > 0.0) {
    edge_.flank_end_height = rack_.addendum * m_ - rho_1 * (1 - s_);
  } else {
    edge_.flank_end_height = std::numeric_limits<double>::infinity();
  }
  if (!(edge_.flank_end_height > -edge_.flank_begin_depth)) {
    return refused(
        "rack.tool_addendum", edge_.flank_end_height / m_, {-edge_.flank_begin_depth / m_},
        "the straight flank would end below its start, which is {} modules above the datum line");
  }
  edge_.arcs.push_back(line(ArcName::flank,
                            {angle_, quarter_, -edge_.flank_begin_depth, edge_.flank_end_height},
                            !(rack_.protuberance > 0.0)));
  if (!std::isinf(edge_.flank_end_height)) y_end_ = flank_y(m_, alpha_, edge_.flank_end_height);
  if (y_end_ < 0.0) {
    return refused("rack.tool_addendum", edge_.flank_end_height / m_,
                   {std::numbers::pi / 4 / std::tan(alpha_)},
                   "the two flanks of the tooth space of the cutter meet below this height above "
                   "the datum line; the height must be at most {}");
  }
  return std::nullopt;
}

// Adds the end of the edge, beyond the flank. It is the rounding at the bottom of the cutter, or
// the ramp of a semi-topping cutter. [T3.5]
std::optional<Error> EdgeMaker::add_bottom() {
  const double rho_1 = rack_.tip_fillet_radius * m_;
  if (rho_1 > 0.0) {
    const Vec2 center(edge_.flank_end_height - rho_1 * s_, y_end_ - rho_1 * c_);
    if (center.y() < 0.0) {
      // If the end of the flank is given, the limit follows from the half width at this end.
      // Otherwise the height of the end itself depends on ρ_1*, and the limit accounts for this.
      const double rho_max_1 =
          rack_.tool_addendum
              ? y_end_ / (m_ * c_)
              : (std::numbers::pi / 4 - rack_.addendum * s_ / c_) / (c_ - (1 - s_) * s_ / c_);
      return refused(
          "rack.tip_fillet_radius", rack_.tip_fillet_radius, {rho_max_1},
          "does not fit into the bottom of the cutter; the greatest possible radius is {}");
    }
    edge_.arcs.push_back(circle(ArcName::tip_fillet, {center, rho_1, angle_, kRightAngle}, true));
    edge_.bottom_height = edge_.flank_end_height + rho_1 * (1 - s_);
  } else if (rack_.semi_topping_angle) {
    const Angle a = *rack_.semi_topping_angle;
    const double y_datum = y_end_ + edge_.flank_end_height * std::tan(a.rad());
    edge_.arcs.push_back(
        line(ArcName::tip_fillet,
             {a, y_datum, edge_.flank_end_height, std::numeric_limits<double>::infinity()}, false));
  } else if (rack_.tool_addendum) {
    edge_.bottom_height = edge_.flank_end_height;
  }
  return std::nullopt;
}

}  // namespace

Result<StraightRackEdge> make_edge(const StraightRack& rack, double m,
                                   Angle normal_pressure_angle) {
  return EdgeMaker(rack, m, normal_pressure_angle).make();
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
