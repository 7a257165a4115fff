#include "gearwright/job/fit_answer.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/corrected_spec.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); }

// The keys that determine the helix angle of a gear. They are all replaced by the computed angle.
constexpr const char* kHelixKeys[] = {"helix_angle_deg", "lead_angle_deg", "hand"};

Json spec_of(const JobSpec& spec, const FitBranch& b) {
  Json tree = spec.tree->tables;
  tree.erase("fit");
  for (const int i : {0, 1}) {
    const GearInput& given = *spec.gears[i];
    Json& gear = tree[i == 0 ? "gear1" : "gear2"];
    if (given.basic) continue;
    if (!given.helix_given) {
      for (const char* key : kHelixKeys) gear.erase(key);
      gear["helix_angle_deg"] = b.helix[i].deg();
    }
    if (!given.profile_shift) gear["profile_shift"] = b.shift[i];
  }
  if (!spec.pair.center_distance) tree["pair"]["center_distance_mm"] = b.center_distance;
  if (!spec.pair.shaft_angle || b.shaft_angle.rad() == 0.0)
    tree["pair"]["shaft_angle_deg"] = b.shaft_angle.deg();
  tree["pair"].erase("mounting");  // the centre distance is given explicitly
  return plain_first(tree);
}

std::optional<Error> unknown_module(const JobSpec& spec) {
  for (const int i : {0, 1}) {
    if (spec.gears[i]->helix_given) continue;
    for (const char* key : {"transverse_module_mm", "transverse_pressure_angle_deg"}) {
      const std::string full = gear_field(i + 1, key);
      if (!spec.given.contains(full)) continue;
      return Error{full, "",
                   "needs a helix angle, but the helix angle is unknown; give the normal module "
                   "and the normal pressure angle of the rack instead"};
    }
  }
  return std::nullopt;
}

// Determines for each branch whether the verb pair rejects it, and for what reason.
void mark_refused(FitAnswer& answer) {
  for (const Json& tree : answer.specs) {
    std::optional<Error> error;
    const auto branch = read_spec_tree(tree);
    if (!branch) {
      error = branch.error();
    } else if (const auto job = solve(*branch, Scope::pair); !job) {
      error = spelled(job.error(), branch->given);
    }
    answer.refused.push_back(std::move(error));
  }
}

}  // namespace

Result<FitAnswer> answer_fit(const JobSpec& spec, Progress* progress) {
  if (!spec.gears[0]) return absent_input("gear1", "; the verb fit needs two gears");
  for (const int which : {1, 2}) {
    if (!spec.has(which) || !has_arcs(spec.gear(which))) continue;
    return Error{gear_field(which, "rack"), "",
                 "the verb fit supports involute gears only, and these teeth are circular arcs"};
  }
  if (!spec.gears[1]) return absent_input("gear2", "; the verb fit needs two gears");
  if (spec.fit.few_teeth) {
    auto made = answer_few_teeth(spec, progress);
    if (!made) return made.error();
    FitAnswer few = std::move(made).take();
    mark_refused(few);
    return few;
  }
  for (const int i : {0, 1}) {
    if (!spec.gears[i]->cut_by) continue;
    return Error{gear_field(i + 1, "cut_by"), "",
                 "must be left out, because the verb fit chooses the cutter, which is a rack or, "
                 "with `fit.few_teeth` = true, the pinion"};
  }
  if (auto error = unknown_module(spec)) return *error;
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  FitProblem p;
  p.teeth = {c1.teeth, c2.teeth};
  p.normal_module = c1.normal_module;
  p.normal_pressure_angle = c1.normal_pressure_angle;
  for (const int i : {0, 1}) {
    CylindricalSpec c = i == 0 ? c1 : c2;
    c.profile_shift = spec.gears[i]->profile_shift.value_or(0.0);
    if (auto error = check_limits(c)) return of_gear(i + 1, *error);
  }
  bool all = true;
  std::array<CylindricalSpec, 2> known{c1, c2};
  for (const int i : {0, 1}) {
    const GearInput& g = *spec.gears[i];
    if (g.helix_given) p.helix[i] = g.cylindrical.helix_angle;
    p.shift[i] = g.profile_shift;
    all = all && g.helix_given && g.profile_shift;
    known[i].profile_shift = g.profile_shift.value_or(0.0);
  }
  if (all) {
    p.known = known;
  } else if (!same(c1.normal_module, c2.normal_module) ||
             !same(c1.normal_pressure_angle.rad(), c2.normal_pressure_angle.rad())) {
    return refused(
        "gear2.normal_module", c2.normal_module, {c1.normal_module},
        fmt::format("both gears need the same module ({{}}\u00a0mm) and pressure angle ({}°) "
                    "if helix angles or profile shifts are to be computed",
                    format_number(c1.normal_pressure_angle.deg())));
  }
  if (p.teeth[0] < 0) {
    return refused("gear1.teeth", p.teeth[0],
                   "the internal gear of a pair is gear 2; exchange the two gears");
  }
  if (p.teeth[1] < 0 && -p.teeth[1] <= p.teeth[0]) {
    return refused(
        "gear2.teeth", p.teeth[1],
        fmt::format("an internal gear must have more teeth than its pinion (gear 1 has {})",
                    p.teeth[0]));
  }
  p.center_distance = spec.pair.center_distance;
  p.shaft_angle = spec.pair.shaft_angle;
  p.working_normal_pressure_angle = spec.fit.working_normal_pressure_angle;
  auto found = fit(p);
  if (!found) return found.error();
  FitAnswer answer{std::move(found).take(), {}};
  answer.fit.reason = spelled(answer.fit.reason, spec.given);
  for (const FitBranch& b : answer.fit.branches) answer.specs.push_back(spec_of(spec, b));
  mark_refused(answer);
  return answer;
}

FitView fit_view(const FitAnswer& answer) {
  FitView view{&answer.fit, {}};
  for (std::size_t i = 0; i < answer.fit.branches.size(); ++i) {
    view.branches.push_back(
        {answer.fit.branches[i], to_value(answer.specs[i]), answer.transverse_contact_ratio, {}});
    if (const auto& error = answer.refused[i]) view.branches.back().refused = error->message();
  }
  return view;
}

Json fit_json(const FitAnswer& answer) {
  return {{"fit", to_json(fit_quantities().of(fit_view(answer)))}};
}

std::string fit_listing(const FitAnswer& answer, UnitSystem units) {
  const auto mm = [&](double x) { return text_in(units, Unit::mm, x, 4); };
  const std::string_view unit = unit_text(units, Unit::mm);
  const Fit& f = answer.fit;
  if (f.branches.empty()) {
    std::string text = "\nThere is no such pair: " + f.reason + ".\n";
    if (f.nearest_distance)
      text += fmt::format("  nearest centre distance at this shaft angle  {} {}\n",
                          mm(*f.nearest_distance), unit);
    if (f.nearest_shaft_angle)
      text += fmt::format("  nearest shaft angle at this centre distance  {:.5f}°\n",
                          f.nearest_shaft_angle->deg());
    return text;
  }
  std::string text = fmt::format("\n  {:>6}  {:>11} {:>11}  {:>9} {:>9}  {:>11}  {:>11}  {:>10}\n",
                                 "branch", "helix 1", "helix 2", "shift 1", "shift 2",
                                 fmt::format("distance {}", unit), "shaft angle", "α_wn");
  int number = 0;
  for (const FitBranch& b : f.branches) {
    text += fmt::format(
        "  {:>6}  {:>10.5f}° {:>10.5f}°  {:>9.5f} {:>9.5f}  {:>11}  {:>10.5f}°  {:>9.5f}°\n",
        ++number, b.helix[0].deg(), b.helix[1].deg(), b.shift[0], b.shift[1], mm(b.center_distance),
        b.shaft_angle.deg(), b.working_normal_pressure_angle.deg());
    if (const auto& error = answer.refused[static_cast<std::size_t>(number - 1)])
      text += fmt::format("          rejected by the verb pair: {}\n",
                          sentence_in(units, error->message()));
  }
  if (answer.transverse_contact_ratio)
    text += fmt::format("\n  transverse contact ratio {:.4f}\n", *answer.transverse_contact_ratio);
  return text + "\nThe option --take NUMBER > pair.toml writes the spec of a branch.\n";
}

}  // namespace gearwright
