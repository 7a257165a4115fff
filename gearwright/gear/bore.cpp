#include "gearwright/gear/bore.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

constexpr int kDecimals = 3;  // of a printed diameter, mm

// Returns the error of the rim of an internal gear, or none if the rim is valid. The rim diameter
// must be given. The rim must extend at least to the radius `room`, mm, and must not have a keyway.
std::optional<Error> rim_error(const std::optional<Bore>& bore, double room) {
  const std::string need = fmt::format(
      "the bore of an internal gear is the outside diameter of its rim and must be at least {:.3f} "
      "mm, so that it lies outside the roots",
      rounded_up(2.0 * room, kDecimals));
  if (!bore) return Error{"bore.diameter", "", need};
  if (bore->keyway_width > 0.0) {
    return refused("bore.keyway_width", bore->keyway_width,
                   "an internal gear has no keyway; leave out the keyway");
  }
  if (!(bore->diameter / 2.0 >= room)) {
    return refused("bore.diameter", bore->diameter, need);
  }
  return std::nullopt;
}

// Returns the error if the bore is invalid, or if the bore or its keyway exceeds the radius `room`,
// mm. Returns none if the bore is valid.
std::optional<Error> bore_error(const Bore& bore, double room) {
  if (!(bore.diameter > 0.0)) {
    return refused("bore.diameter", bore.diameter,
                   "the bore must be greater than 0; leave out the bore for a solid body");
  }
  if (!(bore.keyway_width >= 0.0 && bore.keyway_width < bore.diameter)) {
    return refused(
        "bore.keyway_width", bore.keyway_width, {0.0, bore.diameter},
        "the width of the keyway must be at least {} and less than the bore diameter {} mm");
  }
  if (bore.has_keyway() && !(bore.keyway_depth >= 0.0)) {
    return refused("bore.keyway_depth", bore.keyway_depth,
                   "the depth of the keyway, measured from the bore circle, must not be negative");
  }
  if (bore_reach(bore) <= room) return std::nullopt;

  const double half = bore.keyway_width / 2.0;
  const double depth = bore.has_keyway() ? bore.keyway_depth : 0.0;
  const double largest =
      room > half ? 2.0 * (std::sqrt((room - half) * (room + half)) - depth) : 0.0;
  const double printed = rounded_down(largest, kDecimals);
  const char* with = bore.has_keyway() ? " with its keyway" : "";
  return refused(
      "bore.diameter", bore.diameter,
      printed > bore.keyway_width
          ? fmt::format(
                "the bore{} must be at most {:.3f} mm, so that it lies inside the root circle",
                with, printed)
          : fmt::format("no bore{} fits inside the root circle", with));
}

}  // namespace

std::optional<Bore> body_bore(const Gear& gear) {
  if (gear.bore || !gear.internal()) return gear.bore;
  return Bore{default_rim(gear.root_diameter, gear.spec.normal_module)};
}

double bore_reach(const Bore& bore) {
  const double r = bore.diameter / 2.0;
  return bore.has_keyway() ? std::hypot(bore.keyway_width / 2.0, r + bore.keyway_depth) : r;
}

std::optional<Error> hole_error(const std::optional<Bore>& bore, const HoleLimits& limits) {
  const auto at = [&](double limit) {
    return limits.internal ? rim_error(bore, limit + kLeastWall)
           : bore          ? bore_error(*bore, limit - kLeastWall)
                           : std::nullopt;
  };
  auto error = at(limits.groove.value_or(limits.root));
  if (error && limits.groove && !at(limits.root))
    error->rule += "; the limit is the groove between the halves, which is deeper than the teeth";
  return error;
}

}  // namespace gearwright
