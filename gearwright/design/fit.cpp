#include "gearwright/design/fit.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/angle.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

namespace {

// Relative tolerance for centre distances. A centre distance given with ten digits counts as equal
// to the computed one.
constexpr double kSameDistance = 1e-9;

std::array<CylindricalSpec, 2> specs_of(const FitProblem& p) {
  if (p.known) return *p.known;
  std::array<CylindricalSpec, 2> specs;
  for (int i : {0, 1}) {
    specs[i].teeth = p.teeth[i];
    specs[i].normal_module = p.normal_module;
    specs[i].normal_pressure_angle = p.normal_pressure_angle;
    specs[i].helix_angle = *p.helix[i];
    specs[i].profile_shift = p.shift[i].value_or(0.0);
  }
  return specs;
}

BasePair<double> base_gears(const FitProblem& p) {
  const auto specs = specs_of(p);
  return nominal_base_pair(specs[0], specs[1]);
}

FitBranch branch_at(const FitProblem& p, const std::array<double, 2>& shift,
                    const CrossedPlace& place) {
  return {{*p.helix[0], *p.helix[1]},
          shift,
          place.center_distance,
          place.shaft_angle,
          place.normal_pressure_angle};
}

Error one_condition_too_many() {
  return {"fit.working_normal_pressure_angle", "",
          "overdetermines the pair; leave out this value or another given value"};
}

// Returns the position of known gears on parallel axes. Such gears are free of backlash at only one
// centre distance.
Fit place_on_parallel_axes(const FitProblem& p, const BasePair<double>& gears,
                           const std::array<double, 2>& shift) {
  Fit result;
  const auto alpha = transverse_angle_at_min_distance(gears);
  if (!alpha) {
    result.reason =
        "the teeth have no backlash-free centre distance, because the sum of their profile shifts "
        "has the wrong sign";
    return result;
  }
  const double a = base_radius_sum(gears) / std::cos(*alpha);
  const double alpha_wn = std::asin(std::sin(*alpha) * std::cos(gears[0].helix_angle));
  if (p.center_distance && std::abs(*p.center_distance - a) > kSameDistance * a) {
    result.reason = fmt::format(
        "on parallel axes these gears are free of backlash only at a centre distance of {} mm; "
        "leave out one profile shift to have it computed from the given centre distance",
        format_number(a, *p.center_distance));
    result.nearest_distance = a;
    result.nearest_shaft_angle = Angle();
    return result;
  }
  result.branches.push_back(
      {{*p.helix[0], *p.helix[1]}, shift, a, Angle(), Angle::radians(alpha_wn)});
  return result;
}

Fit angles_of_distance(const FitProblem& p, const BasePair<double>& gears,
                       const std::array<double, 2>& shift) {
  Fit result;
  const double a = *p.center_distance;
  for (const double alpha : transverse_angles_at_distance(gears, a)) {
    CrossedPlace place = crossed_place(gears, alpha);
    place.center_distance = a;
    result.branches.push_back(branch_at(p, shift, place));
  }
  if (!result.branches.empty()) return result;
  if (const auto least = transverse_angle_at_min_distance(gears)) {
    const CrossedPlace place = crossed_place(gears, *least);
    result.nearest_distance = place.center_distance;
    result.nearest_shaft_angle = place.shaft_angle;
    result.reason = fmt::format(
        "the minimum centre distance of these gears is {} mm, at the shaft angle {}°; thinner "
        "teeth (less profile shift) permit a smaller distance",
        format_number(place.center_distance, a), format_number(place.shaft_angle.deg()));
  } else {
    result.reason =
        "these teeth are so thin that no shaft angle gives the centre distance of the spec, and "
        "there is no minimum centre distance without backlash; more profile shift would help";
  }
  return result;
}

// Computes the position of gears whose helix angles, shifts and racks are known.
Result<Fit> place_of_gears(const FitProblem& p) {
  const std::array<double, 2> shift{*p.shift[0], *p.shift[1]};
  const BasePair<double> gears = base_gears(p);
  if (axes_are_parallel(gears)) {
    if (p.working_normal_pressure_angle) return one_condition_too_many();
    return place_on_parallel_axes(p, gears, shift);
  }
  if (p.working_normal_pressure_angle) {
    const double alpha_n = p.working_normal_pressure_angle->rad();
    if (p.center_distance || p.shaft_angle) return one_condition_too_many();
    for (const BaseGear<double>& gear : gears) {
      if (has_rack(gear, alpha_n)) continue;
      return refused("fit.working_normal_pressure_angle", Angle::radians(alpha_n).deg(),
                     {90 - std::abs(Angle::radians(gear.helix_angle).deg())},
                     "must be less than {}°, which is 90° minus the base helix angle");
    }
    const int g = limiting_gear(gears);
    const double alpha = std::asin(std::sin(alpha_n) / std::cos(gears[g].helix_angle));
    const CrossedPlace place = crossed_place(gears, alpha);
    if (place.center_distance > 0.0) return Fit{{branch_at(p, shift, place)}, {}, {}, {}};
    return Fit{{},
               "the teeth are too thin for any backlash-free centre distance at this angle; more "
               "profile shift would help",
               {},
               {}};
  }
  if (p.center_distance && !p.shaft_angle) return angles_of_distance(p, gears, shift);
  auto place = complete_place(gears, std::nullopt, p.shaft_angle);
  if (!place) return place.error();
  const auto rack = common_rack(gears, angles_at_shaft_angle(gears, place->shaft_angle->rad()));
  const double a = place->center_distance;
  if (p.center_distance && std::abs(*p.center_distance - a) > kSameDistance * a) {
    Fit result = angles_of_distance(p, gears, shift);
    if (!result.branches.empty()) result.nearest_shaft_angle = result.branches[0].shaft_angle;
    for (const FitBranch& b : result.branches) {
      if (abs(b.shaft_angle - *p.shaft_angle) < abs(*result.nearest_shaft_angle - *p.shaft_angle))
        result.nearest_shaft_angle = b.shaft_angle;
    }
    result.branches.clear();
    result.nearest_distance = a;
    result.reason = fmt::format(
        "at this shaft angle these gears are free of backlash only at a centre distance of {} mm; "
        "leave out one profile shift, the shaft angle or the centre distance to have the omitted "
        "value computed",
        format_number(a, *p.center_distance));
    return result;
  }
  return Fit{
      {branch_at(p, shift, {a, *place->shaft_angle, Angle::radians(rack.normal_pressure_angle)})},
      {},
      {},
      {}};
}

// Computes the sum of the shifts for gears whose helix angles and position are known.
Result<Fit> shifts_of_place(const FitProblem& p) {
  if (!p.center_distance) {
    return absent_input("pair.center_distance",
                        "; give the centre distance to have an absent profile shift computed, or "
                        "give both profile shifts to have the centre distance computed");
  }
  if (p.working_normal_pressure_angle) return one_condition_too_many();
  const BasePair<double> gears = base_gears(p);
  const bool parallel = axes_are_parallel(gears);
  std::optional<Angle> shaft_angle = p.shaft_angle;
  if (!parallel && !shaft_angle) {
    // By default, Σ is the shaft angle for which the given centre distance is the least possible
    // centre distance of the gears.
    const auto alpha = transverse_angle_at_pitch_sum(gears, *p.center_distance);
    if (!alpha) {
      Fit none;
      none.reason = refused("", *p.center_distance, {base_radius_sum(gears)},
                            "the centre distance must be greater than {} mm, the sum of the base "
                            "radii")
                        .rule;
      none.nearest_distance = base_radius_sum(gears);
      return none;
    }
    shaft_angle = crossed_place(gears, *alpha).shaft_angle;
  }
  ShiftProblem s;
  s.z1 = p.teeth[0];
  s.z2 = p.teeth[1];
  s.normal_module = p.normal_module;
  s.normal_pressure_angle = p.normal_pressure_angle;
  s.helix_angle = {*p.helix[0], *p.helix[1]};
  if (!parallel) s.shaft_angle = shaft_angle;
  s.x1 = p.shift[0];
  s.x2 = p.shift[1];
  s.center_distance = p.center_distance;
  const auto solved = complete_shifts(s);
  if (!solved) return solved.error();
  const double a = *p.center_distance;
  const auto angles = parallel ? angles_at_parallel_distance(gears, a)
                               : angles_at_shaft_angle(gears, shaft_angle->rad());
  return Fit{{{{*p.helix[0], *p.helix[1]},
               {solved->x1, solved->x2},
               a,
               parallel ? Angle() : *shaft_angle,
               Angle::radians(std::atan2(angles.sin_alpha, angles.cos_alpha))}},
             {},
             {},
             {}};
}

}  // namespace

Result<Fit> fit(const FitProblem& p) {
  if (p.teeth[1] < 0 && p.shaft_angle && p.shaft_angle->rad() != 0.0) {
    return refused("pair.shaft_angle", p.shaft_angle->deg(),
                   "must be 0, because the command `gearwright fit` supports internal pairs only "
                   "on parallel axes. If helix angles and profile shifts are given, the command "
                   "`gearwright pair` computes the centre distance at this angle");
  }
  const bool helices = p.helix[0] && p.helix[1];
  const bool shifts = p.shift[0] && p.shift[1];
  if (helices) {
    // Gears that cannot mesh at this shaft angle at any centre distance are rejected first.
    const auto specs = specs_of(p);
    if (auto error = check_partners(specs[0], specs[1], p.shaft_angle)) return *error;
    return shifts ? place_of_gears(p) : shifts_of_place(p);
  }
  for (const auto& [known, field] :
       {std::pair{p.center_distance.has_value(), "pair.center_distance"},
        std::pair{p.shaft_angle.has_value(), "pair.shaft_angle"}}) {
    if (known) continue;
    return absent_input(
        field, "; both centre distance and shaft angle are needed to compute the helix angles");
  }
  return min_distance_designs(p);
}

}  // namespace gearwright
