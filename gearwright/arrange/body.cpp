#include "gearwright/arrange/body.hpp"

#include <fmt/format.h>

namespace gearwright {

Bore rim(const Gear& ring) {
  return ring.bore.value_or(Bore{ring.root_diameter + 5 * ring.spec.normal_module});
}

std::optional<Warning> body_warning(const Gear& gear, int which) {
  const std::optional<Bore>& bore = gear.bore;
  if (!bore || !gear.exists()) return std::nullopt;
  const auto warning = [&](const std::string& why) {
    return Warning{
        WarningCode::no_body,
        fmt::format("A bore of {} mm leaves no body: {}.", format_number(bore->diameter), why),
        which};
  };
  if (!gear.internal()) {
    const auto error = bore_error(*bore, gear.root_diameter / 2);
    return error ? std::optional(warning(error->rule)) : std::nullopt;
  }
  if (bore->diameter > gear.root_diameter) return std::nullopt;
  return warning(fmt::format("the rim of an internal gear must lie outside its roots, beyond {} mm",
                             format_number(gear.root_diameter)));
}

}  // namespace gearwright
