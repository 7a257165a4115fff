#include "gearwright/arrange/tolerance_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/printable.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/span.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright {

namespace {

// Returns the allowance E_sn, mm, of a tooth whose transverse thickness on the base cylinder is
// `base_thickness`. [T10.19]
double allowance_of(const Gear& gear, double base_thickness) {
  const ReferenceGeometry<double>& g = gear.reference();
  return gear.spec.thickness_allowance + (base_thickness - g.base_tooth_thickness) *
                                             g.reference_diameter / g.base_diameter *
                                             std::cos(gear.spec.helix_angle.rad());
}

// Returns an error if a measured dimension requires a thickness allowance of more than half a
// pitch. The dimension is then probably that of another number of spanned teeth or another gear.
std::optional<Error> other_teeth(const Gear& gear, const char* field, double read, double allowance,
                                 const std::string& remedy) {
  const double most = std::numbers::pi / 2 * gear.spec.normal_module;
  if (std::abs(allowance) <= most) return std::nullopt;
  return refused(field, read,
                 fmt::format("does not match this gear, which would need a thickness allowance of "
                             "{:.4f} mm, more than half a pitch ({:.4f} mm); ",
                             allowance, most) +
                     remedy);
}

Result<Ends> of_span(const Gear& gear, const GearInput& input) {
  const auto k = input.measure.span_teeth;
  const auto usual = usual_span(gear);
  if (!k && !usual)
    return Error{"tolerance.span", "",
                 "this gear has no default span that can be measured; give `measure.span_teeth`"};
  const int teeth = k ? *k : usual->teeth;
  const auto span = span_over(gear, teeth);
  if (!span) return within("measure", span.error());
  const Ends& read = *input.tolerance.span;
  const double per = thickness_per_span(gear);
  const auto allowance = [&](double length) {
    return gear.spec.thickness_allowance + (length - span->length) * per;
  };
  Ends ends{allowance(read[0]), allowance(read[1])};
  for (const std::size_t i : {0u, 1u}) {
    const double pitches = (read[i] - span->length) / gear.reference().base_pitch_normal;
    if (auto error = other_teeth(
            gear, "tolerance.span", read[i], ends[i],
            fmt::format(
                "the nominal span over {} teeth is {:.4f} mm, but the given span is nearest to the "
                "span over {:.0f} teeth; check the given span and `measure.span_teeth`",
                teeth, span->length, std::max(1.0, teeth + std::round(pitches)))))
      return *error;
  }
  // On an internal gear, the greater span belongs to the thinner tooth, so the allowances are in
  // descending order here.
  std::sort(ends.begin(), ends.end());
  return ends;
}

Result<Ends> of_balls(const Gear& gear, const GearInput& input) {
  const auto ball = input.measure.ball_diameter;
  if (!ball)
    return Error{"tolerance.over_balls", "",
                 "needs the diameter of the balls, `measure.ball_diameter`"};
  if (std::abs(gear.spec.teeth) == 1)
    return Error{"tolerance.over_balls", "",
                 "cannot be measured, because a gear with a single tooth space has no opposite "
                 "tooth space for the second ball; give `thickness_allowance`"};
  Ends ends{};
  for (const std::size_t i : {0u, 1u}) {
    const double read = (*input.tolerance.over_balls)[i];
    const auto thickness = base_thickness_from_balls(gear, *ball, read);
    if (!thickness)
      return refused("tolerance.over_balls", read,
                     "at this dimension the balls would lie inside the base cylinder of the gear");
    ends[i] = allowance_of(gear, *thickness);
    if (auto error = other_teeth(gear, "tolerance.over_balls", read, ends[i],
                                 "check this value, `measure.ball_diameter` and the module"))
      return *error;
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

const char* thickness_member(const ToleranceInput& tolerance) {
  return tolerance.series       ? "tolerance.series"
         : tolerance.span       ? "tolerance.span"
         : tolerance.over_balls ? "tolerance.over_balls"
                                : "thickness_allowance";
}
const char* tip_member(const ToleranceInput& tolerance) {
  return tolerance.tip_fit ? "tolerance.tip_fit" : "tolerance.tip_deviations";
}
const char* distance_member(const PairInput& pair) {
  return pair.distance_tolerance ? "pair.distance_tolerance" : "pair.distance_deviations";
}

Result<std::optional<Ends>> distance_deviations(const Arranged& nominal) {
  const PairInput& pair = nominal.completed.pair;
  if (!nominal.pair || (!pair.distance_deviations && !pair.distance_tolerance))
    return std::optional<Ends>();
  for (const int which : {1, 2}) {
    if (!nominal.completed.gear(which).cut_by) continue;
    return Error{distance_member(pair), "",
                 fmt::format("cannot be combined with `{}`, because a deviation of the centre "
                             "distance would also change the generating distance",
                             gear_field(which, "cut_by"))};
  }
  if (pair.distance_deviations) return pair.distance_deviations;
  auto half = js_deviation(*pair.distance_tolerance, nominal.pair->center_distance());
  if (!half) return within("pair", half.error());
  return std::optional<Ends>({-*half, *half});
}

// Returns the tip diameter at one end of its tolerance. At end 0 the tooth is shorter, and at end 1
// it is longer. The longer tooth has the greater σ d_a, where σ is 1 for an external gear and −1
// for an internal gear.
double tip_at_end(const Gear& gear, const Ends& deviations, std::size_t end) {
  const double side = gear.side();
  const auto [shorter, longer] = std::minmax({side * deviations[0], side * deviations[1]});
  return gear.tip_diameter + side * (end == 0 ? shorter : longer);
}

std::optional<Error> check_tips(const GivenPair& given) {
  for (const int which : {1, 2}) {
    const GearInput* const gear = given.find(which);
    if (!gear || !gear->tolerance.tip_deviations) continue;
    if (gear->cylindrical.tip_fillet || gear->tip_clearance || gear->tip_clearance_by_rule)
      return Error{gear_field(which, tip_member(gear->tolerance)), "",
                   "cannot be combined with `tip_fillet`, which determines the tip"};
  }
  return std::nullopt;
}

// Keeps the profile shift of the nominal gear, even if this shift was computed from the nominal
// centre distance. If the gear has a cutter, the tip diameter depends on the distance of the cutter
// and thus on the thickness allowance. If such a gear has no given tip diameter, the tip diameter
// of the nominal gear is removed, so that a new tip diameter is computed.
void follow_nominal(const Arranged& nominal, std::size_t i, GearInput& gear) {
  if (!gear.cut_by && nominal.gears[i].involute()) {
    gear.give_shift(nominal.gears[i].spec.profile_shift);
  } else if (gear.cut_by && !nominal.given->gears[i]->cylindrical.tip_diameter) {
    gear.cylindrical.tip_diameter.reset();
  }
}

// Returns the input at one end. End 0 has the thinnest and shortest teeth and the most backlash.
// End 1 has the thickest and longest teeth and the least backlash.
GivenPair at_end(const Arranged& nominal, std::size_t end, const std::optional<Ends>& deviations) {
  GivenPair given = nominal.completed;
  for (std::size_t i = 0; i < nominal.gears.size(); ++i) {
    GearInput& gear = *given.gears[i];
    if (gear.allowance_ends) gear.cylindrical.thickness_allowance = (*gear.allowance_ends)[end];
    follow_nominal(nominal, i, gear);
    if (gear.tolerance.tip_deviations)
      gear.cylindrical.tip_diameter =
          tip_at_end(nominal.gears[i], *gear.tolerance.tip_deviations, end);
  }
  if (given.pair.backlash_ends) {
    given.pair.backlash = (*given.pair.backlash_ends)[1 - end];
  } else if (given.pair.wants_backlash()) {
    // A given backlash applies to the nominal gears. At this end, the allowances are those of the
    // nominal gears, and the backlash is computed from them.
    given.pair.backlash.reset();
    given.pair.backlash_circumferential.reset();
    given.pair.backlash_angle.reset();
    for (std::size_t i = 0; i < nominal.gears.size(); ++i)
      given.gears[i]->cylindrical.thickness_allowance = nominal.gears[i].spec.thickness_allowance;
  }
  if (deviations) {
    const bool wider_is_looser = nominal.pair->mounted().side() > 0.0;
    given.pair.center_distance =
        nominal.pair->center_distance() + (*deviations)[(end == 0) == wider_is_looser ? 1 : 0];
    given.pair.shaft_angle = nominal.pair->shaft_angle();
  }
  return given;
}

// Attributes an error of the gears at an end to the tolerance, because the user gives the tolerance
// and not the values at its ends.
Error of_tolerance(const Error& error, const GivenPair& given) {
  const auto [which, member] = subject_of(error.field);
  const auto from = [&](const std::string& field) {
    return following_from(field, "", "one end of this tolerance requires", error);
  };
  const bool varies = given.pair.distance_deviations || given.pair.distance_tolerance;
  if (varies && member == GearMember::center_distance) return from(distance_member(given.pair));
  const GearInput* const gear = which == 0 ? nullptr : given.find(which);
  if (gear && member == GearMember::tip_diameter && gear->tolerance.tip_deviations)
    return from(gear_field(which, tip_member(gear->tolerance)));
  if (gear && member == GearMember::thickness_allowance && gear->allowance_ends)
    return from(gear_field(which, thickness_member(gear->tolerance)));
  return error;
}

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

Result<GivenPair> with_allowances(const GivenPair& as_given) {
  GivenPair given = as_given;
  std::optional<Arranged> nominal;
  for (const int which : {1, 2}) {
    GearInput* const gear = given.find(which);
    if (!gear || !gear->tolerance.says_thickness()) continue;
    const ToleranceInput& tolerance = gear->tolerance;
    const auto no = [&](const char* why) {
      return Error{gear_field(which, thickness_member(tolerance)), "", why};
    };
    if (gear->cut_by && gear->cut_by->gear != 0)
      return no("follows from the mating gear, which cuts this gear; leave out this key");
    if (gear->basic) return no("cannot be combined with `basic`, which gives the tooth thickness");
    if (!nominal) {
      auto solved = arrange_nominal(given, Scope::gears);
      if (!solved) return solved.error();
      nominal = std::move(solved).take();
    }
    const Gear& made = nominal->gear(which);
    if (!made.involute() && !tolerance.series)
      return no("can be measured on involute flanks only, and these flanks are circular arcs");
    auto ends = tolerance.series ? thickness_allowances(*tolerance.series, made.reference_diameter)
                : tolerance.span ? of_span(made, *gear)
                                 : of_balls(made, *gear);
    if (!ends) {
      Error error = ends.error();
      if (tolerance.series) error = within("tolerance", error);
      return of_gear(which, error);
    }
    gear->allowance_ends = *ends;
    gear->cylindrical.thickness_allowance = ((*ends)[0] + (*ends)[1]) / 2;
  }
  return given;
}

std::optional<Error> apply_tip_fits(Arranged& nominal) {
  for (int which = 1; which <= static_cast<int>(nominal.gears.size()); ++which) {
    ToleranceInput& tolerance = nominal.completed.gear(which).tolerance;
    if (!tolerance.tip_fit) continue;
    const Gear& gear = nominal.gear(which);
    const auto deviations = tip_deviations(*tolerance.tip_fit, gear.tip_diameter, gear.side());
    if (!deviations) return of_gear(which, deviations.error());
    tolerance.tip_deviations = *deviations;
  }
  return std::nullopt;
}

Result<std::shared_ptr<const ArrangedEnds>> arrange_ends(const Arranged& nominal, Scope scope) {
  const auto deviations = distance_deviations(nominal);
  if (!deviations) return deviations.error();
  bool tolerated =
      deviations->has_value() || (nominal.pair && nominal.completed.pair.backlash_ends);
  for (const auto& gear : nominal.completed.gears)
    tolerated = tolerated || (gear && (gear->allowance_ends || gear->tolerance.tip_deviations));
  if (!tolerated) return std::shared_ptr<const ArrangedEnds>();
  if (const auto error = check_tips(nominal.completed)) return *error;
  auto lower = arrange_nominal(at_end(nominal, 0, *deviations), scope);
  if (!lower) return of_tolerance(lower.error(), nominal.completed);
  auto upper = arrange_nominal(at_end(nominal, 1, *deviations), scope);
  if (!upper) return of_tolerance(upper.error(), nominal.completed);
  ArrangedEnds ends{std::move(lower).take(), std::move(upper).take()};
  for (std::size_t i = 0; i < nominal.gears.size() && nominal.completed.pair.backlash_ends; ++i) {
    if (ends.lower.gears[i].spec.thickness_allowance <=
        ends.upper.gears[i].spec.thickness_allowance)
      continue;
    return Error{"pair.backlash", "",
                 "the range is too narrow, because the tolerance of the centre distance alone "
                 "changes the backlash by more than this range"};
  }
  return std::shared_ptr<const ArrangedEnds>(std::make_shared<ArrangedEnds>(std::move(ends)));
}

std::vector<TolerancedNumber> tolerances_of(const Arranged& nominal) {
  std::vector<TolerancedNumber> list;
  if (!nominal.ends) return list;
  const auto& [lower, upper] = *nominal.ends;
  const auto add = [&](TolerancedNumber::Of of, int gear, double a, double b, double drawn) {
    constexpr double kRounding = 1e-12;
    const double noise = kRounding * std::abs(drawn);
    const Ends ends{std::min(a, b), std::max(a, b)};
    const bool excluded = drawn < ends[0] - noise || drawn > ends[1] + noise;
    if (a != b || excluded) list.push_back({of, gear, ends, excluded});
  };
  if (nominal.pair &&
      (nominal.completed.pair.distance_deviations || nominal.completed.pair.distance_tolerance))
    add(TolerancedNumber::Of::distance, 0, lower.pair->center_distance(),
        upper.pair->center_distance(), nominal.pair->center_distance());
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    if (i >= nominal.gears.size()) break;
    if (nominal.completed.gears[i]->tolerance.tip_deviations)
      add(TolerancedNumber::Of::tip, which, lower.gears[i].tip_diameter,
          upper.gears[i].tip_diameter, nominal.gears[i].tip_diameter);
    // A given base cylinder determines the tooth thickness, which then has no tolerance.
    if (nominal.completed.gears[i]->basic) continue;
    // The nominal allowance is the mean of both limits.
    const double thin = lower.gears[i].spec.thickness_allowance;
    const double thick = upper.gears[i].spec.thickness_allowance;
    add(TolerancedNumber::Of::thickness, which, thin, thick, thin);
  }
  return list;
}

bool tolerances_exclude_nominal(const Arranged& nominal) {
  const std::vector<TolerancedNumber> tolerances = tolerances_of(nominal);
  return std::any_of(tolerances.begin(), tolerances.end(),
                     [](const TolerancedNumber& t) { return t.excludes_nominal; });
}

std::vector<ToleranceCorner> corners_of(const std::vector<TolerancedNumber>& tolerances) {
  const std::size_t n = tolerances.size();
  std::vector<ToleranceCorner> corners(std::size_t{1} << n);
  for (std::size_t number = 0; number < corners.size(); ++number)
    for (std::size_t i = 0; i < n; ++i)
      corners[number].emplace_back((number >> (n - 1 - i)) & 1);  // the last end varies fastest
  return corners;
}

Result<Arranged> at_corner(const Arranged& nominal, const std::vector<TolerancedNumber>& tolerances,
                           const ToleranceCorner& corner) {
  GivenPair given = nominal.completed;
  PairInput& pair = given.pair;
  pair.backlash.reset();  // `completed` already contains the thinned teeth
  pair.backlash_circumferential.reset();
  pair.backlash_angle.reset();
  pair.backlash_ends.reset();
  pair.distance_deviations.reset();
  pair.distance_tolerance.reset();
  for (std::size_t i = 0; i < nominal.gears.size(); ++i) {
    GearInput& gear = *given.gears[i];
    gear.allowance_ends.reset();
    gear.tolerance = {};
    follow_nominal(nominal, i, gear);
    if (!gear.cut_by)
      gear.cylindrical.thickness_allowance = nominal.gears[i].spec.thickness_allowance;
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
    CylindricalSpec& gear = given.gear(tolerance.gear).cylindrical;
    const double value = tolerance.ends[*corner[k]];
    if (tolerance.of == TolerancedNumber::Of::tip) {
      gear.tip_diameter = value;
    } else {
      gear.thickness_allowance = value;
    }
  }
  return arrange(given, nominal.mounted() ? Scope::pair : Scope::gears);
}

std::vector<Arranged> arranged_corners(const Arranged& nominal) {
  const std::vector<TolerancedNumber> tolerances = tolerances_of(nominal);
  std::vector<Arranged> corners;
  if (tolerances.size() < 2) return corners;  // the corners of one tolerance are its ends
  for (const ToleranceCorner& corner : corners_of(tolerances))
    if (auto there = at_corner(nominal, tolerances, corner))
      corners.push_back(std::move(there).take());
  return corners;
}

std::string corner_words(const std::vector<TolerancedNumber>& tolerances,
                         const ToleranceCorner& corner) {
  std::vector<std::string> list;
  for (std::size_t k = 0; k < tolerances.size(); ++k) {
    if (corner[k]) list.push_back(words(tolerances[k], *corner[k]));
  }
  return "At " + enumerated(list);
}

}  // namespace gearwright
