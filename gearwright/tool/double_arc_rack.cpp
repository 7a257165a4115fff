#include "gearwright/tool/double_arc_rack.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

std::optional<Error> check_numbers(const DoubleArcRack& r) {
  const double alpha = r.pressure_angle.deg();
  if (!(alpha > 0.0 && alpha < 90.0))
    return refused("rack.pressure_angle", alpha, {0.0, 90.0},
                   "must lie between {}° and {}°, usually 24°");
  for (const auto& [member, value] :
       {std::pair{"rack.addendum", r.addendum}, std::pair{"rack.dedendum", r.dedendum},
        std::pair{"rack.convex_radius", r.convex_radius},
        std::pair{"rack.concave_radius", r.concave_radius},
        std::pair{"rack.space_width", r.space_width}, std::pair{"rack.step_height", r.step_height},
        std::pair{"rack.step_depth", r.step_depth}}) {
    if (!(value > 0.0 && value <= kMaxModules))
      return refused(member, value, {0.0, kMaxModules}, "must be greater than {} and at most {}");
  }
  for (const auto& [member, value] : {std::pair{"rack.convex_height", r.convex_height},
                                      std::pair{"rack.concave_height", r.concave_height},
                                      std::pair{"rack.convex_offset", r.convex_offset}}) {
    if (!(std::abs(value) <= kMaxModules))
      return refused(member, value, {-kMaxModules, kMaxModules}, "must lie between {} and {}");
  }
  return std::nullopt;
}

}  // namespace

Result<DoubleArcRack> gbt12759_rack(double m) {
  DoubleArcRack rack;
  rack.named = true;
  if (m >= 1.5 && m <= 3.0) return rack;
  if (m > 3.0 && m <= 6.0) {
    rack.concave_radius = 1.41;
    rack.concave_height = 0.0285;
    return rack;
  }
  if (m > 10.0 && m <= 16.0) {
    rack.concave_radius = 1.38;
    rack.concave_height = 0.0163;
    rack.space_width = 1.1573;
    return rack;
  }
  if (m > 32.0 && m <= 50.0) {
    rack.concave_radius = 1.34;
    rack.concave_height = 0.0;
    rack.space_width = 1.1573;
    return rack;
  }
  return Error{"rack", "GBT12759",
               fmt::format("the numbers of the standard for a normal module of {}\u00a0mm are not "
                           "available. They are available for modules of 1.5 to 3, over 3 to 6, "
                           "over 10 to 16 and over 32 to 50\u00a0mm. For other modules, give the "
                           "numbers in a rack of the kind double_circular_arc",
                           format_number(m))};
}

Result<DoubleArcDerived> derived(const DoubleArcRack& r) {
  if (auto error = check_numbers(r)) return *error;
  const double s = std::sin(r.pressure_angle.rad());
  const double c = std::cos(r.pressure_angle.rad());
  DoubleArcDerived d;
  d.convex_contact_height = r.convex_radius * s + r.convex_height;
  d.concave_contact_depth = r.concave_radius * s - r.concave_height;
  d.contact_thickness = 2 * (r.convex_radius * c - r.convex_offset);
  d.concave_offset = r.concave_radius * c - r.space_width / 2;

  // At the lower end of the convex arc, the arc of the step is tangent to the convex arc. It also
  // passes through the upper end of the concave arc.
  const double sin_1 = (r.step_height - r.convex_height) / r.convex_radius;
  if (!(sin_1 > 0.0 && sin_1 < 1.0)) {
    return refused("rack.step_height", r.step_height,
                   {r.convex_height, r.convex_height + r.convex_radius},
                   "must lie between the lower end of the convex arc, {}, and its upper end, {}");
  }
  const double sin_2 = (r.step_depth + r.concave_height) / r.concave_radius;
  if (!(sin_2 > 0.0 && sin_2 < 1.0)) {
    return refused("rack.step_depth", r.step_depth,
                   {-r.concave_height, r.concave_radius - r.concave_height},
                   "must lie between the upper end of the concave arc, {}, and its lower end, {}");
  }
  d.convex_begin = Angle::radians(std::asin(sin_1));
  d.concave_end = Angle::radians(std::asin(sin_2));
  const double cos_1 = std::sqrt((1 - sin_1) * (1 + sin_1));
  const double cos_2 = std::sqrt((1 - sin_2) * (1 + sin_2));
  if (!(r.convex_offset < r.convex_radius * cos_1)) {
    return refused("rack.convex_offset", r.convex_offset, {r.convex_radius * cos_1},
                   "leaves no tooth; the value must be less than {}");
  }
  const double dx = -r.step_depth - r.step_height;
  const double dy = (kHalfPi + d.concave_offset - r.concave_radius * cos_2) -
                    (r.convex_radius * cos_1 - r.convex_offset);
  const double across = dx * sin_1 + dy * cos_1;
  d.step_radius = (dx * dx + dy * dy) / (2 * across);
  // The normal angle of the step must be at most 90° at the end of the concave arc. From there, it
  // must decrease to the normal angle of the convex arc.
  if (!(across > 0.0 && d.step_radius <= kMaxModules && dy <= d.step_radius * cos_1 &&
        r.step_height + d.step_radius * sin_1 + r.step_depth < d.step_radius)) {
    return refused("rack.space_width", r.space_width,
                   "leaves no step between the concave and the convex arc; a narrower tooth space "
                   "or a greater `convex_offset` would help");
  }

  const double depth = r.concave_height + r.dedendum;  // depth of the tip below the concave arc's
                                                       // centre
  d.root_radius =
      (r.concave_radius * r.concave_radius - depth * depth - d.concave_offset * d.concave_offset) /
      (2 * (r.concave_radius - depth));
  if (!(r.concave_radius > depth && d.root_radius >= 0.0)) {
    const double deepest = std::sqrt(std::max(0.0, (r.concave_radius - d.concave_offset) *
                                                       (r.concave_radius + d.concave_offset))) -
                           r.concave_height;
    return refused("rack.dedendum", r.dedendum, {deepest},
                   "the tooth of the cutter becomes pointed before it reaches this dedendum; the "
                   "dedendum must be less than {}");
  }
  return d;
}

Result<RackOfArcs> arcs_of(const DoubleArcRack& r) {
  auto numbers = derived(r);
  if (!numbers) return numbers.error();
  const DoubleArcDerived& d = *numbers;
  const double r_g = d.root_radius;
  const double sin_1 = std::sin(d.convex_begin.rad()), cos_1 = std::cos(d.convex_begin.rad());

  RackArc concave, step, convex;
  concave.center_height = r.concave_height;
  concave.center_offset = kHalfPi + d.concave_offset;
  concave.radius = -r.concave_radius;
  concave.begin =
      Angle::radians(std::asin((r.concave_height + r.dedendum - r_g) / (r.concave_radius - r_g)));
  concave.end = d.concave_end;
  if (!(concave.begin.rad() > concave.end.rad())) {
    return refused("rack.step_depth", r.step_depth, {-point_at(concave, concave.begin).x()},
                   "must be less than {}, the depth at which the root begins");
  }
  convex.center_height = r.convex_height;
  convex.center_offset = -r.convex_offset;
  convex.radius = r.convex_radius;
  convex.begin = d.convex_begin;
  convex.end = Angle::radians(std::acos(std::max(0.0, r.convex_offset / r.convex_radius)));
  const double top = point_at(convex, convex.end).x();
  if (!(r.addendum <= top)) {
    return refused(
        "rack.addendum", r.addendum, {top},
        "the two flank arcs meet in a point {} modules above the datum line; the addendum must "
        "not exceed this height");
  }

  step.working = false;
  step.center_height = r.step_height + d.step_radius * sin_1;
  step.center_offset = point_at(convex, convex.begin).y() + d.step_radius * cos_1;
  step.radius = -d.step_radius;
  step.begin = Angle::radians(std::asin((step.center_height + r.step_depth) / d.step_radius));
  step.end = convex.begin;
  const RackArc tip = tip_rounding(-r.dedendum + r_g, kHalfPi, r_g, concave.begin);
  return RackOfArcs{r.addendum, r.dedendum, {tip, concave, step, convex}};
}

}  // namespace gearwright
