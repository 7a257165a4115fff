#include "gearwright/arrange/arrange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/arrange/complete_pair.hpp"
#include "gearwright/arrange/cut_gears.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/proposed_flanks.hpp"
#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/pinion_cut.hpp"

namespace gearwright {

namespace {

void add_gear_warnings(Arranged& arranged, int which) {
  const GearInput& input = arranged.completed.gear(which);
  const Gear& gear = arranged.gear(which);
  const auto groove =
      input.double_helical ? groove_diameter(gear, *input.double_helical) : std::nullopt;
  if (auto w = body_warning(gear, groove, which)) arranged.warnings.push_back(*w);
  if (!input.face_width_given) {
    arranged.warnings.push_back({WarningCode::default_face_width,
                                 fmt::format("`face_width` is not given; {} mm (10 modules) is "
                                             "used.",
                                             format_number(input.cylindrical.face_width)),
                                 which});
  }
  if (auto note = note_rack(input, which)) arranged.warnings.push_back(*note);
  for (Warning w : arranged.gear(which).warnings) {
    w.gear = which;
    arranged.warnings.push_back(std::move(w));
  }
}

void collect_warnings(Arranged& arranged) {
  const GivenPair& given = arranged.completed;
  for (int which = 1; which <= static_cast<int>(arranged.gears.size()); ++which)
    add_gear_warnings(arranged, which);
  arranged.warnings.insert(arranged.warnings.end(), given.notes.begin(), given.notes.end());
  if (auto note = note_shifts(given)) arranged.warnings.push_back(*note);
  if (!arranged.pair) return;
  if (arranged.pair->crossed() && (given.shaft_angle_found || !given.pair.shaft_angle)) {
    arranged.warnings.push_back(
        {WarningCode::default_shaft_angle,
         fmt::format(
             "`pair.shaft_angle` is not given, and these helix angles do not allow parallel axes. "
             "The pair is mounted at {:.6g}°, the shaft angle at which the pair has its minimum "
             "centre distance.",
             arranged.pair->shaft_angle().deg()),
         0});
  }
  if (auto note = note_saddle(given, *arranged.pair)) arranged.warnings.push_back(*note);
  for (const Warning& w : arranged.pair->warnings()) arranged.warnings.push_back(w);
}

// Sets each profile shift that is not given to 0. A shift that follows from the pair is computed
// later.
void clear_absent_shifts(GivenPair& given) {
  for (const int which : {1, 2}) {
    if (!given.has(which)) continue;
    GearInput& gear = given.gear(which);
    if (!gear.shift_given) gear.cylindrical.profile_shift = 0.0;
  }
}

// Sets the profile shifts and face widths of the gears from the input. Returns true if, for at
// least one gear, a clearance to the root of the mating gear determines the tip.
Result<bool> begin_gears(GivenPair& given) {
  bool clear_tips = false;
  for (const int which : {1, 2}) {
    if (!given.has(which)) continue;
    GearInput& gear = given.gear(which);
    if (!gear.cut_by) gear.complete_face_width();
    clear_tips = clear_tips || gear.tip_clearance || gear.tip_clearance_by_rule;
    if (auto error = check_limits(gear.cylindrical)) return of_given_gear(*error, given, which);
  }
  return clear_tips;
}

Result<Gear> make_given_gear(const GivenPair& given, int which, bool clear_tips) {
  auto gear = make_gear_with_default_cutter(given.gear(which).cylindrical);
  if (!gear) {
    const Error error = of_distance(of_given_gear(gear.error(), given, which), given);
    return clear_tips ? of_clearance(error, given, which) : error;
  }
  return gear;
}

// Returns the least profile shift, rounded up to four decimals, that avoids undercut of a gear
// whose teeth are thinned for a backlash. The thickness allowance depends on the working pressure
// angle and therefore on the shift, so both are found by iteration. Returns none if no such shift
// is found.
std::optional<double> shift_for_backlash(GivenPair given, int which, const Gear& undercut) {
  constexpr int kTries = 8;
  constexpr double kDigits = 1e4;
  const CylindricalSpec& spec = undercut.spec;
  const double per_shift = 2 * spec.normal_module * std::tan(spec.normal_pressure_angle.rad());
  const auto steps_for = [&](double allowance) {
    return std::ceil(kDigits * (*undercut.undercut_free_shift() - allowance / per_shift));
  };
  std::optional<double> least;
  double steps = steps_for(spec.thickness_allowance);
  for (int i = 0; i < kTries; ++i) {
    given.gear(which).give_shift(steps / kDigits);
    const auto made = arrange_nominal(given, Scope::gears);
    if (!made) break;
    const bool free = !made->gear(which).undercut;
    if (free) least = std::min(steps, least.value_or(steps));
    const double next = steps_for(made->gear(which).spec.thickness_allowance);
    if (free && next >= steps) break;
    steps = free ? next : std::max(next, steps + 1.0);
  }
  return least ? std::optional(*least / kDigits) : std::nullopt;
}

// A warning about undercut proposes a profile shift for the present thickness allowance. If the
// allowance follows from a backlash, it changes with the shift. The warning then proposes the shift
// that is computed for this backlash.
void name_shift_for_backlash(Arranged& arranged, const GivenPair& given) {
  if (!given.pair.wants_backlash()) return;
  for (Warning& w : arranged.warnings) {
    if (w.code != WarningCode::undercut) continue;
    const Gear& gear = arranged.gear(w.gear);
    const auto shift =
        gear.undercut_free_shift() ? shift_for_backlash(given, w.gear, gear) : std::nullopt;
    if (!shift) continue;
    w.message = undercut_message(
        gear, fmt::format("with teeth thinned for `{}`, a profile shift of at least {:.4f} avoids "
                          "undercut.",
                          backlash_field(given.pair), *shift));
  }
}

}  // namespace

Result<Arranged> arrange_nominal(const GivenPair& as_given, Scope scope) {
  GW_EXPECTS(as_given.has(1));
  Arranged arranged{as_given};
  GivenPair& given = arranged.completed;
  const bool two = given.has(2);
  const auto unplaced = [&](const Error& error) { return not_placed(of_basic(error, given)); };
  if (scope == Scope::pair && !two)
    return absent_input("gear2", "; a pair needs a second gear, `gear2`");
  const bool want_pair = two && scope != Scope::gears;
  const bool arcs = has_arcs(given);
  if (arcs) {
    if (auto error = check_arcs(given)) return *error;
  }
  clear_absent_shifts(given);
  MadeGears made;
  if (auto error = make_cut_gears(given, made)) return *error;
  const auto clear_tips = begin_gears(given);
  if (!clear_tips) return clear_tips.error();
  std::optional<PairPlace> place;
  const bool shift_wanted = shifts_follow(given);
  if (two && !arcs &&
      (want_pair || shift_wanted || *clear_tips || given.pair.shorten_tips ||
       given.pair.wants_backlash())) {
    auto completed = complete_pair(given, shift_wanted);
    if (!completed) return unplaced(completed.error());
    if (shift_wanted)
      if (auto error = forbidden_shifts(given)) return *error;
    place = *completed;
  }
  if (two && given.pair.wants_backlash()) {
    auto thinned = thin_for_backlash(given, place, arranged.warnings);
    if (thinned) return unplaced(of_distance(*thinned, given));
  }
  if (*clear_tips) {
    const bool parallel = place && place->shaft_angle.value_or(Angle()).rad() == 0.0;
    const auto a = parallel ? std::optional(place->center_distance) : std::nullopt;
    if (auto error = place_clear_tips(given, made, a)) return *error;
  }
  for (int which = 1; which <= (two ? 2 : 1); ++which) {
    auto& cut = made[which - 1];
    auto gear = cut ? Result<Gear>(*std::move(cut)) : make_given_gear(given, which, *clear_tips);
    if (!gear) return gear.error();
    arranged.gears.push_back(std::move(gear).take());
    arranged.gears.back().bore = given.gear(which).bore;
    if (const auto& halves = given.gear(which).double_helical)
      arranged.gears.back().gap = halves->gap;
  }
  const bool starts_follow = lacks_relief_start(given);
  if (starts_follow && !two) return missing_relief_start(given);
  if (want_pair || starts_follow) {
    const PairSpec at{place ? place->center_distance : given.pair.center_distance,
                      place ? place->shaft_angle : std::nullopt, given.pair.friction_coefficient,
                      given.pair.speed_rpm};
    auto pair = mount(arranged.gears[0], arranged.gears[1], at);
    if (!pair) return arcs ? pair.error() : unplaced(of_distance(pair.error(), given));
    if (auto error = place_reliefs(given, *pair)) return *error;
    if (want_pair) arranged.pair = std::move(pair).take();
    if (arcs && given.pair.friction_coefficient)
      given.notes.push_back(not_read("pair.friction_coefficient of circular-arc gears"));
  }
  collect_warnings(arranged);
  return arranged;
}

namespace {

// Makes the pinion and mounts it with the rack. `given` contains the thicknesses of their teeth.
Result<Arranged> mount_on_rack(const GivenPair& given) {
  auto made = arrange(given, Scope::gears);
  if (!made) return made;
  Arranged arranged = std::move(made).take();
  auto pair = mount_rack(arranged.gear(1), *given.rack, given.pair.center_distance,
                         given.pair.speed_rpm, given.pair.friction_coefficient);
  if (!pair) return pair.error();
  arranged.warnings.insert(arranged.warnings.end(), pair->warnings.begin(), pair->warnings.end());
  arranged.rack = std::move(pair).take();
  return arranged;
}

Result<Arranged> arrange_rack(const GivenPair& given) {
  auto nominal = mount_on_rack(given);
  if (!nominal || !given.pair.wants_backlash()) return nominal;
  GivenPair thinned = given;
  const double thinning = thin_rack_for_backlash(thinned, *nominal->rack);
  auto made = mount_on_rack(thinned);
  if (!made) return of_backlash(made.error(), thinned);
  Arranged arranged = std::move(made).take();
  arranged.given = std::make_shared<const GivenPair>(given);
  if (auto warning = thickened_warning(given.pair, thinning))
    arranged.warnings.push_back(*std::move(warning));
  return arranged;
}

}  // namespace

Result<Arranged> arrange(const GivenPair& given, Scope scope) {
  if (given.rack && scope != Scope::gears) return arrange_rack(given);
  auto allowed = with_allowances(given);
  if (!allowed) return allowed.error();
  auto nominal = arrange_nominal(*allowed, scope);
  if (!nominal) return nominal;
  Arranged arranged = std::move(nominal).take();
  name_shift_for_backlash(arranged, *allowed);
  arranged.given = std::make_shared<const GivenPair>(given);
  if (auto error = apply_tip_fits(arranged)) return *error;
  auto ends = arrange_ends(arranged, scope);
  if (!ends) return ends.error();
  arranged.ends = std::move(ends).take();
  return arranged;
}

std::optional<Error> flank_error(const Gear& gear,
                                 const std::array<FlankModifications, 2>& flanks) {
  if (!any_modification(flanks) || !gear.exists() || !gear.root_form_radius() ||
      *gear.root_form_radius() == gear.tip_form_radius())
    return std::nullopt;
  const auto removal = removal_of(gear, flanks);
  return removal ? std::nullopt : std::optional(removal.error());
}

std::optional<Error> check_flanks(const Arranged& arranged) {
  for (std::size_t i = 0; i < arranged.gears.size(); ++i) {
    const int which = static_cast<int>(i) + 1;
    if (auto error = flank_error(arranged.gears[i], arranged.completed.gear(which).modifications))
      return of_gear(which, *std::move(error));
  }
  return std::nullopt;
}

}  // namespace gearwright
