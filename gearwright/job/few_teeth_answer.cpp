#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/cut_gears.hpp"
#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/design/few_teeth_design.hpp"
#include "gearwright/job/fit_answer.hpp"
#include "gearwright/pair/partners.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

constexpr double kMaxContact = 20.0;  // greater than any real transverse contact ratio
constexpr const char* kChosen =
    "cannot be combined with `fit.few_teeth` = true, which determines this value; leave out this "
    "key";

// Returns the error for the first value of the spec that few_teeth itself determines or does not
// permit. Returns none if the spec gives no such value.
std::optional<Error> out_of_place(const JobSpec& spec) {
  for (const int which : {1, 2}) {
    const GearInput& g = spec.gear(which);
    const char* const chosen = g.cut_by                   ? "cut_by"
                               : g.basic                  ? "basic"
                               : g.cylindrical.tip_fillet ? "tip_fillet"
                               : g.tip_clearance          ? "tip_fillet"
                                                          : nullptr;
    if (chosen) return Error{gear_field(which, chosen), "", kChosen};
    if (const auto& d_a = g.cylindrical.tip_diameter)
      return refused(gear_field(which, "tip_diameter"), *d_a, kChosen);
  }
  const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(a); };
  for (const int which : {1, 2}) {
    if (const double E = spec.gear(which).cylindrical.thickness_allowance; E != 0.0)
      return refused(gear_field(which, "thickness_allowance"), E,
                     "cannot be combined with `fit.few_teeth` = true; give `fit.backlash` instead");
  }
  const CylindricalSpec& pinion = spec.gear(1).cylindrical;
  const GearInput& wheel = spec.gear(2);
  const CylindricalSpec& teeth = wheel.cylindrical;
  if (differs(pinion.normal_module, teeth.normal_module))
    return refused("gear2.normal_module", teeth.normal_module,
                   "must equal the value of gear 1, which cuts gear 2");
  if (differs(pinion.normal_pressure_angle.deg(), teeth.normal_pressure_angle.deg()))
    return refused("gear2.normal_pressure_angle", teeth.normal_pressure_angle.deg(),
                   "must equal the value of gear 1, which cuts gear 2");
  if (wheel.helix_given)
    return refused("gear2.helix_angle", teeth.helix_angle.deg(),
                   "is determined by gear 1; leave out this key");
  if (wheel.face_width_given)
    return refused("gear2.face_width", teeth.face_width,
                   "is always equal to the face width of gear 1; leave out this key");
  if (spec.pair.shorten_tips || spec.pair.mounting == Mounting::extended)
    return Error{spec.pair.shorten_tips ? "pair.shorten_tips" : "pair.mounting",
                 spec.pair.shorten_tips ? "true" : "extended",
                 "cannot be combined with `fit.few_teeth` = true, which determines tips and centre "
                 "distance; leave out this key"};
  if (const auto& alpha = spec.fit.working_normal_pressure_angle)
    return refused("fit.working_normal_pressure_angle", alpha->deg(),
                   "cannot be combined with `few_teeth` = true");
  if (const auto& ratio = spec.fit.contact_ratio; ratio && *ratio > kMaxContact)
    return refused("fit.contact_ratio", *ratio, fmt::format("must be at most {}", kMaxContact));
  if (teeth.root_fillet)
    return Error{
        "gear2.root_fillet", "",
        "is determined by the pinion, which cuts the root of the wheel; leave out this key"};
  if (const auto x = wheel.given_shift()) return refused("gear2.profile_shift", *x, kChosen);
  if (pinion.teeth < 0) return internal_gear_1(pinion.teeth, teeth.teeth);
  if (const auto& sigma = spec.pair.shaft_angle; sigma && sigma->rad() != 0.0)
    return refused(
        "pair.shaft_angle", sigma->deg(),
        "must be 0 or absent, because gears with few teeth are designed for parallel axes");
  return std::nullopt;
}

// Rounds a value to nine decimals, as on a drawing. This removes the rounding errors of unit
// conversions.
double drawn(double v) { return std::stod(fmt::format("{:.9f}", v)); }

// Rounds the profile shift to nine decimals if this changes it by less than 1e-12. A shift that was
// computed from a centre distance keeps all its digits.
double shift_as_drawn(double x) { return std::abs(drawn(x) - x) < 1e-12 ? drawn(x) : x; }

// Rounds the tip diameter to 0.1 µm in the direction of the shorter tooth.
double tip_as_drawn(double d, double side) { return side * std::floor(side * d * 1e4) / 1e4; }

Json pinion_json(const CylindricalSpec& c, const Json& given) {
  constexpr const char* kPitch = "normal_diametral_pitch_per_in";
  Json g;
  g["teeth"] = c.teeth;
  if (given.contains(kPitch)) {
    g[kPitch] = given[kPitch];
  } else {
    g["normal_module_mm"] = c.normal_module;
  }
  g["normal_pressure_angle_deg"] = drawn(c.normal_pressure_angle.deg());
  g["helix_angle_deg"] = drawn(c.helix_angle.deg());
  g["profile_shift"] = drawn(c.profile_shift);
  if (c.tip_diameter) g["tip_diameter_mm"] = tip_as_drawn(*c.tip_diameter, side_of(c.teeth));
  g["root_fillet"] = {{"kind", "circular"}, {"offset_mm", drawn(c.root_fillet->offset)}};
  if (c.tip_fillet)
    g["tip_fillet"] = {{"kind", "circular"}, {"radius_mm", drawn(c.tip_fillet->value)}};
  return g;
}

// Returns the spec with the computed numbers in place of [fit]. Title, bore and rack are copied.
Json spec_of(const JobSpec& spec, const FewTeethDesign& d) {
  const Json& given = spec.tree->tables;
  Json tree;
  if (given.contains("title")) tree["title"] = given["title"];
  Json pinion = pinion_json(d.pinion, given["gear1"]);
  pinion["face_width_mm"] = d.face_width;
  Json wheel{{"teeth", d.pair.gears[1].spec.teeth},
             {"profile_shift", shift_as_drawn(d.wheel_shift)}};
  wheel["face_width_mm"] = d.face_width;
  wheel["tip_diameter_mm"] = tip_as_drawn(d.wheel_tip_diameter, d.pair.gears[1].side());
  wheel["cut_by"] = pinion_json(d.cutter, given["gear1"]);
  for (Json* g : {&pinion, &wheel}) {
    const char* name = g == &pinion ? "gear1" : "gear2";
    if (given[name].contains("bore")) (*g)["bore"] = given[name]["bore"];
    if (!given["gear1"].contains("rack")) continue;
    (g == &pinion ? pinion : wheel["cut_by"])["rack"] = given["gear1"]["rack"];
  }
  tree["gear1"] = pinion;
  tree["gear2"] = wheel;
  tree["pair"]["center_distance_mm"] = d.center_distance;
  return tree;
}

std::optional<Error> bore_too_large(const JobSpec& spec, const FewTeethDesign& d) {
  for (const int which : {1, 2}) {
    const Gear& gear = d.pair.gears[which - 1];
    const auto& bore = spec.gear(which).bore;
    if (!bore) continue;
    auto error = body_error(gear, bore);
    if (!error) continue;
    error->rule +=
        " of the design for this spec; without this bore, the command `gearwright fit` prints the "
        "design";
    return of_gear(which, *error);
  }
  return std::nullopt;
}

// Returns a sentence about the backlash and the tip clearances of the design. The backlash of [fit]
// is circumferential, but the backlash of the pair is measured in the normal section.
std::string remark_of(const FewTeethDesign& d) {
  const auto& c = d.pair.tip_clearance;
  const auto& j = d.pair.mesh.backlash;
  return fmt::format(
      "The backlash is {:.4f} mm along the working pitch circles and {:.4f} mm in the normal "
      "section. The centre distance is increased for this backlash, so the tip clearances are "
      "{:.4f} mm and {:.4f} mm.",
      j.circumferential[0], j.normal, c[0], c[1]);
}

}  // namespace

Result<FitAnswer> answer_few_teeth(const JobSpec& spec, Progress* progress) {
  if (auto error = out_of_place(spec)) return *error;
  const GearInput& g1 = *spec.gears[0];
  const GearInput& g2 = *spec.gears[1];
  if (auto error = check_limits(g1.cylindrical)) return of_gear(1, *error);
  FewTeethProblem p;
  p.progress = progress;
  p.teeth = {g1.cylindrical.teeth, g2.cylindrical.teeth};
  p.normal_module = g1.cylindrical.normal_module;
  p.normal_pressure_angle = g1.cylindrical.normal_pressure_angle;
  if (g1.helix_given) p.helix = g1.cylindrical.helix_angle;
  p.center_distance = spec.pair.center_distance;
  p.pinion_shift = g1.given_shift();
  const double m = p.normal_module;
  p.rack = g1.cylindrical.straight_rack();
  p.root_offset = g1.cylindrical.root_fillet ? g1.cylindrical.root_fillet->offset : 0.01 * m;
  p.min_tip_land = spec.fit.min_tip_land.value_or(0.0);
  p.min_gap = spec.fit.min_gap.value_or(0.0);
  p.clearance = spec.fit.clearance.value_or(default_tip_clearance(m));
  p.backlash = spec.fit.backlash.value_or(0.0);
  p.contact_ratio = spec.fit.contact_ratio.value_or(1.2);
  if (g1.face_width_given) p.face_width = g1.cylindrical.face_width;
  auto found = design_few_teeth(p);
  if (!found) return found.error();
  FitAnswer answer;
  if (!found->design) {
    answer.fit.reason = fmt::format(
        "none of {} pairs of profile shifts is feasible, and the best pair is ruled out by {}",
        found->candidates, spelled(found->limit, spec.given, "gear1"));
    return answer;
  }
  const FewTeethDesign& d = *found->design;
  if (auto error = bore_too_large(spec, d)) return *error;
  if (p.backlash > 0.0) answer.remark = remark_of(d);
  add_branch(answer,
             {{d.pinion.helix_angle, d.pair.gears[1].spec.helix_angle},
              {d.pinion.profile_shift, d.wheel_shift},
              d.center_distance,
              Angle(),
              Angle::radians(d.pair.mesh.rack.normal_pressure_angle)},
             spec_of(spec, d), d.pair.mesh.true_ratio);
  return answer;
}

}  // namespace gearwright
