// Seeded specs of gears, most of them unusual. The limits of each value are drawn as often as its
// middle range. Values at which the tooth changes its kind (undercut, pointed, through the axis)
// are drawn exactly. The same seed gives the same gears with every compiler and library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

#include "gearwright/gear/gear.hpp"

namespace gearwright::property {

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  /// Draws from [0, 1) with 53 bits. The distributions of the standard library differ between
  /// implementations.
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double uniform(double lo, double hi) { return lo + (hi - lo) * unit(); }
  double logarithmic(double lo, double hi) { return lo * std::pow(hi / lo, unit()); }
  int integer(int lo, int hi) { return lo + static_cast<int>(unit() * (hi - lo + 1)); }
  bool chance(double p) { return unit() < p; }
  double pick(std::initializer_list<double> values) {
    return std::data(values)[integer(0, static_cast<int>(values.size()) - 1)];
  }

 private:
  std::mt19937_64 bits_;
};

/// Changes a value by a few units in the last place, or not at all.
inline double jittered(Random& random, double value) {
  const int steps = random.integer(-3, 3);
  for (int i = 0; i < std::abs(steps); ++i) {
    value = std::nextafter(value, steps * std::numeric_limits<double>::infinity());
  }
  return value;
}

inline StraightRack random_rack(Random& random, Angle alpha_n) {
  if (random.chance(0.4)) {
    static constexpr const char* kNames[] = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"};
    return *iso53_rack(kNames[random.integer(0, 3)]);
  }
  StraightRack rack;
  rack.addendum = random.chance(0.5) ? 1.0 : random.uniform(0.0, 1.6);
  rack.dedendum = random.chance(0.4) ? random.pick({1.0, 1.25, 1.4}) : random.uniform(0.2, 2.0);
  if (random.chance(0.2)) {
    rack.protuberance =
        random.chance(0.5) ? random.uniform(0.0, 0.1) : random.logarithmic(1e-8, 0.01);
    rack.protuberance_angle = Angle::radians(alpha_n.rad() * random.uniform(0.02, 0.98));
  }
  const double full = full_radius(rack, alpha_n);
  if (random.chance(0.2)) {
    rack.root_fillet_radius = 0.0;
  } else if (random.chance(0.15)) {
    rack.root_fillet_radius = full;
  } else {
    rack.root_fillet_radius = random.uniform(0.0, std::min(1.02 * full, 1.0));
  }
  const double highest = std::numbers::pi / 4 / std::tan(alpha_n.rad());
  switch (random.integer(0, 7)) {
    case 0: rack.tip_fillet_radius = random.uniform(0.0, 0.5); break;
    case 1:
      rack.tip_fillet_radius = random.uniform(0.0, 0.3);
      rack.tool_addendum = random.uniform(-0.5, 1.0) * highest;
      break;
    case 2: rack.tool_addendum = random.uniform(-0.8, 1.02) * highest; break;
    case 3:
      rack.tool_addendum = random.uniform(-0.5, 1.0) * highest;
      rack.semi_topping_angle =
          Angle::degrees(random.uniform(std::min(alpha_n.deg() + 1e-3, 89.0), 89.9));
      break;
    default: break;
  }
  return rack;
}

/// A spec with z > 0. For about one in six, the engine returns an error or a gear without a tooth.
inline CylindricalSpec random_spec(Random& random) {
  CylindricalSpec spec;
  spec.teeth = random.chance(0.25) ? random.integer(1, 6)
                                   : static_cast<int>(random.logarithmic(1.0, 200.999));
  spec.normal_module =
      random.chance(0.5) ? random.pick({0.5, 1.0, 2.0, 2.5, 4.0}) : random.logarithmic(0.1, 20.0);
  spec.normal_pressure_angle = Angle::degrees(
      random.chance(0.7) ? random.pick({14.5, 20.0, 20.0, 25.0, 30.0}) : random.uniform(4.0, 50.0));
  if (random.chance(0.6)) {
    const double limit = random.chance(0.3) ? 75.0 : 45.0;
    spec.helix_angle = Angle::degrees(random.uniform(-limit, limit));
  }
  spec.face_width = 10.0;
  spec.rack = random_rack(random, spec.normal_pressure_angle);
  if (random.chance(0.2)) {
    spec.thickness_allowance = spec.normal_module * random.uniform(-0.2, 0.1);
  }

  // Shifts at which the tooth changes its kind. An allowance changes these shifts by the generating
  // amount.
  const double alpha = spec.normal_pressure_angle.rad();
  const double cos_beta = std::cos(spec.helix_angle.rad());
  const double sin_t = std::sin(std::atan(std::tan(alpha) / cos_beta));
  const double by_allowance = spec.thickness_allowance / (2 * spec.normal_module * std::tan(alpha));
  const double radius = spec.teeth / (2 * cos_beta);  // in modules
  switch (random.integer(0, 9)) {
    case 0: {  // undercut begins
      const double depth = spec.straight_rack().dedendum -
                           spec.straight_rack().root_fillet_radius * (1 - std::sin(alpha));
      spec.profile_shift = depth - radius * sin_t * sin_t;
      if (random.chance(0.6)) spec.profile_shift = jittered(random, spec.profile_shift);
      break;
    }
    case 1:  // the cutter reaches the axis
      spec.profile_shift = spec.straight_rack().dedendum - radius + random.uniform(-0.05, 0.1);
      break;
    case 2:  // the cutter's tip stays outside the pitch circle
      spec.profile_shift = spec.straight_rack().dedendum + random.pick({-0.1, 0.0, 0.1, 1.0});
      break;
    case 3: spec.profile_shift = random.uniform(-6.0, 6.0); break;
    case 4: spec.profile_shift = 0.0; break;
    default: spec.profile_shift = random.uniform(-1.2, 1.5); break;
  }
  if (random.chance(0.7)) spec.profile_shift -= by_allowance;

  if (random.chance(0.3)) {
    const double m = spec.normal_module;
    const double x_E = spec.profile_shift + by_allowance;
    const double root = 2 * m * (radius + x_E - spec.straight_rack().dedendum);
    switch (random.integer(0, 4)) {
      case 0: spec.tip_diameter = root + m * random.logarithmic(1e-9, 1.0); break;
      case 1:
        spec.tip_diameter = 2 * m * radius * std::cos(std::asin(sin_t));
        break;  // base circle
      case 2: spec.tip_diameter = 2 * m * radius; break;
      case 3: spec.tip_diameter = 2 * m * (radius + random.uniform(1.0, 30.0)); break;
      default: spec.tip_diameter = root + m * random.uniform(-0.5, 5.0); break;
    }
  }
  return spec;
}

/// The spec in the form of a file, with numbers that are read back as the same doubles.
inline std::string describe(const CylindricalSpec& s) {
  std::string text = fmt::format(
      "teeth = {}, normal_module_mm = {}, normal_pressure_angle_deg = {}, helix_angle_deg = {}, "
      "profile_shift = {}, thickness_allowance_mm = {}, rack = {{addendum = {}, dedendum = {}, "
      "root_fillet_radius = {}, tip_fillet_radius = {}, protuberance = {}, protuberance_angle_deg "
      "= {}",
      s.teeth, s.normal_module, s.normal_pressure_angle.deg(), s.helix_angle.deg(), s.profile_shift,
      s.thickness_allowance, s.straight_rack().addendum, s.straight_rack().dedendum,
      s.straight_rack().root_fillet_radius, s.straight_rack().tip_fillet_radius,
      s.straight_rack().protuberance, s.straight_rack().protuberance_angle.deg());
  if (s.straight_rack().tool_addendum)
    text += fmt::format(", tool_addendum = {}", *s.straight_rack().tool_addendum);
  if (s.straight_rack().semi_topping_angle) {
    text +=
        fmt::format(", semi_topping_angle_deg = {}", s.straight_rack().semi_topping_angle->deg());
  }
  text += s.straight_rack().named ? ", named}" : "}";
  if (s.tip_diameter) text += fmt::format(", tip_diameter_mm = {}", *s.tip_diameter);
  if (s.root_fillet) text += fmt::format(", root_fillet.offset_mm = {}", s.root_fillet->offset);
  if (s.tip_fillet) {
    static constexpr const char* kWays[] = {"radius_mm", "l_mm", "end_radius_mm"};
    text += fmt::format(", tip_fillet.{} = {}", kWays[static_cast<int>(s.tip_fillet->by)],
                        s.tip_fillet->value);
  }
  return text;
}

}  // namespace gearwright::property
