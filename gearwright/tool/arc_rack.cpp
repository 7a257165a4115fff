#include "gearwright/tool/arc_rack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/error.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// The least normal angle on the arc of rack P. At τ = 0, the tangent of the arc would be
// perpendicular to the datum line.
constexpr Angle kLastOfP = Angle::degrees(1);

bool is_F(const ArcRack& rack) { return rack.cutter == ArcRack::Cutter::F; }

// Returns the circle of the flank in the frame of the edge. [T7.1], [T7.2]
RackArc flank_of(const ArcRack& rack) {
  RackArc arc;
  arc.center_height = is_F(rack) ? -rack.center_b : rack.center_b;
  arc.center_offset = is_F(rack) ? -rack.center_a : rack.center_a + kHalfPi;
  arc.radius = is_F(rack) ? rack.arc_radius : -rack.arc_radius;
  return arc;
}

// Returns sin τ of the point where the flank joins a rounding of radius rho. [T7.4]
double joint_sine(const ArcRack& rack, double rho) {
  const RackArc flank = flank_of(rack);
  return (rho - rack.dedendum - flank.center_height) / (rho + flank.radius);
}

std::optional<Error> check_numbers(const ArcRack& rack) {
  if (!(rack.arc_radius > 0.0 && rack.arc_radius <= kMaxModules)) {
    return refused("rack.arc_radius", rack.arc_radius, {0.0, kMaxModules},
                   "must be greater than {} and at most {}");
  }
  for (const auto& [member, value] :
       {std::pair{"rack.center_a", rack.center_a}, std::pair{"rack.center_b", rack.center_b},
        std::pair{"rack.addendum", rack.addendum}, std::pair{"rack.dedendum", rack.dedendum}}) {
    if (!(std::abs(value) <= kMaxModules))
      return refused(member, value, {-kMaxModules, kMaxModules}, "must lie between {} and {}");
  }
  if (!(rack.root_fillet_radius >= 0.0 && rack.root_fillet_radius <= kMaxModules)) {
    return refused("rack.root_fillet_radius", rack.root_fillet_radius, {0.0, kMaxModules},
                   "must lie between {} (a sharp corner) and {}");
  }
  return std::nullopt;
}

// Returns an error if the joint of flank and tip rounding does not lie on the arc of the flank.
std::optional<Error> check_joint(const ArcRack& rack) {
  const double rho = rack.root_fillet_radius;
  if (!is_F(rack) && !(rho < rack.arc_radius)) {
    return refused("rack.root_fillet_radius", rho, {rack.arc_radius},
                   "must be less than the `arc_radius` of the flank, {}");
  }
  const double s = joint_sine(rack, rho);
  if (is_F(rack) && !(s > 0.0)) {
    return refused("rack.dedendum", rack.dedendum, {rack.center_b + rho},
                   fmt::format("the arc of the flank ends {} modules below the datum line, so with "
                               "this root fillet radius the dedendum must be less than {{}}",
                               format_number(rack.center_b)));
  }
  if (is_F(rack) && !(s < 1.0)) {
    return refused("rack.dedendum", rack.dedendum, {rack.center_b - rack.arc_radius},
                   "the whole arc of the flank lies deeper than this dedendum; the dedendum must "
                   "be greater than {}");
  }
  if (!is_F(rack) && !(s > 0.0)) {
    return refused("rack.root_fillet_radius", rho, {rack.center_b + rack.dedendum},
                   "the whole arc of the flank lies deeper than the tip rounding with this radius; "
                   "the radius must be less than {}");
  }
  if (!is_F(rack) && !(s < 1.0)) {
    return refused("rack.dedendum", rack.dedendum, {rack.arc_radius - rack.center_b},
                   "the whole arc of the flank lies less deep than this dedendum; the dedendum "
                   "must be less than {}");
  }
  return std::nullopt;
}

}  // namespace

ArcRack default_arc_rack(ArcRack::Cutter cutter) {
  ArcRack rack;
  rack.cutter = cutter;
  if (cutter == ArcRack::Cutter::F) return rack;
  rack.addendum = 0.0;
  rack.dedendum = 1.05;
  rack.root_fillet_radius = 0.5;
  return rack;
}

double full_radius(const ArcRack& rack) {
  // The distance between the centres of rounding and flank is q + ρ. The centre of a full radius
  // lies in the middle of the cutter's tip.
  const RackArc flank = flank_of(rack);
  const double q = flank.radius;
  const double c =
      flank.center_height + rack.dedendum;  // height of the flank's centre above the tip
  const double w = kHalfPi - flank.center_offset;
  return (w * w + c * c - q * q) / (2 * (q + c));
}

namespace {

// Returns the y coordinate of the centre of the tip rounding. The rounding fits if this is at most
// the middle of the cutter's tip, π/2.
double rounding_place(const ArcRack& rack) {
  const RackArc flank = flank_of(rack);
  const double begin = std::asin(joint_sine(rack, rack.root_fillet_radius));
  return flank.center_offset + (flank.radius + rack.root_fillet_radius) * std::cos(begin);
}

// Returns the greatest dedendum below that of `rack`, rounded down to four decimals, with which its
// tip rounding fits. Returns none if no dedendum is possible.
std::optional<double> greatest_dedendum(const ArcRack& rack) {
  constexpr int kSteps = 1000, kHalvings = 50;
  const auto fits = [&](double dedendum) {
    ArcRack other = rack;
    other.dedendum = dedendum;
    return !check_joint(other) && rounding_place(other) <= kHalfPi;
  };
  const double step = (rack.dedendum + rack.addendum) / kSteps;
  for (int i = 1; i < kSteps; ++i) {
    double good = rack.dedendum - i * step, bad = good + step;
    if (!fits(good)) continue;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (good + bad) / 2;
      (fits(middle) ? good : bad) = middle;
    }
    return rounded_down(good, 4);
  }
  return std::nullopt;
}

}  // namespace

Result<RackOfArcs> arcs_of(const ArcRack& rack) {
  if (auto error = check_numbers(rack)) return *error;
  if (auto error = check_joint(rack)) return *error;
  RackArc flank = flank_of(rack);
  // cos τ at the end of the arc, where both sides meet, limited to the range from 0 to 1. If cos τ
  // is 0, the tangent of the arc is parallel to the datum line. If it is 1, the tangent is
  // perpendicular to this line.
  const double meeting = std::min(1.0, std::max(0.0, -flank.center_offset / flank.radius));
  if (is_F(rack)) {
    if (!(meeting < 1.0)) {
      return refused("rack.center_a", rack.center_a, {rack.arc_radius},
                     "leaves no tooth; the value must be less than the `arc_radius`, {}");
    }
    if (!(rack.center_a > -kHalfPi)) {
      return refused("rack.center_a", rack.center_a, {-kHalfPi},
                     "leaves no tooth of the cutter; the value must be greater than {}");
    }
    flank.end = Angle::radians(std::acos(meeting));
  } else {
    flank.end = meeting > 0.0 && std::acos(meeting) > kLastOfP.rad()
                    ? Angle::radians(std::acos(meeting))
                    : kLastOfP;
  }
  flank.begin = Angle::radians(std::asin(joint_sine(rack, rack.root_fillet_radius)));
  const bool rises = is_F(rack) == (flank.end.rad() > flank.begin.rad());
  const double top = point_at(flank, flank.end).x();
  if (!rises) {
    return refused(
        "rack.dedendum", rack.dedendum,
        fmt::format("the flank would end before it begins, because its arc ends {} modules above "
                    "the datum line and starts {} modules above this line",
                    format_number(top), format_number(point_at(flank, flank.begin).x())));
  }
  if (!(rack.addendum <= top)) {
    return refused(
        "rack.addendum", rack.addendum, {top},
        meeting > 0.0 && meeting < 1.0
            ? "the two flank arcs meet in a point {} modules above the datum line; the addendum "
              "must not exceed this height"
            : "the arc of the flank ends {} modules above the datum line; the addendum must not "
              "exceed this height");
  }
  const double rho = rack.root_fillet_radius;
  const double y_c = flank.center_offset + (flank.radius + rho) * std::cos(flank.begin.rad());
  if (y_c > kHalfPi) {
    // The rounding with the full radius may touch the circle of the flank beyond the end of the
    // flank. In this case, every smaller rounding also touches the circle beyond the end, so only
    // the dedendum can be reduced.
    ArcRack full = rack;
    full.root_fillet_radius = full_radius(rack);
    const auto deepest = greatest_dedendum(rack);
    return full.root_fillet_radius >= 0.0 && !check_joint(full)
               ? refused("rack.root_fillet_radius", rho, {full.root_fillet_radius},
                         "does not fit into the tip of the cutter; the greatest possible radius "
                         "(full radius) is {}")
               : refused(
                     "rack.dedendum", rack.dedendum,
                     fmt::format("the tooth of the cutter becomes pointed before it reaches this "
                                 "dedendum; {}",
                                 deepest ? fmt::format("with these radii and centres, the "
                                                       "dedendum must be at most {}",
                                                       format_number(*deepest))
                                         : std::string("no dedendum is possible with these radii "
                                                       "and centres; a smaller `arc_radius` "
                                                       "would help")));
  }
  if (rack.pressure_angle) {
    const auto [lo, hi] = std::minmax({flank.begin.rad(), flank.end.rad()});
    const double psi = rack.pressure_angle->rad();
    if (!(psi >= lo && psi <= hi)) {
      return refused(
          "rack.pressure_angle", rack.pressure_angle->deg(),
          {Angle::radians(lo).deg(), Angle::radians(hi).deg()},
          "the arc of the flank has no point with this angle; its normal angles are {}° to {}°");
    }
  }
  const RackArc tip = tip_rounding(-rack.dedendum + rho, y_c, rho, flank.begin);
  return RackOfArcs{rack.addendum, rack.dedendum, {tip, flank}};
}

}  // namespace gearwright
