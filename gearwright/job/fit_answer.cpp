#include "gearwright/job/fit_answer.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/corrected_spec.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/pair/partners.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); }

// The keys that determine the helix angle of a gear. The computed angle replaces all of them.
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
    if (!given.shift_given) gear["profile_shift"] = b.shift[i];
  }
  if (!spec.pair.center_distance) tree["pair"]["center_distance_mm"] = b.center_distance;
  if (!spec.pair.shaft_angle || b.shaft_angle.rad() == 0.0)
    tree["pair"]["shaft_angle_deg"] = b.shaft_angle.deg();
  tree["pair"].erase("mounting");  // must not be given together with the centre distance
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

// Returns the reason why the verb `pair` rejects the spec of a branch, or none.
std::optional<std::string> why_refused(const Json& tree) {
  const auto branch = read_spec_tree(tree);
  if (!branch) return branch.error().message();
  const auto job = solve(*branch, Scope::pair);
  return job ? std::nullopt : std::optional(spelled(job.error(), branch->given).message());
}

}  // namespace

void add_branch(FitAnswer& answer, const FitBranch& branch, Json spec,
                const std::optional<double>& transverse_contact_ratio) {
  answer.branches.push_back({branch, to_value(spec), transverse_contact_ratio, why_refused(spec)});
  answer.specs.push_back(std::move(spec));
}

Result<FitAnswer> answer_fit(const JobSpec& spec, Progress* progress) {
  if (auto error = two_gears_error(spec)) return *error;
  if (!spec.gears[0])
    return absent_input("gear1", "; the command `gearwright fit` needs two gears");
  for (const int which : {1, 2}) {
    if (!spec.has(which) || !has_arcs(spec.gear(which))) continue;
    return Error{gear_field(which, "rack"), "",
                 "the command `gearwright fit` supports involute gears only, but the teeth of this "
                 "gear are circular arcs"};
  }
  if (!spec.gears[1])
    return absent_input("gear2", "; the command `gearwright fit` needs two gears");
  if (spec.fit.few_teeth) return answer_few_teeth(spec, progress);
  for (const int i : {0, 1}) {
    if (!spec.gears[i]->cut_by) continue;
    return Error{gear_field(i + 1, "cut_by"), "",
                 "must be left out, because the command `gearwright fit` chooses the cutter; the "
                 "cutter is a rack or, if `fit.few_teeth` = true, the pinion"};
  }
  if (auto error = unknown_module(spec)) return *error;
  const CylindricalSpec& c1 = spec.gears[0]->cylindrical;
  const CylindricalSpec& c2 = spec.gears[1]->cylindrical;
  FitProblem p;
  p.teeth = {c1.teeth, c2.teeth};
  p.normal_module = c1.normal_module;
  p.normal_pressure_angle = c1.normal_pressure_angle;
  for (const int i : {0, 1})
    if (auto error = check_limits(i == 0 ? c1 : c2)) return of_gear(i + 1, *error);
  bool all = true;
  for (const int i : {0, 1}) {
    const GearInput& g = *spec.gears[i];
    if (g.helix_given) p.helix[i] = g.cylindrical.helix_angle;
    p.shift[i] = g.given_shift();
    all = all && g.helix_given && g.shift_given;
  }
  if (all) {
    p.known = {c1, c2};
  } else if (!same(c1.normal_module, c2.normal_module) ||
             !same(c1.normal_pressure_angle.rad(), c2.normal_pressure_angle.rad())) {
    return refused(
        "gear2.normal_module", c2.normal_module, {c1.normal_module},
        fmt::format("both gears need the same module ({{}}\u00a0mm) and pressure angle ({}°) "
                    "if helix angles or profile shifts are to be computed",
                    format_number(c1.normal_pressure_angle.deg())));
  }
  if (p.teeth[0] < 0) return internal_gear_1(p.teeth[0], p.teeth[1]);
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
  FitAnswer answer{{std::move(found).take()}};
  answer.fit.reason = spelled(answer.fit.reason, spec.given);
  for (const FitBranch& b : answer.fit.branches) add_branch(answer, b, spec_of(spec, b));
  return answer;
}

Json fit_json(const FitAnswer& answer) { return {{"fit", to_json(fit_quantities().of(answer))}}; }

std::string fit_listing(const FitAnswer& answer, UnitSystem units) {
  if (answer.branches.empty())
    return "\nThere is no such pair: " + answer.fit.reason + ".\n" +
           listing_of(units, fit_quantities(), answer);
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  std::string rejected;
  for (const BranchView& b : answer.branches) {
    names.push_back(fmt::format("branch {}", names.size() + 1));
    records.push_back(branch_quantities().of(b));
    if (b.refused)
      rejected += fmt::format("  {} is rejected by `gearwright pair`: {}\n", names.back(),
                              sentence_in(units, *b.refused));
  }
  return "\n" +
         row_listing(units, names, records,
                     {"helix_angle_deg", "profile_shift", "center_distance_mm", "shaft_angle_deg",
                      "working_normal_pressure_angle_deg", "transverse_contact_ratio"}) +
         rejected +
         (answer.remark.empty() ? "" : "\n" + wrapped(sentence_in(units, answer.remark))) +
         "\nThe option --take NUMBER > pair.toml writes the spec of a branch.\n";
}

}  // namespace gearwright
