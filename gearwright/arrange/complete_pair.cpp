#include "gearwright/arrange/complete_pair.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/pair/involute_pair.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

namespace {

// True if the axes cross. The helix angles are sufficient to decide this, because the shaft angle
// has already been compared with them.
bool axes_cross(const GivenPair& given) {
  return !axes_are_parallel(
      nominal_base_pair(given.gears[0]->cylindrical, given.gears[1]->cylindrical));
}

ShiftProblem shift_problem(const GivenPair& given) {
  const CylindricalSpec& c1 = given.gears[0]->cylindrical;
  const CylindricalSpec& c2 = given.gears[1]->cylindrical;
  ShiftProblem p;
  p.z1 = c1.teeth;
  p.z2 = c2.teeth;
  p.normal_module = c1.normal_module;
  p.normal_pressure_angle = c1.normal_pressure_angle;
  p.helix_angle = {c1.helix_angle, c2.helix_angle};
  if (axes_cross(given)) p.shaft_angle = given.pair.shaft_angle.value_or(Angle());
  p.x1 = given.gears[0]->given_shift();
  p.x2 = given.gears[1]->given_shift();
  if (!given.pair.center_distance) {
    p.x1 = p.x1.value_or(0.0);
    p.x2 = p.x2.value_or(0.0);
  }
  p.center_distance = given.pair.center_distance;
  p.mounting = given.pair.mounting;
  return p;
}

// Gives the pinion of an internal pair at least the profile shift that avoids undercut, and the
// internal gear the rest of the sum of the shifts. Neither shift is given by the user.
void avoid_undercut(const GivenPair& given, ShiftSolution& shifts) {
  // Greatest sum of the profile shifts at which the pinion gets an additional shift. `shifts.x1` is
  // this sum here, because the pinion has the whole sum. At a greater sum, the tip of the internal
  // gear leaves no room for this shift, and internal pairs with 9 to 25 teeth on the pinion and 30
  // to 90 teeth on the internal gear are worse with it.
  constexpr double kGreatestSum = -0.4;
  const GearInput& pinion = *given.gears[0];
  if (pinion.basic || pinion.cut_by || shifts.x1 > kGreatestSum) return;
  CylindricalSpec unshifted = pinion.cylindrical;
  unshifted.profile_shift = 0.0;
  const auto gear = make_gear(unshifted);
  const auto free = gear ? gear->undercut_free_shift() : std::nullopt;
  if (!free) return;
  // A thickness allowance moves the cutter like a profile shift does. A required backlash thins the
  // pinion by the part of the backlash that `backlash_split` assigns to the pinion.
  const PairInput& p = given.pair;
  const double radius = unshifted.normal_module * unshifted.teeth / 2;  // m_n z/2  mm; the helix is
                                                                        // neglected
  const double backlash = p.backlash_angle
                              ? radius * p.backlash_angle->rad()
                              : p.backlash.value_or(p.backlash_circumferential.value_or(0.0));
  const double thinning = p.backlash_split * backlash - unshifted.thickness_allowance;
  const double per_shift =
      2 * unshifted.normal_module * std::tan(unshifted.normal_pressure_angle.rad());
  const double least = rounded_up(*free + thinning / per_shift, 2);
  if (shifts.x1 >= least) return;
  shifts.x2 += shifts.x1 - least;
  shifts.x1 = least;
}

// True if both racks have the same module and pressure angle. Only then can profile shifts and
// centre distance be computed from each other.
bool share_a_rack(const GivenPair& given) {
  const CylindricalSpec& c1 = given.gears[0]->cylindrical;
  const CylindricalSpec& c2 = given.gears[1]->cylindrical;
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  return near(c1.normal_module, c2.normal_module) &&
         near(c1.normal_pressure_angle.rad(), c2.normal_pressure_angle.rad());
}

// Shortens the tips by k m_n = σ (a − a_ext), so that the tip clearance at the centre distance a
// equals the clearance of the generating racks. a_ext is the extended centre distance. [T2.21]
void shorten_tips(GivenPair& given, double a) {
  double extended = 0.0;
  const double side = side_of(given.gears[1]->cylindrical.teeth);
  const auto reference_radius = [](const CylindricalSpec& c) {
    return c.normal_module / std::cos(c.helix_angle.rad()) * std::abs(c.teeth) / 2;
  };
  for (const auto& gear : given.gears) {
    const CylindricalSpec& c = gear->cylindrical;
    extended += side * side_of(c.teeth) * reference_radius(c);
    extended += side * c.normal_module * c.profile_shift;
  }
  // Tips are never lengthened. At a greater centre distance, the tip clearance exceeds the
  // clearance of the generating racks.
  const double k_m = std::min(0.0, side * (a - extended));
  for (auto& gear : given.gears) {
    CylindricalSpec& c = gear->cylindrical;
    if (c.tip_diameter) continue;
    const double sign = side_of(c.teeth);
    c.tip_diameter = 2 * reference_radius(c) +
                     sign * 2 * (c.normal_module * (addendum_of(c.rack) + c.profile_shift) + k_m);
  }
}

// Returns an error if two different racks cut the gears but the input requires a single rack. A
// single rack is required to compute an absent shift, the extended centre distance and shortened
// tips.
std::optional<Error> needs_one_rack(const GivenPair& given, bool shift_wanted) {
  const std::string why =
      "requires two gears of the same module and pressure angle; for different racks, give both "
      "profile shifts and the centre distance";
  if (shift_wanted) {
    return absent_input(gear_field(given.gears[0]->shift_given ? 2 : 1, "profile_shift"),
                        "; its computation from the centre distance " + why);
  }
  if (given.pair.mounting == Mounting::extended) return Error{"pair.mounting", "extended", why};
  if (given.pair.shorten_tips) return Error{"pair.shorten_tips", "true", why};
  return std::nullopt;
}

// Attributes the error of an invalid sum of the shifts to the given shift or, if both shifts are
// given, to the shift with the greater absolute value.
Error of_given_shift(const Error& error, const GivenPair& given) {
  if (subject_of(error.field).member != GearMember::profile_shift) return error;
  const auto size = [&](std::size_t i) {
    const auto x = given.gears[i]->given_shift();
    return x ? std::abs(*x) : -1.0;
  };
  const std::size_t i = size(1) > size(0) ? 1 : 0;
  if (size(i) < 0.0) return error;
  return {gear_field(static_cast<int>(i) + 1, "profile_shift"),
          format_number(given.gears[i]->cylindrical.profile_shift), error.rule};
}

// Gears with the same hand and the same helix angle β have axes that cross at 2 β. If no shaft
// angle is given, a missing sign is more likely than crossed axes, so this is an error.
std::optional<Error> check_hands(const GivenPair& given) {
  if (given.pair.shaft_angle) return std::nullopt;
  const CylindricalSpec& c1 = given.gears[0]->cylindrical;
  const CylindricalSpec& c2 = given.gears[1]->cylindrical;
  const double b1 = c1.helix_angle.deg();
  const double b2 = c2.helix_angle.deg();
  const bool one_angle = b1 != 0.0 && std::abs(b1 - b2) <= 1e-9 * std::abs(b1);
  if (!one_angle || c1.teeth < 0 || c2.teeth < 0) return std::nullopt;
  // A gear that is given by its base cylinder always has a signed helix angle.
  if (given.gears[0]->basic || given.gears[1]->basic) return std::nullopt;
  const std::string opposite =
      given.gears[1]->hand_given ? fmt::format("`gear2.hand` = \"{}\"", b2 > 0.0 ? "left" : "right")
                                 : fmt::format("`gear2.helix_angle` = {}", format_number(-b2));
  return refused(
      gear_field(2, "helix_angle"), b2,
      fmt::format("has the same hand as gear 1, but parallel shafts need opposite hands; for "
                  "parallel shafts give {}, for crossed shafts give `pair.shaft_angle` = {}",
                  opposite, format_number(2 * b2)));
}

}  // namespace

Result<PairPlace> complete_pair(GivenPair& given, bool shift_wanted) {
  if (auto error = check_hands(given)) return *error;
  if (auto error = check_partners(given.gears[0]->cylindrical, given.gears[1]->cylindrical,
                                  given.pair.shaft_angle)) {
    return *error;
  }
  const bool crossed = axes_cross(given);
  const bool extended = given.pair.mounting == Mounting::extended && !given.pair.center_distance;
  const bool one_rack = share_a_rack(given);
  if (!one_rack) {
    if (auto error = needs_one_rack(given, shift_wanted)) return *error;
  }
  if (crossed && shift_wanted && !given.pair.shaft_angle) {
    // If the shaft angle and at least one profile shift are absent, the given centre distance is
    // taken as the minimum centre distance, which determines the shaft angle.
    const auto gears = nominal_base_pair(given.gears[0]->cylindrical, given.gears[1]->cylindrical);
    const double a = *given.pair.center_distance;
    const auto alpha = transverse_angle_at_pitch_sum(gears, a);
    if (!alpha) {
      return refused("pair.center_distance", a, {base_radius_sum(gears)},
                     "at this centre distance there is no working pressure angle; the centre "
                     "distance must be greater than {} mm, the sum of the base radii");
    }
    given.pair.shaft_angle = crossed_place(gears, *alpha).shaft_angle;
    given.shaft_angle_found = true;
  }
  // If both gears are cut by the same rack, complete_shifts() computes the absent profile
  // shifts or the centre distance. On parallel axes, it is always used, because its closed form
  // gives the centre distance to the last digit. On crossed axes, it is used only for absent
  // shifts or for the extended centre distance.
  const bool by_shifts = one_rack && (!crossed || shift_wanted || extended);
  std::optional<double> a = given.pair.center_distance;
  if (by_shifts) {
    auto found = complete_shifts(shift_problem(given));
    if (!found) return of_given_shift(found.error(), given);
    ShiftSolution shifts = std::move(found).take();
    const bool ring = given.gears[1]->cylindrical.teeth < 0;
    if (ring && shift_wanted && !given.gears[0]->shift_given && !given.gears[1]->shift_given)
      avoid_undercut(given, shifts);
    given.gears[0]->cylindrical.profile_shift = shifts.x1;
    given.gears[1]->cylindrical.profile_shift = shifts.x2;
    a = shifts.center_distance;
  }
  auto place =
      complete_place(nominal_base_pair(given.gears[0]->cylindrical, given.gears[1]->cylindrical), a,
                     given.pair.shaft_angle);
  if (place && given.pair.shorten_tips) shorten_tips(given, place->center_distance);
  return place;
}

namespace {

constexpr double kNear = 1e-12;  // mm or degrees; within this difference, the printed backlash
                                 // equals the requested backlash
constexpr double kSame = 1e-9;   // if the final backlash differs from the requested backlash by
                                 // more, no tooth thickness gives the requested backlash
constexpr int kMostSteps = 12;   // greatest number of secant steps; involute teeth need one step

struct Wanted {
  const char* field;
  double value;  // mm or degrees
  const char* unit;
};

Wanted wanted_of(const PairInput& p) {
  const char* const field = backlash_field(p);
  if (p.backlash) return {field, *p.backlash, " mm"};
  if (p.backlash_circumferential) return {field, *p.backlash_circumferential, " mm"};
  return {field, p.backlash_angle->deg(), "°"};
}

// Splits the total thinning, mm in the normal section, between the two gears, or between the pinion
// and its rack.
void thin(GivenPair& given, double thinning) {
  const double share = given.pair.backlash_split;
  const auto allowance = [&](double of) { return thinning == 0.0 ? 0.0 : -of * thinning; };
  given.gear(1).cylindrical.thickness_allowance = allowance(share);
  (given.rack ? given.rack->thickness_allowance : given.gear(2).cylindrical.thickness_allowance) =
      allowance(1.0 - share);
}

// Returns the backlash of the pair if its teeth are thinned by `thinning` mm in total. The fillets
// of roots and tips have no influence on the backlash and are left out.
Result<double> backlash_at(GivenPair given, const std::optional<PairPlace>& place,
                           double thinning) {
  thin(given, thinning);
  std::vector<Gear> gears;
  for (auto& gear : given.gears) {
    gear->cylindrical.root_fillet.reset();
    gear->cylindrical.tip_fillet.reset();
    auto made = make_gear(gear->cylindrical);
    if (!made) return of_gear(static_cast<int>(gears.size()) + 1, made.error());
    gears.push_back(std::move(made).take());
  }
  const PairSpec at{place ? place->center_distance : given.pair.center_distance,
                    place ? place->shaft_angle : std::nullopt};
  const auto pair = mount(gears[0], gears[1], at);
  if (!pair) return pair.error();
  const auto backlash = backlash_of(*pair);
  if (!backlash) return Error{"pair", "", "has no contact, so its backlash cannot be set"};
  if (given.pair.backlash) return backlash->normal;
  return given.pair.backlash_circumferential ? backlash->circumferential[0]
                                             : backlash->rotation[0].deg();
}

// Returns the error about a requested backlash beyond `limit`, the greatest or least possible
// backlash. `cause` is the error of gears with a backlash beyond this limit.
Error beyond_limit(const Wanted& wanted, double limit, const Error& cause) {
  const bool thinner = wanted.value > limit;
  const auto [which, member] = subject_of(cause.field);
  Error error = refused(
      wanted.field, wanted.value, {limit},
      fmt::format("must be at {} {{}}{}, because ", thinner ? "most" : "least", wanted.unit));
  error.rule += which == 0 || member == GearMember::tip_diameter
                    ? fmt::format("a backlash beyond this limit requires {}", cause.quoted())
                    : fmt::format("the cutters of these gears cannot cut {} teeth",
                                  thinner ? "thinner" : "thicker");
  return error;
}

}  // namespace

const char* backlash_field(const PairInput& pair) {
  if (pair.backlash) return "pair.backlash";
  return pair.backlash_circumferential ? "pair.backlash_circumferential" : "pair.backlash_angle";
}

std::optional<Error> thin_for_backlash(GivenPair& given, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings) {
  GW_EXPECTS(given.pair.wants_backlash() && given.gears[0] && given.gears[1]);
  const Wanted wanted = wanted_of(given.pair);
  double before = 0.0;
  auto at_before = backlash_at(given, place, before);
  if (!at_before) return at_before.error();
  double off_before = *at_before - wanted.value;
  double now = 0.05 * given.gears[0]->cylindrical.normal_module;
  for (int step = 0; step < kMostSteps; ++step) {
    auto at_now = backlash_at(given, place, now);
    // The first step makes the teeth thinner. If this is impossible, and if the backlash must
    // decrease, the search continues with thicker teeth.
    if (!at_now && off_before * (now - before) > 0.0) {
      now = 2 * before - now;
      continue;
    }
    if (!at_now) {
      // The gears cannot be made with this thinning, so the search continues with the nearest
      // thinning with which they can be made. If the backlash at this nearest thinning is already
      // beyond the requested backlash, there is no solution.
      const Error cause = at_now.error();
      now = nearest_possible(before, now, [&](double thinning) {
        return static_cast<bool>(backlash_at(given, place, thinning));
      });
      at_now = backlash_at(given, place, now);
      if ((*at_now - wanted.value) * off_before > 0.0) return beyond_limit(wanted, *at_now, cause);
    }
    const double off = *at_now - wanted.value;
    const double slope = (off - off_before) / (now - before);
    if (std::abs(off) <= kNear * std::max(1.0, wanted.value) || !(slope > 0.0)) break;
    before = now;
    off_before = off;
    now -= off / slope;
  }
  thin(given, now);
  const auto made = backlash_at(given, place, now);
  if (!made || std::abs(*made - wanted.value) > kSame * std::max(1.0, wanted.value))
    return refused(wanted.field, wanted.value,
                   "no tooth thickness of these gears gives this backlash");
  if (auto warning = thickened_warning(given.pair, now)) warnings.push_back(*std::move(warning));
  return std::nullopt;
}

double thin_rack_for_backlash(GivenPair& given, const RackPair& nominal) {
  GW_EXPECTS(given.pair.wants_backlash() && given.rack);
  const PairInput& p = given.pair;
  const double along = p.backlash_angle
                           ? p.backlash_angle->rad() * nominal.pinion.reference_diameter / 2
                           : p.backlash_circumferential.value_or(0.0);
  const double normal = p.backlash ? *p.backlash : along * std::cos(nominal.rack.helix_angle.rad());
  const double thinning = normal - nominal.normal_backlash();
  thin(given, thinning);
  return thinning;
}

Error of_backlash(const Error& error, const GivenPair& given) {
  const Wanted wanted = wanted_of(given.pair);
  return following_from(wanted.field, format_number(wanted.value),
                        fmt::format("it requires thickness allowances of {} mm and {} mm, but",
                                    format_number(given.gear(1).cylindrical.thickness_allowance),
                                    format_number(given.rack->thickness_allowance)),
                        error);
}

std::optional<Warning> thickened_warning(const PairInput& pair, double thinning) {
  if (!(thinning < -kSame)) return std::nullopt;
  const Wanted wanted = wanted_of(pair);
  return Warning{WarningCode::thickened_for_backlash,
                 fmt::format("The centre distance leaves more backlash than `{}` = {}. The teeth "
                             "are therefore made thicker than their profile shifts require, by {} "
                             "mm in total.",
                             wanted.field, format_number(wanted.value), format_number(-thinning)),
                 0};
}

}  // namespace gearwright
