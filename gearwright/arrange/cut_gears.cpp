#include "gearwright/arrange/cut_gears.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "gearwright/base/subject.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

constexpr double kSameTip = 1e-9;  // mm; a smaller difference of tip diameters is rounding

std::optional<Error> check_cutters(const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->cut_by || gear->cut_by->gear == 0) continue;
    const int by = gear->cut_by->gear;
    const GearInput* const cutter = given.find(by);
    const auto fail = [&](const std::string& why) {
      return Error{gear_field(which, "cut_by"), gear_field(by), why};
    };
    if (by == which) return fail("a gear cannot cut itself; give the other gear or a cutter");
    if (!cutter) return fail(fmt::format("there is no `{}` in this spec", gear_field(by)));
    if (cutter->cut_by && cutter->cut_by->gear == which) {
      return fail(fmt::format(
          "is itself cut by this gear (`{}`); one of the two gears needs its own rack or cutter",
          gear_field(by, "cut_by")));
    }
    if (cutter->cylindrical.teeth < 0) return fail("an internal gear cannot be a pinion cutter");
    if (cutter->tip_clearance || cutter->tip_clearance_by_rule) {
      return Error{
          gear_field(by, "tip_fillet.clearance"), "",
          fmt::format(
              "the tip of this gear cuts gear {}, so there is no clearance between them; give "
              "`radius` or `l` instead, or give gear {} its own cutter with a longer tip, "
              "or give a centre distance greater than the generating distance",
              which, which)};
    }
  }
  return std::nullopt;
}

// Checks that a given value agrees with the value that the cutter determines.
std::optional<Error> check_agreement(const GearInput& gear, const Gear& made, int which) {
  const auto differs = [](const std::optional<double>& given, double value) {
    return given && std::abs(*given - value) > 1e-9 * std::max(1.0, std::abs(value));
  };
  const auto fail = [&](const char* member, double given, double value) {
    return refused(gear_field(which, member), given, {value},
                   "contradicts `cut_by`, which determines the value {}; leave out one of the two");
  };
  const CylindricalSpec& s = made.spec;
  if (differs(gear.cut_by->module, s.normal_module))
    return fail("normal_module", *gear.cut_by->module, s.normal_module);
  if (const auto given = gear.cut_by->pressure_angle;
      given && differs(given->deg(), s.normal_pressure_angle.deg()))
    return fail("normal_pressure_angle", given->deg(), s.normal_pressure_angle.deg());
  if (gear.helix_given && differs(gear.cylindrical.helix_angle.deg(), s.helix_angle.deg()))
    return fail("helix_angle", gear.cylindrical.helix_angle.deg(), s.helix_angle.deg());
  return std::nullopt;
}

// Returns the spec of a gear's own cutter. A profile shift that is not given is 0.
CylindricalSpec own_cutter(const CutByInput& cut) {
  CylindricalSpec spec = cut.cutter->cylindrical;
  spec.profile_shift = cut.cutter->given_shift().value_or(0.0);
  return spec;
}

// Returns the default profile shift of a gear that has its own cutter. The default applies if
// neither the profile shift of the gear nor `profile_shift_pair` (e) is given. With the default
// shift, the gear meshes with its mating gear without backlash at the given centre distance.
// Returns none if no centre distance is given, if there is no mating gear with its own rack, or if
// no such shift exists.
std::optional<double> shift_at_distance(const GivenPair& given, const Gear& cutter, int which) {
  const GearInput* const mate = given.find(3 - which);
  const auto& gear = given.gear(which);
  if (!mate || !given.pair.center_distance || gear.cut_by->gear != 0) return std::nullopt;
  if (mate->cut_by) return std::nullopt;
  const CylindricalSpec& c = cutter.spec;
  const int z = gear.cylindrical.teeth;
  const int z_m = mate->cylindrical.teeth;
  if (z + z_m == 0 || (z < 0 && -z < z_m) || (z_m < 0 && -z_m < z)) return std::nullopt;
  const double cos_beta = std::cos(c.helix_angle.rad());
  const double alpha_t = cutter.reference().transverse_pressure_angle;
  const double a = *given.pair.center_distance;
  const double a_d = reference_center_distance(z, z_m, c.normal_module, cos_beta);
  if (a < a_d * std::cos(alpha_t)) return std::nullopt;  // mount() reports this error later
  const double sum =
      tight_shift_sum(z, z_m, c.normal_module, c.normal_pressure_angle.rad(), alpha_t, cos_beta, a);
  return sum - mate->cylindrical.profile_shift;
}

Result<double> distance_of(const GivenPair& given, const Gear& cutter, int which) {
  const auto& gear = given.gear(which);
  const CutByInput& cut = *gear.cut_by;
  const double x_0 = cutter.reference().generating_profile_shift;
  const int z = gear.cylindrical.teeth;
  if (auto error = check_cutter(cutter, z)) return *error;
  if (cut.profile_shift_pair) {
    auto e = generating_distance(cutter, z, *cut.profile_shift_pair - x_0);
    if (e) return e;
    return following_from(
        "profile_shift_pair", format_number(*cut.profile_shift_pair),
        fmt::format("together with the profile shift {} of the cutter, this value requires",
                    format_number(x_0)),
        e.error());
  }
  if (const auto x = gear.given_shift()) return generating_distance(cutter, z, *x);
  if (cut.gear != 0 && given.pair.center_distance) return *given.pair.center_distance;
  if (const auto x = shift_at_distance(given, cutter, which))
    return generating_distance(cutter, z, *x);
  return generating_distance(cutter, z, -x_0);
}

// Makes the gear at the generating distance in `spec`. If a gear with its own cutter has a
// thickness allowance, the distance follows instead from the generating profile shift x_E, which
// includes the allowance.
Result<Gear> made_at(const Gear& cutter, const GearInput& gear, PinionCutSpec spec) {
  auto nominal = make_pinion_cut_gear(cutter, spec);
  const double wanted = gear.cylindrical.thickness_allowance;
  if (!nominal || gear.cut_by->gear != 0 || wanted == 0.0) return nominal;
  spec.profile_shift = gear.given_shift().value_or(nominal->spec.profile_shift);
  const auto made_with = [&](double allowance) -> Result<Gear> {
    spec.thickness_allowance = allowance;
    const auto e = generating_distance(cutter, spec.teeth,
                                       *spec.profile_shift + shift_of_allowance(cutter, allowance));
    if (!e) return e.error();
    spec.distance = *e;
    return make_pinion_cut_gear(cutter, spec);
  };
  auto made = made_with(wanted);
  if (made) return made;
  const double limit = nearest_possible(
      0.0, wanted, [&](double allowance) { return static_cast<bool>(made_with(allowance)); });
  Error error =
      refused("thickness_allowance", wanted, {limit},
              fmt::format("must be at {} {{}} mm, because ", wanted > 0.0 ? "most" : "least"));
  error.rule +=
      subject_of(made.error().field).member == GearMember::tip_diameter
          ? fmt::format("this value requires {}", made.error().quoted())
          : fmt::format("this cutter cannot cut {} teeth", wanted > 0.0 ? "thicker" : "thinner");
  return error;
}

// Adds a note if no tip diameter is given and the tip, which the root of the cutter cuts, is longer
// than usual. No note is added if the mating gear is the cutter.
void note_default_tip(Gear& made, const GearInput& gear) {
  const double usual =
      made.reference_diameter + made.side() * 2 * made.spec.normal_module *
                                    (addendum_of(gear.cylindrical.rack) + made.spec.profile_shift);
  const double longer = made.side() * (made.tip_diameter - usual);
  if (gear.cut_by->gear != 0 || gear.cylindrical.tip_diameter || !(longer > kSameTip)) return;
  made.warnings.push_back(
      {WarningCode::tip_cut_by_rack,
       fmt::format("`tip_diameter` is not given, so the root of the cutter cuts the tip to a "
                   "diameter of {:.4f} mm. Usual cutters do not cut the tip; the usual tip "
                   "diameter of this gear is {:.4f} mm.",
                   made.tip_diameter, usual)});
}

// Adds a note if the gear's own cutter does not reach its given tip diameter, because the rack that
// cuts the cutter ends its teeth.
void note_cutter_tip(Gear& made, const Gear& cutter) {
  if (!cutter.spec.tip_diameter || !cutter.tooth || !cutter.tooth->tip_cut_by_rack) return;
  made.warnings.push_back(
      {WarningCode::tip_cut_by_rack,
       fmt::format(
           "The teeth of the cutter in `cut_by` do not reach its `tip_diameter`, {:.4f} mm. "
           "The bottom land of the rack that cuts them ends them at a diameter of {:.4f} "
           "mm; a greater `cut_by.rack.addendum` leaves longer teeth.",
           cutter.tip_diameter, 2 * cutter.tooth->tip_radius)});
}

// Adds a warning if the gear's own cutter is pointed below its given tip diameter. The cutter then
// cuts a shallower root than its tip diameter promises.
void warn_of_pointed_cutter(Gear& made, const Gear& cutter) {
  if (!cutter.spec.tip_diameter || !cutter.pointed()) return;
  made.warnings.push_back(
      {WarningCode::pointed,
       fmt::format("The teeth of the cutter in `cut_by` are pointed and end at a diameter of "
                   "{:.4f} mm, so they do not reach its `tip_diameter`, {:.4f} mm. The cutter is "
                   "used as it ends, and the root diameter of the gear is {:.4f} mm.",
                   2 * cutter.actual_tip_radius(), cutter.tip_diameter, made.root_diameter)});
}

// Returns the greatest number of teeth, less than the given number, with which the gear's own cutter
// can cut the gear in `wanted`. Returns none if none of the next kTries numbers is possible.
std::optional<int> greatest_cutter(const GivenPair& given, int which, PinionCutSpec wanted) {
  constexpr int kTries = 64;
  CylindricalSpec c = own_cutter(*given.gear(which).cut_by);
  if (c.tip_diameter) return std::nullopt;  // it belongs to the number of teeth
  const int given_teeth = c.teeth;
  for (c.teeth = given_teeth - 1; c.teeth > std::max(0, given_teeth - kTries); --c.teeth) {
    const auto cutter = make_gear(c);
    if (!cutter || !cutter->exists()) continue;
    const auto distance = distance_of(given, *cutter, which);
    if (!distance) continue;
    wanted.distance = *distance;
    const auto made = make_pinion_cut_gear(*cutter, wanted);
    if (made && made->exists()) return c.teeth;
  }
  return std::nullopt;
}

std::optional<Error> make_cut_gear(GivenPair& given, int which, MadeGears& made) {
  GearInput& gear = given.gear(which);
  CutByInput& cut = *gear.cut_by;
  std::optional<Gear> own;
  if (cut.gear == 0) {
    auto cutter = make_gear(own_cutter(cut));
    if (!cutter) return of_given_gear(within("cut_by", cutter.error()), given, which);
    own = std::move(cutter).take();
  }
  const Gear& cutter = own ? *own : *made[cut.gear - 1];
  if (!cutter.exists()) {
    return Error{gear_field(which, "cut_by"), "",
                 "the cutter is not a possible gear. " + cutter.warnings.back().message};
  }
  auto distance = distance_of(given, cutter, which);
  if (!distance) return of_given_gear(distance.error(), given, which);
  const double face =
      gear.face_width_given ? gear.cylindrical.face_width : 10 * cutter.spec.normal_module;
  const bool by_distance =
      cut.gear != 0 && given.pair.center_distance && !cut.profile_shift_pair && !gear.shift_given;
  const PinionCutSpec wanted{gear.cylindrical.teeth, *distance, face,
                             gear.cylindrical.tip_diameter};
  auto result = made_at(cutter, gear, wanted);
  if (!result) {
    Error error = result.error();
    if (own && error.value.empty() && subject_of(error.field).member == GearMember::cutter) {
      error.field = "cut_by.teeth";
      error.value = fmt::format("{}", own->spec.teeth);
      if (const auto teeth = greatest_cutter(given, which, wanted))
        error.rule += fmt::format("; a similar cutter with {} teeth cuts the gear", *teeth);
    }
    if (!by_distance || subject_of(error.field).member != GearMember::cutter)
      return of_given_gear(error, given, which);
    // The generating distance is also the centre distance of the pair, so the error names the
    // centre distance.
    return Error{
        "pair.center_distance", error.value,
        "the centre distance is also the generating distance of the cut gear: " + error.rule};
  }
  if (auto error = check_agreement(gear, *result, which)) return error;
  Gear& cut_gear = made[which - 1].emplace(std::move(result).take());
  note_default_tip(cut_gear, gear);
  if (own) {
    note_cutter_tip(cut_gear, *own);
    warn_of_pointed_cutter(cut_gear, *own);
  }
  gear.cylindrical = cut_gear.spec;
  gear.helix_given = true;
  gear.shift_given = true;
  if (cut.gear != 0 && !given.pair.center_distance) given.pair.center_distance = *distance;
  return std::nullopt;
}

}  // namespace

std::optional<Error> make_cut_gears(GivenPair& given, MadeGears& made) {
  if (auto error = check_cutters(given)) return error;
  const auto is_cut = [&](int which) {
    const GearInput* const gear = given.find(which);
    return gear && gear->cut_by.has_value();
  };
  if (!is_cut(1) && !is_cut(2)) return std::nullopt;
  if (given.pair.shorten_tips) {
    return Error{"pair.shorten_tips", "true",
                 fmt::format("cannot be combined with `{}`; give `gear1.tip_diameter` and "
                             "`gear2.tip_diameter`",
                             gear_field(is_cut(1) ? 1 : 2, "cut_by"))};
  }
  const bool mates = (is_cut(1) && given.gears[0]->cut_by->gear != 0) ||
                     (is_cut(2) && given.gears[1]->cut_by->gear != 0);
  if (mates && given.pair.mounting == Mounting::extended) {
    return Error{"pair.mounting", "extended",
                 "is not available if one gear cuts the other, because the pair is then mounted at "
                 "the generating distance; for another distance give `pair.center_distance`"};
  }
  // If one gear cuts the other, the gear that cuts is made first.
  const bool second_first = is_cut(1) && given.gears[0]->cut_by->gear == 2;
  const std::array<int, 2> order = second_first ? std::array{2, 1} : std::array{1, 2};
  for (const int which : order) {
    if (!given.has(which)) continue;
    if (is_cut(which)) {
      if (auto error = make_cut_gear(given, which, made)) return error;
      continue;
    }
    GearInput& gear = given.gear(which);
    if (!is_cut(3 - which) || given.gear(3 - which).cut_by->gear != which) continue;
    gear.shift_given = true;
    auto cutter = make_gear(gear.cylindrical);
    if (!cutter) return of_given_gear(cutter.error(), given, which);
    made[which - 1] = std::move(cutter).take();
  }
  return std::nullopt;
}

std::optional<Error> place_clear_tips(GivenPair& given, const MadeGears& made,
                                      std::optional<double> center_distance) {
  for (const int which : {1, 2}) {
    GearInput* const gear = given.find(which);
    if (!gear || !(gear->tip_clearance || gear->tip_clearance_by_rule)) continue;
    const GearInput* const mate = given.find(3 - which);
    if (!mate || !center_distance) {
      return Error{gear_field(which, "tip_fillet.clearance"), "",
                   "needs a mating gear on a parallel axis; if there is no such gear, give "
                   "`radius` or `l`, which determine the start of the fillet"};
    }
    double root = 0.0;
    if (const auto& done = made[static_cast<std::size_t>(2 - which)]) {
      root = done->root_diameter / 2;
    } else {
      CylindricalSpec bare = mate->cylindrical;
      bare.tip_fillet.reset();
      auto other = make_gear(bare);
      if (!other) return of_given_gear(other.error(), given, 3 - which);
      root = other->root_diameter / 2;
    }
    const double clearance =
        gear->tip_clearance.value_or(default_tip_clearance(gear->cylindrical.normal_module));
    const double side = side_of(mate->cylindrical.teeth);
    gear->cylindrical.tip_fillet =
        TipFilletSpec{TipFilletSpec::By::end_radius, side * (*center_distance - root) - clearance};
  }
  return std::nullopt;
}

Error of_given_gear(Error error, const GivenPair& given, int which) {
  const GearInput& gear = given.gear(which);
  const GearMember of = subject_of(error.field).member;
  const bool own =
      of == GearMember::face_width || of == GearMember::tip_diameter || of == GearMember::teeth;
  if (of == GearMember::tip_diameter && !gear.cylindrical.tip_diameter) {
    // Attributes an error of the computed tip diameter to a given value. If a thickness allowance
    // raises the root, the error names the allowance. In all other cases the error names the
    // profile shift or, if no shift is given, the addendum of the rack.
    const double allowance = gear.cylindrical.thickness_allowance;
    const std::string from = allowance > 0.0    ? "thickness_allowance"
                             : gear.shift_given ? "profile_shift"
                                                : "rack.addendum";
    const double value = allowance > 0.0
                             ? allowance
                             : gear.given_shift().value_or(addendum_of(gear.cylindrical.rack));
    return following_from(gear_field(which, from), format_number(value), "this value requires",
                          of_gear(which, std::move(error)));
  }
  if (!gear.basic || own) return of_gear(which, std::move(error));
  return following_from(
      gear_field(which, "basic"), "",
      fmt::format("for the rack with a pressure angle of {:.6g}° that describes this gear,",
                  gear.cylindrical.normal_pressure_angle.deg()),
      error);
}

Error of_basic(const Error& error, const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->basic) continue;
    const BaseGear<double>& base = *gear->basic;
    for (const auto& [of_rack, own, value] :
         {std::tuple{GearMember::normal_module, "basic.base_diameter", 2 * base.radius},
          std::tuple{GearMember::helix_angle, "basic.base_helix_angle",
                     Angle::radians(base.helix_angle).deg()},
          std::tuple{GearMember::profile_shift, "basic.base_tooth_thickness",
                     base.tooth_thickness}}) {
      if (subject_of(error.field) != Subject{which, of_rack}) continue;
      return following_from(gear_field(which, own), format_number(value),
                            "for the rack that describes this gear,", error);
    }
  }
  return error;
}

Error of_clearance(const Error& error, const GivenPair& given, int which) {
  const GearInput& gear = given.gear(which);
  if (subject_of(error.field) != Subject{which, GearMember::tip_end_radius}) return error;
  const double clearance =
      gear.tip_clearance.value_or(default_tip_clearance(gear.cylindrical.normal_module));
  return {
      gear_field(which, "tip_fillet.clearance"), format_number(clearance),
      fmt::format("the tip would have to end at a radius of {} mm: {}", error.value, error.rule)};
}

Error of_distance(const Error& error, const GivenPair& given) {
  const auto [which, member] = subject_of(error.field);
  if (which == 0 || member != GearMember::profile_shift || !given.pair.center_distance ||
      given.gear(which).shift_given)
    return error;
  Error made = following_from("pair.center_distance", format_number(*given.pair.center_distance),
                              "this value requires", error);
  const CylindricalSpec &a = given.gear(1).cylindrical, &b = given.gear(2).cylindrical;
  if (a.teeth > 0 && b.teeth > 0 && a.helix_angle.rad() == -b.helix_angle.rad())
    made.rule +=
        fmt::format("{} Without profile shifts, the centre distance is {:.4f} mm.",
                    made.rule.ends_with('.') ? "" : ".",
                    a.normal_module * (a.teeth + b.teeth) / 2 / std::cos(a.helix_angle.rad()));
  return not_placed(std::move(made));
}

Error not_placed(Error error) {
  if (error.kind == FailureKind::value) error.kind = FailureKind::placement;
  return error;
}

}  // namespace gearwright
