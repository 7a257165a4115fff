#include "gearwright/inspection/rack_pin.hpp"

#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/inspection/pin_sizes.hpp"

namespace gearwright {

std::optional<RackPin> pin_on_rack(const RackGeometry& rack, double diameter) {
  GW_EXPECTS(diameter > 0.0);
  const double alpha = rack.normal_pressure_angle.rad(), radius = diameter / 2;
  const double e_n = rack.normal_pitch - rack.thickness;
  const double x = (diameter / std::cos(alpha) - e_n) / (2 * std::tan(alpha));
  const double contact = x - radius * std::sin(alpha);
  // The radius of a fillet is at most that of the circle that touches the root and both flanks. A
  // circle that touches the flanks and ends above the root is therefore clear of the fillets.
  const bool clear = x - radius > -rack.dedendum;
  if (!clear || contact > rack.addendum || x + radius <= rack.addendum) return std::nullopt;
  return RackPin{diameter, x, contact, rack.height + x + radius};
}

std::optional<RackPin> usual_pin(const RackGeometry& rack) {
  if (rack.bar.pin_diameter)
    if (auto pin = pin_on_rack(rack, *rack.bar.pin_diameter)) return pin;
  const double e_n = rack.normal_pitch - rack.thickness;
  const auto size = nearest_pin_size(e_n / std::cos(rack.normal_pressure_angle.rad()),
                                     [&](double d) { return pin_on_rack(rack, d).has_value(); });
  return size ? pin_on_rack(rack, *size) : std::nullopt;
}

}  // namespace gearwright
