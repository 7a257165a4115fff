#include "gearwright/inspection/constant_chord.hpp"

#include <cmath>

namespace gearwright {

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
  // The component of `across` in the transverse section is cos β times its length. [T10.14]
  const double radius = std::hypot(gear.reference_diameter / 2 + side * up,
                                   across * std::cos(gear.spec.helix_angle.rad()));
  const double addendum = side * (2 * gear.actual_tip_radius() - gear.reference_diameter) / 2;
  return ConstantChord{2 * across, addendum - up, 2 * radius, flank->place(2 * radius)};
}

}  // namespace gearwright
