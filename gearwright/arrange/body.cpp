#include "gearwright/arrange/body.hpp"

#include <fmt/format.h>

namespace gearwright {

Bore rim(const Gear& ring) {
  return ring.bore.value_or(Bore{ring.root_diameter + 5 * ring.spec.normal_module});
}

std::optional<Warning> body_warning(const Gear& gear, std::optional<double> groove, int which) {
  const std::optional<Bore>& bore = gear.bore;
  if (!bore || !gear.exists()) return std::nullopt;
  if (groove) *groove /= 2;
  const auto error = hole_error(bore, {gear.internal(), gear.root_diameter / 2, groove}, 0.0);
  if (!error) return std::nullopt;
  const bool keyway = error->field == "bore.keyway_width";
  return Warning{
      WarningCode::no_body,
      fmt::format("A {} of {} mm {}: {}.", keyway ? "keyway" : "bore", error->value,
                  keyway ? "is not possible" : "leaves no material for the body of the gear",
                  error->rule),
      which};
}

}  // namespace gearwright
