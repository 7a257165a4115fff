#include "gearwright/arrange/tolerance_corners.hpp"

#include <fmt/format.h>

namespace gearwright {

namespace {

std::string words(const TolerancedNumber& tolerance, std::size_t end) {
  const double value = tolerance.ends[end];
  switch (tolerance.of) {
    case TolerancedNumber::Of::thickness:
      return fmt::format("a thickness allowance of {:.4f} mm on gear {}", value, tolerance.gear);
    case TolerancedNumber::Of::tip:
      return fmt::format("a tip diameter of {:.4f} mm on gear {}", value, tolerance.gear);
    case TolerancedNumber::Of::distance:
      return fmt::format("a centre distance of {:.4f} mm", value);
  }
  return "";
}

}  // namespace

std::vector<TolerancedNumber> tolerances_of(const Arranged& nominal) {
  std::vector<TolerancedNumber> list;
  if (!nominal.ends) return list;
  const auto& [lower, upper] = *nominal.ends;
  const auto add = [&](TolerancedNumber::Of of, int gear, double a, double b) {
    if (a != b) list.push_back({of, gear, {std::min(a, b), std::max(a, b)}});
  };
  if (nominal.pair &&
      (nominal.completed.pair.distance_deviations || nominal.completed.pair.distance_tolerance))
    add(TolerancedNumber::Of::distance, 0, lower.pair->center_distance(),
        upper.pair->center_distance());
  for (const int which : {1, 2}) {
    const auto i = static_cast<std::size_t>(which - 1);
    if (i >= nominal.gears.size()) break;
    if (nominal.completed.gears[i]->tolerance.tip_deviations)
      add(TolerancedNumber::Of::tip, which, lower.gears[i].tip_diameter,
          upper.gears[i].tip_diameter);
    // A gear cut by another one has the thickness that its cutter determines.
    if (nominal.completed.gears[i]->cut_by || nominal.completed.gears[i]->basic) continue;
    add(TolerancedNumber::Of::thickness, which, lower.gears[i].spec.thickness_allowance,
        upper.gears[i].spec.thickness_allowance);
  }
  return list;
}

std::vector<ToleranceCorner> corners_of(const std::vector<TolerancedNumber>& tolerances) {
  std::vector<ToleranceCorner> corners{{}};
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    std::vector<ToleranceCorner> longer;
    for (const ToleranceCorner& corner : corners) {
      for (const std::size_t end : {0u, 1u}) {
        longer.push_back(corner);
        longer.back().emplace_back(end);
      }
    }
    corners = std::move(longer);
  }
  return corners;
}

Result<Arranged> at_corner(const Arranged& nominal, const std::vector<TolerancedNumber>& tolerances,
                           const ToleranceCorner& corner) {
  GivenPair given = nominal.completed;
  PairInput& pair = given.pair;
  pair.backlash.reset();  // the teeth have already been thinned for it
  pair.backlash_circumferential.reset();
  pair.backlash_angle.reset();
  pair.backlash_ends.reset();
  pair.distance_deviations.reset();
  pair.distance_tolerance.reset();
  for (std::size_t i = 0; i < nominal.gears.size(); ++i) {
    GearInput& gear = *given.gears[i];
    gear.allowance_ends.reset();
    gear.tolerance = {};
    if (nominal.gears[i].involute() && !gear.cut_by) {
      gear.profile_shift = nominal.gears[i].spec.profile_shift;
      gear.cylindrical.thickness_allowance = nominal.gears[i].spec.thickness_allowance;
    }
  }
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    const TolerancedNumber& tolerance = tolerances[k];
    if (tolerance.of == TolerancedNumber::Of::distance) {
      pair.center_distance =
          corner[k] ? tolerance.ends[*corner[k]] : nominal.pair->center_distance();
      pair.shaft_angle = nominal.pair->shaft_angle();
      continue;
    }
    if (!corner[k]) continue;
    CylindricalSpec& gear = given.gears[static_cast<std::size_t>(tolerance.gear - 1)]->cylindrical;
    const double value = tolerance.ends[*corner[k]];
    if (tolerance.of == TolerancedNumber::Of::tip) {
      gear.tip_diameter = value;
    } else {
      gear.thickness_allowance = value;
    }
  }
  return arrange(given, nominal.pair ? Scope::pair : Scope::gears);
}

std::string corner_words(const std::vector<TolerancedNumber>& tolerances,
                         const ToleranceCorner& corner) {
  std::vector<std::string> list;
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    if (corner[k]) list.push_back(words(tolerances[k], *corner[k]));
  }
  std::string text = "At ";
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += i + 1 == list.size() ? " and " : ", ";
    text += list[i];
  }
  return text;
}

}  // namespace gearwright
