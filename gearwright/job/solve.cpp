#include "gearwright/job/solved_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "gearwright/cad/bore_loop.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear_field.hpp"
#include "gearwright/gear/ring_cutter.hpp"
#include "gearwright/job/backlash_thinning.hpp"
#include "gearwright/job/cut_gears.hpp"
#include "gearwright/job/default_notes.hpp"
#include "gearwright/job/solve_arcs.hpp"
#include "gearwright/job/tolerance_ends.hpp"

namespace gearwright {

// A gear given by its base cylinder has none of a rack's numbers: it is told what the rack makes of
// it.
Error of_given_gear(Error error, const JobSpec& spec, int which) {
  const GearInput& gear = *spec.gears[static_cast<std::size_t>(which - 1)];
  const bool own =
      error.field == "face_width" || error.field == "tip_diameter" || error.field == "teeth";
  if (error.field == "tip_diameter" && !gear.cylindrical.tip_diameter) {
    // Nobody gave it: it follows from the shift, or from the rack alone.
    const std::string from = gear.profile_shift ? "profile_shift" : "rack.addendum";
    const double value = gear.profile_shift.value_or(addendum_of(gear.cylindrical.rack));
    return following_from(gear_field(which, from), format_number(value), "it asks for",
                          of_gear(which, std::move(error)));
  }
  if (!gear.basic || own) return of_gear(which, std::move(error));
  return following_from(gear_field(which, "basic"), "",
                        fmt::format("on the rack of {:.6g}° that describes this gear",
                                    gear.cylindrical.normal_pressure_angle.deg()),
                        error);
}

namespace {

// A pair names its gears' racks; the numbers of a gear given by its base cylinder are its own.
Error of_basic(const Error& error, const JobSpec& spec) {
  for (const int which : {1, 2}) {
    const auto& gear = spec.gears[static_cast<std::size_t>(which - 1)];
    if (!gear || !gear->basic) continue;
    const BaseGear<double>& base = *gear->basic;
    for (const auto& [of_rack, own, value] :
         {std::tuple{"normal_module", "basic.base_diameter", 2 * base.radius},
          std::tuple{"helix_angle", "basic.base_helix_angle",
                     Angle::radians(base.helix_angle).deg()},
          std::tuple{"profile_shift", "basic.base_tooth_thickness", base.tooth_thickness}}) {
      if (error.field != gear_field(which, of_rack)) continue;
      return following_from(gear_field(which, own), format_number(value),
                            "as a rack describes this gear,", error);
    }
  }
  return error;
}

// Nobody gave the radius at which a tip with a clearance ends.
Error of_clearance(const Error& error, const JobSpec& spec, int which) {
  const GearInput& gear = *spec.gears[static_cast<std::size_t>(which - 1)];
  if (error.field != gear_field(which, "tip_fillet.end_radius")) return error;
  const double clearance =
      gear.tip_clearance.value_or(default_tip_clearance(gear.cylindrical.normal_module));
  return {
      gear_field(which, "tip_fillet.clearance"), format_number(clearance),
      fmt::format("the tip would have to end at a radius of {} mm: {}", error.value, error.rule)};
}

// A shift that nobody gave cannot be to blame: it followed from the centre distance.
Error of_distance(const Error& error, const JobSpec& spec) {
  for (const int which : {1, 2}) {
    if (error.field != gear_field(which, "profile_shift") || !spec.pair.center_distance ||
        spec.gears[static_cast<std::size_t>(which - 1)]->profile_shift)
      continue;
    return following_from("pair.center_distance", format_number(*spec.pair.center_distance),
                          "it asks for", error);
  }
  return error;
}

// Whether the axes cross: the helices decide, and the shaft angle has been checked against them.
bool axes_cross(const JobSpec& spec) {
  return !axes_are_parallel(
      nominal_base_pair(spec.gears[0]->cylindrical, spec.gears[1]->cylindrical));
}

ShiftProblem shift_problem(const JobSpec& spec) {
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  ShiftProblem p;
  p.z1 = c1.teeth;
  p.z2 = c2.teeth;
  p.normal_module = c1.normal_module;
  p.normal_pressure_angle = c1.normal_pressure_angle;
  p.helix_angle = {c1.helix_angle, c2.helix_angle};
  if (axes_cross(spec)) p.shaft_angle = spec.pair.shaft_angle.value_or(Angle());
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

// Shifts and centre distances are completed between gears cut by the same rack angle and module,
// on parallel axes with the same |β| too.
bool share_a_rack(const JobSpec& spec) {
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  return near(c1.normal_module, c2.normal_module) &&
         near(c1.normal_pressure_angle.rad(), c2.normal_pressure_angle.rad());
}

// Tips cut back so that the racks' clearance is kept at this distance: k m_n = σ (a − a_ext).
// [T2.21]
void shorten_tips(JobSpec& spec, double a) {
  double extended = 0.0;
  const double side = spec.gears[1]->cylindrical.teeth > 0 ? 1.0 : -1.0;
  const auto reference_radius = [](const CylindricalSpec& c) {
    return c.normal_module / std::cos(c.helix_angle.rad()) * std::abs(c.teeth) / 2;
  };
  for (const auto& gear : spec.gears) {
    const CylindricalSpec& c = gear->cylindrical;
    extended += (c.teeth > 0 ? side : 1.0) * reference_radius(c);
    extended += side * c.normal_module * c.profile_shift;
  }
  // Never outward: further apart than that the clearance is larger than the racks' anyway.
  const double k_m = std::min(0.0, side * (a - extended));
  for (auto& gear : spec.gears) {
    CylindricalSpec& c = gear->cylindrical;
    if (c.tip_diameter) continue;
    const double sign = c.teeth > 0 ? 1.0 : -1.0;
    c.tip_diameter = 2 * reference_radius(c) +
                     sign * 2 * (c.normal_module * (addendum_of(c.rack) + c.profile_shift) + k_m);
  }
}

// What cannot be had from gears of different racks: x means something else in each of them.
std::optional<Error> needs_one_rack(const JobSpec& spec, bool shift_wanted) {
  const std::string why =
      "needs two gears of the same module and pressure angle; of different racks give both "
      "shifts and the centre distance";
  if (shift_wanted) {
    return Error{gear_field(spec.gears[0]->profile_shift ? 2 : 1, "profile_shift"), "",
                 "is missing, and to find it from the centre distance " + why};
  }
  if (spec.pair.mounting == Mounting::extended) return Error{"pair.mounting", "extended", why};
  if (spec.pair.shorten_tips) return Error{"pair.shorten_tips", "true", why};
  return std::nullopt;
}

// A sum of two shifts is refused by the key that a user wrote; of two, by the larger one.
Error told_of_a_gear(const Error& error, const JobSpec& spec) {
  if (error.field != "profile_shift") return error;
  const auto size = [&](std::size_t i) {
    const auto& x = spec.gears[i]->profile_shift;
    return x ? std::abs(*x) : -1.0;
  };
  const std::size_t i = size(1) > size(0) ? 1 : 0;
  if (size(i) < 0.0) return error;
  return {gear_field(static_cast<int>(i) + 1, "profile_shift"),
          format_number(*spec.gears[i]->profile_shift), error.rule};
}

// Two helices of one hand and angle cross at twice that angle; who gives no shaft angle has
// forgotten a sign more often than meant it.
std::optional<Error> check_hands(const JobSpec& spec) {
  if (spec.pair.shaft_angle) return std::nullopt;
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  const double b1 = c1.helix_angle.deg();
  const double b2 = c2.helix_angle.deg();
  const bool one_angle = b1 != 0.0 && std::abs(b1 - b2) <= 1e-9 * std::abs(b1);
  if (!one_angle || c1.teeth < 0 || c2.teeth < 0) return std::nullopt;
  // Nobody slips who gives base cylinders, which have no helix angle to turn round.
  if (spec.gears[0]->basic || spec.gears[1]->basic) return std::nullopt;
  const std::string opposite =
      spec.given.contains("gear2.hand")
          ? fmt::format("`gear2.hand` = \"{}\"", b2 > 0.0 ? "left" : "right")
          : fmt::format("`gear2.helix_angle` = {}", format_number(-b2));
  return refused("gear2.helix_angle", b2,
                 fmt::format("is of the hand of gear 1. On parallel shafts the hands are opposite, "
                             "{}; if the shafts are to cross, say so: `pair.shaft_angle` = {}",
                             opposite, format_number(2 * b2)));
}

// The place of the pair, after its shifts: absent distance and angle follow from the teeth.
Result<PairPlace> place_of(const JobSpec& spec) {
  return complete_place(nominal_base_pair(spec.gears[0]->cylindrical, spec.gears[1]->cylindrical),
                        spec.pair.center_distance, spec.pair.shaft_angle);
}

// Completes shifts and place of a spec with two gears; `shift_wanted`: one or both are absent and
// follow from the centre distance.
Result<PairPlace> complete_pair(JobSpec& spec, bool shift_wanted) {
  if (auto error = check_hands(spec)) return *error;
  if (auto error = check_partners(spec.gears[0]->cylindrical, spec.gears[1]->cylindrical,
                                  spec.pair.shaft_angle)) {
    return *error;
  }
  const bool crossed = axes_cross(spec);
  const bool extended = spec.pair.mounting == Mounting::extended && !spec.pair.center_distance;
  const bool one_rack = share_a_rack(spec);
  if (!one_rack) {
    if (auto error = needs_one_rack(spec, shift_wanted)) return *error;
  }
  if (crossed && shift_wanted && !spec.pair.shaft_angle) {
    // Neither shifts nor angle: the pair whose minimum centre distance this is.
    const auto gears = nominal_base_pair(spec.gears[0]->cylindrical, spec.gears[1]->cylindrical);
    const double given = *spec.pair.center_distance;
    const auto alpha = transverse_angle_at_pitch_sum(gears, given);
    if (!alpha) {
      return refused(
          "pair.center_distance", given, {base_radius_sum(gears)},
          "there is no working pressure angle; it must be greater than {} mm, the sum of "
          "the base radii");
    }
    spec.pair.shaft_angle = crossed_place(gears, *alpha).shaft_angle;
    spec.shaft_angle_found = true;
  }
  // Gears of one rack on parallel axes meet at a distance of closed form, to the last digit.
  const bool by_shifts = one_rack && (!crossed || shift_wanted || extended);
  std::optional<double> a = spec.pair.center_distance;
  if (by_shifts) {
    auto shifts = complete_shifts(shift_problem(spec));
    if (!shifts) return told_of_a_gear(shifts.error(), spec);
    spec.gears[0]->cylindrical.profile_shift = shifts->x1;
    spec.gears[1]->cylindrical.profile_shift = shifts->x2;
    a = shifts->center_distance;
  }
  JobSpec completed = spec;
  completed.pair.center_distance = a;
  auto place = place_of(completed);
  if (place && spec.pair.shorten_tips) shorten_tips(spec, place->center_distance);
  return place;
}

// A body needs material between its bore and its roots, an internal gear between roots and rim.
std::optional<Warning> warn_about_body(const Gear& gear, const std::optional<Bore>& bore,
                                       int number) {
  if (!bore || !gear.exists()) return std::nullopt;
  const auto warning = [&](const std::string& why) {
    return Warning{
        "no_body",
        fmt::format("A bore of {} mm leaves no body: {}.", format_number(bore->diameter), why),
        number};
  };
  if (!gear.internal()) {
    const auto error = bore_error(*bore, gear.root_diameter / 2);
    return error ? std::optional(warning(error->rule)) : std::nullopt;
  }
  if (bore->diameter > gear.root_diameter) return std::nullopt;
  return warning(fmt::format("the rim of an internal gear must lie outside its roots, beyond {} mm",
                             format_number(gear.root_diameter)));
}

void collect_warnings(SolvedJob& job) {
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    const GearInput& input = *job.spec.gears[i];
    const int number = static_cast<int>(i) + 1;
    if (auto w = warn_about_body(job.gears[i], input.bore, number)) job.warnings.push_back(*w);
    if (!input.face_width_given) {
      job.warnings.push_back({"default_face_width",
                              fmt::format("No `face_width` given: {} mm (10 modules) is used.",
                                          format_number(input.cylindrical.face_width)),
                              number});
    }
    for (Warning w : job.gears[i].warnings) {
      w.gear = number;
      job.warnings.push_back(std::move(w));
    }
  }
  if (auto note = note_inherited(job.spec)) job.warnings.push_back(*note);
  if (auto note = note_shifts(job.spec)) job.warnings.push_back(*note);
  std::vector<std::string> not_read = job.spec.not_read;
  for (const auto& gear : job.spec.gears) {
    if (gear) not_read.insert(not_read.end(), gear->not_read.begin(), gear->not_read.end());
  }
  for (const std::string& what : not_read) {
    job.warnings.push_back(
        {"not_read", what + " is of a part that is not in this version: it was not read.", 0});
  }
  if (!job.pair) return;
  if (job.pair->crossed() && (job.spec.shaft_angle_found || !job.spec.pair.shaft_angle)) {
    job.warnings.push_back(
        {"default_shaft_angle",
         fmt::format(
             "No `pair.shaft_angle` given, and these helix angles do not allow parallel axes: "
             "the pair crosses at {:.6g}°, the angle of its minimum centre distance.",
             job.pair->shaft_angle().deg()),
         0});
  }
  for (const Warning& w : job.pair->warnings()) job.warnings.push_back(w);
}

// Warnings are for the person with the file: the members in them become its keys.
void spell_warnings(SolvedJob& job) {
  for (Warning& w : job.warnings)
    w.message = spelled(w.message, job.spec.given, w.gear == 0 ? "" : gear_field(w.gear));
}

// What nobody said may be what the verb fit is to find: the place, helices, shifts.
bool asks_for_a_fit(const JobSpec& spec, const Error& error) {
  if (!spec.gears[0] || !spec.gears[1]) return false;
  const bool found_by_fit = error.field.starts_with("pair.") ||
                            error.field.ends_with(".helix_angle") ||
                            error.field.ends_with(".profile_shift");
  if (!found_by_fit) return false;
  const bool helices = spec.gears[0]->helix_given || spec.gears[1]->helix_given;
  return spec.given.contains("fit") || (spec.pair.shaft_angle && !helices);
}

Result<SolvedJob> solve_as_given(const JobSpec& given, Scope scope) {
  if (!given.gears[0] && given.measured[0]) {
    return Error{"gear1.normal_module", "",
                 "is missing; the spec has the readings of an unknown gear. gearwright identify "
                 "finds it, and its --take 1 writes the spec that this verb takes"};
  }
  if (!given.gears[0]) {
    return Error{"gear1.teeth", "",
                 "is missing; the spec describes a search. gearwright search finds the "
                 "gears, and its --take 1 writes the pair that this verb takes"};
  }
  SolvedJob job;
  job.spec = given;
  JobSpec& spec = job.spec;
  const bool two = spec.gears[1].has_value();
  if (scope == Scope::pair && !two) {
    return Error{"gear2", "", "is missing; a pair needs a second gear, `gear2`"};
  }
  const bool want_pair = two && scope != Scope::gears;

  const bool arcs = has_arcs(spec);
  if (arcs) {
    if (auto error = check_arcs(spec)) return *error;
  }
  MadeGears made;
  if (auto error = make_cut_gears(spec, made)) return *error;
  bool clear_tips = false;
  for (const int which : {1, 2}) {
    auto& gear = spec.gears[static_cast<std::size_t>(which - 1)];
    if (!gear) continue;
    gear->cylindrical.profile_shift = gear->profile_shift.value_or(0.0);
    clear_tips = clear_tips || gear->tip_clearance || gear->tip_clearance_by_rule;
    if (auto error = check_limits(gear->cylindrical)) return of_given_gear(*error, spec, which);
  }
  std::optional<PairPlace> place;
  const bool shift_wanted = shifts_follow(spec);
  if (two && !arcs &&
      (want_pair || shift_wanted || clear_tips || spec.pair.shorten_tips ||
       wants_backlash(spec.pair))) {
    auto completed = complete_pair(spec, shift_wanted);
    if (!completed) return of_basic(completed.error(), spec);
    if (shift_wanted)
      if (auto error = forbidden_shifts(spec)) return *error;
    place = *completed;
  }
  if (two && wants_backlash(spec.pair)) {
    auto thinned = thin_for_backlash(spec, place, job.warnings);
    if (thinned) return of_basic(of_distance(*thinned, spec), spec);
  }
  if (clear_tips) {
    const bool parallel = place && place->shaft_angle.value_or(Angle()).rad() == 0.0;
    const auto a = parallel ? std::optional(place->center_distance) : std::nullopt;
    if (auto error = place_clear_tips(spec, made, a)) return *error;
  }
  for (std::size_t i = 0; i < (two ? 2u : 1u); ++i) {
    if (made[i]) {
      job.gears.push_back(*std::move(made[i]));
      continue;
    }
    auto gear = make_gear(spec.gears[i]->cylindrical);
    if (!gear) {
      const int which = static_cast<int>(i) + 1;
      const Error error = of_distance(of_given_gear(gear.error(), spec, which), spec);
      return clear_tips ? of_clearance(error, spec, which) : error;
    }
    const bool bare_ring = gear->internal();
    auto cut = bare_ring ? cut_by_default(*gear) : std::nullopt;
    job.gears.push_back(cut ? *std::move(cut) : std::move(gear).take());
  }
  for (std::size_t i = 0; i < job.gears.size(); ++i) job.gears[i].bore = spec.gears[i]->bore;
  if (want_pair) {
    const PairSpec asked{place ? place->center_distance : spec.pair.center_distance,
                         place ? place->shaft_angle : std::nullopt, spec.pair.friction_coefficient,
                         spec.pair.speed_rpm};
    auto pair = mount(job.gears[0], job.gears[1], asked);
    if (!pair) return arcs ? pair.error() : of_basic(of_distance(pair.error(), spec), spec);
    job.pair = std::move(pair).take();
    if (arcs && spec.pair.friction_coefficient)
      spec.not_read.emplace_back("pair.friction_coefficient of circular-arc gears");
  }
  collect_warnings(job);
  spell_warnings(job);
  return job;
}

// The spec with allowances as numbers, solved at their mean and at both ends.
Result<SolvedJob> solve_with_ends(const JobSpec& spec, Scope scope) {
  auto solved = solve_as_given(spec, scope);
  if (!solved) return solved;
  SolvedJob job = std::move(solved).take();
  auto ends = solve_ends(job, scope, solve_as_given);
  if (!ends) return ends.error();
  job.ends = std::move(ends).take();
  return job;
}

Result<SolvedJob> solve_with_tolerances(const JobSpec& given, Scope scope) {
  const bool named = std::any_of(given.gears.begin(), given.gears.end(), [](const auto& gear) {
    return gear && gear->tolerance.says_thickness();
  });
  if (!named) return solve_with_ends(given, scope);
  const auto spec = with_allowances(given, solve_as_given);
  return spec ? solve_with_ends(*spec, scope) : spec.error();
}

}  // namespace

Result<SolvedJob> solve(const JobSpec& given, Scope scope) {
  auto job = solve_with_tolerances(given, scope);
  if (job) {
    SolvedJob solved = std::move(job).take();
    solved.given = std::make_shared<const JobSpec>(given);
    return solved;
  }
  if (!asks_for_a_fit(given, job.error())) return job;
  Error error = job.error();
  error.rule +=
      ". The spec leaves numbers to be found: gearwright fit finds them, and its --take 1 writes "
      "the pair that this verb takes";
  return error;
}

}  // namespace gearwright
