#include "gearwright/arrange/judge.hpp"

#include <algorithm>

#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

namespace {

Judged judged_of(const Arranged& arranged, const JudgedWith& with) {
  Judged judged;
  for (const Gear& gear : arranged.gears) judged.gears.push_back(&gear);
  judged.pair = arranged.pair ? &*arranged.pair : nullptr;
  judged.rack = arranged.rack ? &*arranged.rack : nullptr;
  judged.warnings = &arranged.warnings;
  judged.contact = with.contact;
  judged.errors = with.errors;
  judged.tolerances = arranged.ends != nullptr;
  if (arranged.ends && arranged.ends->lower.pair && arranged.ends->upper.pair) {
    const double least = arranged.ends->upper.pair->stated_backlash().normal;
    const double greatest = arranged.ends->lower.pair->stated_backlash().normal;
    const bool other =
        least != arranged.pair->stated_backlash().normal && tolerances_exclude_nominal(arranged);
    if (least != greatest || other) judged.backlash_ends = {least, greatest};
  }
  if (arranged.pair) {
    const auto& gears = arranged.given->gears;
    const auto& pair = arranged.given->pair;
    const bool absent =
        arranged.pair->involute() && !(gears[0]->shift_given && gears[1]->shift_given);
    judged.shifts_follow = shifts_follow(*arranged.given);
    judged.distance_sets_shifts = absent && !pair.center_distance;
  }
  judged.rating = with.rating;
  return judged;
}

// Rates the gears at one combination of the ends of their tolerances, under the load of the nominal
// gears.
std::optional<PairRating> rated_again(const Arranged& arranged, PairRating gears) {
  auto pair = rated_pair(*arranged.pair);
  if (!pair) return std::nullopt;
  const int halves = gears.pair.halves;
  gears.pair = std::move(pair).take();
  gears.pair.halves = halves;
  auto rating = rate(gears.pair, gears.input);
  if (!rating) return std::nullopt;
  gears.rating = std::move(rating).take();
  if (gears.spectrum) {
    const auto spectrum = rate_spectrum(gears.pair, gears.input, gears.steps);
    if (!spectrum) return std::nullopt;
    gears.spectrum = *spectrum;
  }
  return gears;
}

JudgedState state_at(const Arranged& arranged, const std::vector<TolerancedNumber>& tolerances,
                     const ToleranceCorner& corner, const JudgedWith& with) {
  const auto there = at_corner(arranged, tolerances, corner);
  // The gears may have no pair at a corner even if they have one at both ends.
  if (!there) return {};
  JudgedWith of_there{.errors = with.errors};
  if (with.rating) of_there.rating = rated_again(*there, *with.rating);
  JudgedState state{findings_of(judged_of(*there, of_there)), {}};
  if (of_there.rating) state.pair = std::move(of_there.rating->pair);
  return state;
}

auto same_finding(const Finding& like) {
  return [&like](const Finding& f) { return f.code == like.code && f.gear == like.gear; };
}

// Returns `corner` without the ends that do not affect the finding. The toleranced numbers of these
// ends then have their nominal values. At least one end remains.
ToleranceCorner what_matters(const Arranged& arranged,
                             const std::vector<TolerancedNumber>& tolerances,
                             ToleranceCorner corner, const Finding& finding,
                             const JudgedWith& with) {
  for (std::size_t k = 0; k < corner.size(); ++k) {
    if (tolerances[k].excludes_nominal) continue;
    ToleranceCorner less = corner;
    less[k].reset();
    if (std::none_of(less.begin(), less.end(), [](const auto& end) { return end.has_value(); }))
      continue;
    const auto found = state_at(arranged, tolerances, less, with).findings;
    const auto it = std::find_if(found.begin(), found.end(), same_finding(finding));
    if (it != found.end() && !worse(finding, *it)) corner = less;
  }
  return corner;
}

// Judges the nominal gears and then every combination of the ends of their tolerances, as long
// as `visit` returns true.
void visit_states(const Arranged& arranged, const JudgedWith& with,
                  const std::function<bool(const JudgedState&)>& visit) {
  if (!visit({findings_of(judged_of(arranged, with)), {}})) return;
  const std::vector<TolerancedNumber> tolerances = tolerances_of(arranged);
  if (tolerances.empty()) return;
  for (const ToleranceCorner& corner : corners_of(tolerances))
    if (!visit(state_at(arranged, tolerances, corner, with))) return;
}

}  // namespace

std::vector<Finding> findings_within_tolerances(const Arranged& arranged, const JudgedWith& with) {
  std::vector<Finding> findings = findings_of(judged_of(arranged, with));
  const std::vector<TolerancedNumber> tolerances = tolerances_of(arranged);
  if (tolerances.empty()) return findings;
  struct Worst {
    Finding finding;
    ToleranceCorner corner;
  };
  std::vector<Worst> list;
  for (const ToleranceCorner& corner : corners_of(tolerances)) {
    JudgedState state = state_at(arranged, tolerances, corner, with);
    for (Finding& f : state.findings) {
      const auto drawn = std::find_if(findings.begin(), findings.end(), same_finding(f));
      if (f.level <= (drawn == findings.end() ? Level::green : drawn->level)) continue;
      const auto same = std::find_if(list.begin(), list.end(),
                                     [&](const Worst& w) { return same_finding(f)(w.finding); });
      if (same == list.end()) {
        list.push_back({std::move(f), corner});
      } else if (worse(f, same->finding)) {
        *same = {std::move(f), corner};
      }
    }
  }
  for (Worst& w : list) {
    w.finding.at =
        corner_words(tolerances, what_matters(arranged, tolerances, w.corner, w.finding, with));
    const auto drawn = std::find_if(findings.begin(), findings.end(), same_finding(w.finding));
    if (drawn == findings.end()) {
      findings.push_back(std::move(w.finding));
    } else {
      *drawn = std::move(w.finding);
    }
  }
  return findings;
}

namespace {

bool set_allowance(GivenPair& given, GearInput& gear, double value) {
  if (gear.allowance_ends || gear.tolerance.says_thickness() || given.pair.wants_backlash())
    return false;
  gear.cylindrical.thickness_allowance = value;
  return true;
}

// Sets the helix angle and returns true. If the transverse module or the transverse pressure angle
// is given, returns false without a change. A new helix angle would then also change the normal
// module and the normal pressure angle.
bool set_helix(GearInput& gear, double degrees) {
  if (gear.transverse_given) return false;
  gear.cylindrical.helix_angle = Angle::degrees(degrees);
  gear.helix_given = true;
  return true;
}

// Sets the face width to `value`, which includes the gap of a double-helical gear. For such a
// gear, the member `face_width` receives the face width of one half.
void set_face(GearInput& gear, double value) {
  gear.cylindrical.face_width =
      gear.double_helical ? (value - gear.double_helical->gap) / 2 : value;
  gear.face_width_given = true;
}

bool change_gear(GivenPair& given, const SpecChange& change) {
  GearInput& gear = given.gear(change.gear);
  const bool has_rack = !gear.basic && !gear.cut_by;
  switch (change.what) {
    case Adjustable::profile_shift: gear.give_shift(change.value); return has_rack;
    case Adjustable::tip_diameter:
      gear.cylindrical.tip_diameter = change.value;
      return !gear.cylindrical.tip_fillet && !gear.tip_clearance && !gear.tip_clearance_by_rule;
    case Adjustable::thickness_allowance:
      return has_rack && set_allowance(given, gear, change.value);
    case Adjustable::teeth:
      gear.cylindrical.teeth = static_cast<int>(change.value);
      return has_rack;
    case Adjustable::helix_angle: return has_rack && set_helix(gear, change.value);
    case Adjustable::face_width: set_face(gear, change.value); return true;
    case Adjustable::bore:
      if (gear.bore) gear.bore->diameter = change.value;
      return gear.bore.has_value();
    case Adjustable::lead_crowning:
      for (FlankModifications& flank : gear.modifications)
        flank.lead_crowning = kMmPerUm * change.value;
      return true;
    case Adjustable::lead_slope:
      for (FlankModifications& flank : gear.modifications)
        flank.lead_slope = kMmPerUm * change.value;
      return true;
    case Adjustable::center_distance: break;
  }
  return false;
}

}  // namespace

bool make_change(GivenPair& given, const SpecChange& change) {
  if (change.what == Adjustable::center_distance) {
    given.pair.center_distance = change.value;
    return true;
  }
  if (change.gear > 0) return change_gear(given, change);
  return change.what == Adjustable::face_width &&
         change_gear(given, {change.what, 1, change.value}) &&
         change_gear(given, {change.what, 2, change.value});
}

namespace {

std::optional<ChangedState> tried(const Arranged& arranged, const JudgedWith& with,
                                  const SpecChange& change, TryDepth depth) {
  GivenPair given = *arranged.given;
  if (!make_change(given, change)) return std::nullopt;
  auto made = arrange(given, arranged.mounted() ? Scope::pair : Scope::gears);
  if (!made || check_flanks(*made)) return std::nullopt;
  Arranged changed = std::move(made).take();
  JudgedWith of_changed{.errors = with.errors};
  std::optional<ContactResult> contact;
  if (depth == TryDepth::with_contact) {
    if (with.contact_again) contact = with.contact_again(changed);
    if (!contact) return std::nullopt;
    of_changed.contact = &*contact;
  }
  ChangedState state;
  state.findings = depth == TryDepth::as_drawn ? findings_of(judged_of(changed, of_changed))
                                               : findings_within_tolerances(changed, of_changed);
  state.place = pattern_place(judged_of(changed, of_changed));
  if (changed.pair) {
    state.contact_ratio = changed.pair->contact_ratio_true();
    state.backlash = changed.pair->stated_backlash().normal;
  } else if (changed.rack) {
    state.contact_ratio = changed.rack->true_contact_ratio();
    state.backlash = changed.rack->normal_backlash();
  }
  return state;
}

}  // namespace

Verdict judge(const Arranged& arranged, const JudgedWith& with) {
  GW_EXPECTS(arranged.given != nullptr);
  return verdict_of(judged_of(arranged, with), findings_within_tolerances(arranged, with),
                    [&](const SpecChange& change, TryDepth depth) {
                      return tried(arranged, with, change, depth);
                    });
}

namespace {

std::optional<PairRating> rate_drawing(const SearchProblem& problem, const Arranged& arranged) {
  const SearchRating& asked = *problem.rating;
  const auto pair = rated_pair(*arranged.pair);
  if (!pair) return std::nullopt;
  PairRating rated{*pair, asked.input_of(arranged.gear(1).spec.teeth, arranged.gear(2).spec.teeth)};
  if (asked.web) rated.input.body = rated_body(*pair, *asked.web, *asked.rim);
  auto rating = rate(rated.pair, rated.input);
  if (!rating) return std::nullopt;
  rated.rating = std::move(rating).take();
  rated.wanted = {problem.limits.safety_flank.value_or(1.0),
                  problem.limits.safety_root.value_or(1.0)};
  return rated;
}

GivenPair given_drawing(const SearchProblem& problem, const DesignRow& row) {
  GivenPair given;
  for (const std::size_t i : {0, 1}) {
    CylindricalSpec spec;
    spec.teeth = i == 0 ? row.trial.z1 : row.trial.z2;
    spec.normal_module = row.trial.module;
    spec.normal_pressure_angle = problem.normal_pressure_angle;
    spec.helix_angle = row.trial.helix[i];
    spec.profile_shift = row.shift[i];
    spec.face_width = row.face_width;
    spec.rack = rack_of(problem, row.trial, i);
    given.gears[i] = GearInput::of(spec);
    if (!problem.allowances.series.empty())
      given.gears[i]->tolerance.series = problem.allowances.series;
  }
  PairInput& pair = given.pair;
  pair.center_distance = row.center_distance;
  pair.shaft_angle = problem.shaft_angle;
  pair.mounting = problem.mounting;
  pair.shorten_tips = problem.shorten_tips;
  pair.distance_tolerance = problem.allowances.distance_tolerance;
  if (const auto& ends = problem.allowances.backlash) {
    pair.backlash = ((*ends)[0] + (*ends)[1]) / 2;
    if ((*ends)[0] < (*ends)[1]) pair.backlash_ends = *ends;
  }
  return given;
}

bool rejects_design(const Finding& finding) {
  return finding.level != Level::green && finding.code != WarningCode::rating_plastic;
}

// The pair of a drawing with its rating. The limits of the rating are among the warnings.
struct DrawnPair {
  Arranged arranged;
  JudgedWith with{};
  bool ratable = true;  ///< false if a rating was requested but is not possible
};

Result<DrawnPair> drawing_of(const SearchProblem& problem, const DesignRow& row) {
  auto made = arrange(given_drawing(problem, row), Scope::pair);
  if (!made) return made.error();
  DrawnPair drawing{std::move(made).take()};
  if (!problem.rating) return drawing;
  auto& rating = drawing.with.rating = rate_drawing(problem, drawing.arranged);
  drawing.ratable = rating.has_value();
  if (rating)
    for (const Warning& limit : rating->rating.limits) drawing.arranged.warnings.push_back(limit);
  return drawing;
}

}  // namespace

DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row) {
  const auto drawing = drawing_of(problem, row);
  if (!drawing) return {};
  DrawnDesign drawn;
  if (const auto& ends = drawing->arranged.ends)
    drawn.backlash = {ends->upper.pair->stated_backlash().normal,
                      ends->lower.pair->stated_backlash().normal};
  if (!drawing->ratable) return drawn;
  drawn.runs = true;
  bool wider_helps = problem.sizes_faces();
  std::optional<Finding> worst;
  visit_states(drawing->arranged, drawing->with, [&](const JudgedState& state) {
    for (const Finding& finding : state.findings) {
      if (!rejects_design(finding)) continue;
      drawn.runs = false;
      wider_helps = wider_helps && is_safety(finding.code);
      if (!worst || is_listed_before(finding, *worst)) worst = finding;
    }
    if (state.pair) drawn.at_ends.push_back(*state.pair);
    return drawn.runs || wider_helps;
  });
  if (drawn.runs || !wider_helps) drawn.at_ends.clear();
  if (worst) drawn.finding = worst->code;
  return drawn;
}

Result<std::optional<Finding>> finding_of_drawing(const SearchProblem& problem,
                                                  const DesignRow& row) {
  const auto drawing = drawing_of(problem, row);
  if (!drawing) return drawing.error();
  std::optional<Finding> worst;
  if (!drawing->ratable) return worst;
  for (Finding& finding : findings_within_tolerances(drawing->arranged, drawing->with))
    if (rejects_design(finding) && (!worst || is_listed_before(finding, *worst)))
      worst = std::move(finding);
  return worst;
}

}  // namespace gearwright
