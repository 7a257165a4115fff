#include "gearwright/inspection/chordal_thickness.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

Error off_flank(double diameter, const std::string& why) {
  return refused("chord_diameter", diameter, why);
}

}  // namespace

ToothArc<double> tooth_arc(const Gear& gear, double diameter) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double s_t = tooth_thickness_transverse(gear.spec.teeth, g.base_diameter,
                                                g.base_tooth_thickness, diameter);
  ToothArc<double> arc;
  arc.half_angle = s_t / diameter;
  arc.helix_angle = std::atan(diameter / g.base_diameter * std::tan(g.base_helix_angle));
  arc.radius = diameter / 2;
  arc.tip_radius = gear.actual_tip_radius();
  arc.side = gear.side();
  return arc;
}

Result<ChordalThickness<double>> chordal_thickness(const Gear& gear, double diameter) {
  const auto flank = measurable_flank(gear, "chord_diameter", diameter);
  if (!flank) return flank.error();
  const auto shown = [diameter](double end) { return format_number(end, diameter); };
  const std::string ends = fmt::format(
      "at least the base diameter {} mm, on the usable flank from {} = {} mm to d_Fa = {} mm",
      shown(gear.reference().base_diameter), gear.tooth ? "d_Ff" : "the root diameter",
      shown(flank->root_end), shown(flank->tip_end));
  if (!flank->contains(diameter)) return off_flank(diameter, "must be " + ends);  // true for NaN
  const ToothArc<double> arc = tooth_arc(gear, diameter);
  if (!(arc.half_angle >= kMinHalfAngle)) {
    return off_flank(diameter,
                     fmt::format("the two flanks meet at a diameter of {} mm, where the tooth "
                                 "ends; the diameter must be {}",
                                 format_number(gear.pointed_diameter.value_or(diameter)), ends));
  }
  if (arc.half_angle < std::numbers::pi) {
    const auto chord = shortest_chord(arc);
    if (chord.half_angle_used <= std::numbers::pi / 2) return chord;
  }
  return off_flank(diameter,
                   fmt::format("the tooth spans {} degrees about the axis, which is too much for a "
                               "calliper; use a greater diameter, {}",
                               format_number(2 * arc.half_angle * kDegPerRad), ends));
}

std::optional<ConstantChord> constant_chord(const Gear& gear) {
  const auto flank = usable_flank(gear);
  if (!flank) return std::nullopt;
  const double half = gear.reference().reference_tooth_thickness_normal / 2;
  const double sin_a = std::sin(gear.spec.normal_pressure_angle.rad());
  const double cos_a = std::cos(gear.spec.normal_pressure_angle.rad());
  const double side = gear.side();
  const double across =
      half * cos_a * cos_a;                // from the middle of the tooth, in the normal section
  const double up = half * sin_a * cos_a;  // from the reference cylinder towards the tip
  // In the transverse section, `across` has a component of cos β times its length. [T10.14]
  const double radius = std::hypot(gear.reference_diameter / 2 + side * up,
                                   across * std::cos(gear.spec.helix_angle.rad()));
  const double addendum = side * (2 * gear.actual_tip_radius() - gear.reference_diameter) / 2;
  return ConstantChord{2 * across, addendum - up, 2 * radius, flank->place(2 * radius)};
}

}  // namespace gearwright
