#include "gearwright/job/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

// The library names keys without their table; a user has two gears.
Error in_table(Error error, const std::string& table) {
  if (error.key.rfind("gear1.", 0) == 0 || error.key.rfind("gear2.", 0) == 0) return error;
  error.key = table + "." + error.key;
  error.message = table + "." + error.message;
  return error;
}

ShiftProblem shift_problem(const JobSpec& spec) {
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  ShiftProblem p;
  p.z1 = c1.teeth;
  p.z2 = c2.teeth;
  p.normal_module = c1.normal_module;
  p.normal_pressure_angle = c1.normal_pressure_angle.rad();
  p.cos_beta = std::cos(c1.helix_angle.rad());
  p.transverse_pressure_angle = p.cos_beta == 1.0
                                    ? p.normal_pressure_angle
                                    : std::atan(std::tan(p.normal_pressure_angle) / p.cos_beta);
  p.x1 = spec.gears[0]->profile_shift;
  p.x2 = spec.gears[1]->profile_shift;
  if (!spec.pair.center_distance) {
    p.x1 = p.x1.value_or(0.0);
    p.x2 = p.x2.value_or(0.0);
  }
  p.center_distance = spec.pair.center_distance;
  p.mounting = spec.pair.mounting;
  return p;
}

// Shifts and centre distances are completed between gears cut by the same rack angle and module.
bool share_a_rack(const JobSpec& spec) {
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  const double beta2 = c2.teeth > 0 ? -c2.helix_angle.rad() : c2.helix_angle.rad();
  return near(c1.normal_module, c2.normal_module) &&
         near(c1.normal_pressure_angle.rad(), c2.normal_pressure_angle.rad()) &&
         std::abs(c1.helix_angle.rad() - beta2) <= 1e-9;
}

bool can_be_parallel(const JobSpec& spec) {
  const int z1 = spec.gears[0]->cylindrical.teeth;
  const int z2 = spec.gears[1]->cylindrical.teeth;
  return z1 > 0 && (z2 > 0 || -z2 > z1);
}

// Tips cut back so that the racks' clearance is kept at this distance: k m_n = σ (a − a_ext).
// [T2.21]
void shorten_tips(JobSpec& spec, const ShiftSolution& s) {
  const ShiftProblem p = shift_problem(spec);
  const double extended =
      extended_center_distance(p.z1, p.z2, p.normal_module, p.cos_beta, s.x1 + s.x2);
  // Never outward: further apart than that the clearance is larger than the racks' anyway.
  const double k_m =
      std::min(0.0, p.z2 > 0 ? s.center_distance - extended : extended - s.center_distance);
  for (auto& gear : spec.gears) {
    CylindricalSpec& c = gear->cylindrical;
    if (c.tip_diameter) continue;
    const double sign = c.teeth > 0 ? 1.0 : -1.0;
    const double d = c.normal_module / p.cos_beta * std::abs(c.teeth);
    c.tip_diameter = d + sign * 2 * (c.normal_module * (c.rack.addendum + c.profile_shift) + k_m);
  }
}

// What cannot be had from gears of different racks: x means something else in each of them.
std::optional<Error> needs_one_rack(const JobSpec& spec, bool shift_wanted) {
  const std::string why =
      ": needs two gears of the same module, pressure angle and helix angle on parallel axes; "
      "of different racks give both shifts and the centre distance";
  if (shift_wanted) {
    const std::string key =
        spec.gears[0]->profile_shift ? "gear2.profile_shift" : "gear1.profile_shift";
    return Error{key, "",
                 key + ": is missing, and to find it from the centre distance" + why.substr(1)};
  }
  if (spec.pair.mounting == Mounting::extended)
    return Error{"pair.mounting", "extended", "pair.mounting = \"extended\"" + why};
  if (spec.pair.shorten_tips)
    return Error{"pair.shorten_tips", "true", "pair.shorten_tips = true" + why};
  return std::nullopt;
}

// s_bt without the thickness allowance, which makes backlash and does not move the centre distance.
double nominal_base_thickness(const Gear& gear) {
  const CylindricalSpec& c = gear.spec;
  return reference_geometry<double>({c.teeth, c.normal_module, c.normal_pressure_angle.rad(),
                                     c.helix_angle.rad(), c.profile_shift, 0.0})
      .base_tooth_thickness;
}

void collect_warnings(Design& design) {
  for (std::size_t i = 0; i < design.gears.size(); ++i) {
    const GearInput& input = *design.spec.gears[i];
    const int number = static_cast<int>(i) + 1;
    if (!input.face_width_given) {
      design.warnings.push_back({"default_face_width",
                                 fmt::format("No face_width_mm given: {} mm (10 modules) is used.",
                                             input.cylindrical.face_width),
                                 number});
    }
    for (Warning w : design.gears[i].warnings) {
      w.gear = number;
      design.warnings.push_back(std::move(w));
    }
  }
  std::vector<std::string> not_read = design.spec.not_read;
  for (const auto& gear : design.spec.gears) {
    if (gear) not_read.insert(not_read.end(), gear->not_read.begin(), gear->not_read.end());
  }
  for (const std::string& what : not_read) {
    design.warnings.push_back(
        {"not_read", what + " is of a part that is not in this version: it was not read.", 0});
  }
  if (!design.pair) return;
  for (const Warning& w : design.pair->warnings) design.warnings.push_back(w);
}

}  // namespace

Result<Design> solve(const JobSpec& given, Scope scope) {
  Design design;
  design.spec = given;
  JobSpec& spec = design.spec;
  const bool two = spec.gears[1].has_value();
  if (scope == Scope::pair && !two) {
    return Error{"gear2", "", "gear2: is missing; a pair needs a second table, [gear2]"};
  }
  const bool want_pair = two && scope != Scope::gears;

  for (auto& gear : spec.gears) {
    if (gear) gear->cylindrical.profile_shift = gear->profile_shift.value_or(0.0);
  }
  std::optional<ShiftSolution> shifts;
  const bool shift_wanted = two && spec.pair.center_distance &&
                            (!spec.gears[0]->profile_shift || !spec.gears[1]->profile_shift);
  const bool one_rack = two && can_be_parallel(spec) && share_a_rack(spec);
  if (two && !one_rack && (want_pair || shift_wanted)) {
    if (auto error = needs_one_rack(spec, shift_wanted)) return *error;
  }
  if (one_rack && (want_pair || shift_wanted || spec.pair.shorten_tips)) {
    auto solution = complete_shifts(shift_problem(spec));
    if (!solution) return solution.error();
    shifts = *solution;
    spec.gears[0]->cylindrical.profile_shift = shifts->x1;
    spec.gears[1]->cylindrical.profile_shift = shifts->x2;
    if (spec.pair.shorten_tips) shorten_tips(spec, *shifts);
  }
  for (std::size_t i = 0; i < (two ? 2u : 1u); ++i) {
    auto gear = make_gear(spec.gears[i]->cylindrical);
    if (!gear) return in_table(gear.error(), i == 0 ? "gear1" : "gear2");
    design.gears.push_back(std::move(gear).take());
  }
  if (want_pair) {
    std::optional<double> a =
        shifts ? std::optional(shifts->center_distance) : spec.pair.center_distance;
    if (!a) {
      // Same base pitch from different racks: the distance at which the nominal thicknesses close.
      ParallelMeshInput<double> in = mesh_input(design.gears[0], design.gears[1], 0.0);
      in.base_thickness_1 = nominal_base_thickness(design.gears[0]);
      in.base_thickness_2 = nominal_base_thickness(design.gears[1]);
      const double inv = can_be_parallel(spec) ? backlash_free_involute(in) : 0.0;
      a = inv >= 0.0 ? base_radius_sum(in) / std::cos(inverse_involute(inv)) : base_radius_sum(in);
    }
    auto pair = mount_parallel(design.gears[0], design.gears[1], {*a});
    if (!pair) return pair.error();
    design.pair = std::move(pair).take();
  }
  collect_warnings(design);
  return design;
}

}  // namespace gearwright
