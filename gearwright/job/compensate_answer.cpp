#include "gearwright/job/compensate_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear_field.hpp"
#include "gearwright/job/compensate_forms.hpp"
#include "gearwright/job/compensate_load.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/math/minimise.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

constexpr int kPositions = 24;
// Under load a curve takes a hundred times as long, and a pitch has fewer corners.
constexpr int kLoadPositions = 16, kLoadCurves = 120;

bool gear2_drives(const JobSpec& spec) {
  return (under_load(spec.compensate.aim) ? spec.load.driver : spec.contact.driver) == 2;
}

std::optional<Error> check_corrections(const ContactSetup& setup, const CompensateInput& input) {
  for (const std::size_t place : input.corrections) {
    const WorkshopCorrection& c = kCorrections[place].correction;
    if (can_take(setup, c)) continue;
    return Error{"compensate.corrections", std::string(entry_of(c).key),
                 c.what == CorrectionOf::tool_setting
                     ? "is the setting of a rack F (one of circular arcs), which cuts neither gear"
                     : "needs a helical gear cut by a rack"};
  }
  return std::nullopt;
}

struct NamedErrors {
  std::string name;
  ContactErrors errors;
};

// The given errors, and every corner of the range.
std::vector<NamedErrors> scenarios_of(const ContactSetup& setup, const CompensateInput& input) {
  std::vector<NamedErrors> list{{"as given", setup.place().errors}};
  std::vector<std::size_t> ranged;
  for (std::size_t i = 0; i < kErrorCount; ++i)
    if (input.range[i]) ranged.push_back(i);
  if (ranged.empty()) return list;
  for (std::size_t corner = 0; corner < (1u << ranged.size()); ++corner) {
    NamedErrors s{"", setup.place().errors};
    for (std::size_t k = 0; k < ranged.size(); ++k) {
      const double value = (*input.range[ranged[k]])[(corner >> k) & 1u];
      s.errors = with_error(setup, s.errors, ranged[k], value);
      s.name += fmt::format("{}{} = {}", k ? ", " : "", error_entries()[ranged[k]].key, value);
    }
    list.push_back(std::move(s));
  }
  return list;
}

// The key of a correction in the corrected spec: the slope of the working flank, a crowning of
// both.
std::string spec_key(const SolvedJob& job, const ContactSetup& setup, const WorkshopCorrection& c) {
  if (c.what == CorrectionOf::tool_setting)
    return fmt::format("gear{}.rack.center_b", *setup.convex_gear());
  if (c.what == CorrectionOf::cutter_lead) return fmt::format("errors.{}", entry_of(c).key);
  const bool left = gear2_drives(job.spec) != (c.gear == 2 && setup.gear(2).internal());
  return fmt::format("gear{}.modifications.{}{}", c.gear,
                     !c.slope() ? ""
                     : left     ? "left_"
                                : "right_",
                     entry_of(c).own_key());
}

// A correction at the end of the search range might improve beyond it. A crowning of 0 would not.
bool at_bound(const Correction& range, double value) {
  const double reach = 0.02 * range.step;
  return value != 0.0 && (value - range.lo < reach || range.hi - value < reach);
}

// The warning about such corrections; none if there are none.
std::optional<Warning> bound_warning(const CompensateAnswer& answer) {
  std::string list;
  for (std::size_t k = 0; k < answer.corrections.size(); ++k) {
    if (!answer.at_bound[k]) continue;
    const CorrectionEntry& c = entry_of(answer.corrections[k]);
    list += fmt::format("{}{}, {:g} {}", list.empty() ? "" : "; ", c.words, answer.result.value[k],
                        c.shown_unit());
  }
  if (list.empty()) return std::nullopt;
  return Warning{WarningCode::correction_at_bound,
                 fmt::format("These corrections are at the end of the searched range: {}. Larger "
                             "ones might be better, but the errors are large for a flank "
                             "modification.",
                             list),
                 0};
}

// Corrections written into the spec, in its own keys.
Json corrected_spec(const SolvedJob& job, const ContactSetup& setup,
                    const std::vector<WorkshopCorrection>& which, const std::vector<double>& v) {
  Json tree = job.spec.tree->tables;
  tree.erase("compensate");
  const auto add = [](Json& table, const std::string& key, double value) {
    // Rounds a sum of decimals, which has additional digits due to binary addition.
    constexpr double kDigits = 1e9;
    const double sum = (table.contains(key) ? table[key].get<double>() : 0.0) + value;
    table[key] = std::round(sum * kDigits) / kDigits;
  };
  for (std::size_t k = 0; k < which.size(); ++k) {
    const WorkshopCorrection& c = which[k];
    if (v[k] == 0.0) continue;
    if (c.what == CorrectionOf::tool_setting) {
      const int gear = *setup.convex_gear();
      Json& rack = tree[gear_field(gear)]["rack"];
      const auto& arc = std::get<ArcRack>(setup.gear(gear).spec.rack);
      rack["center_b"] = arc.center_b + v[k] / setup.gear(gear).spec.normal_module;
      rack.erase("pressure_angle_deg");  // it was a check of the old setting
    } else if (c.what == CorrectionOf::cutter_lead) {
      // the same as an error of this amount
      add(tree["errors"], std::string(entry_of(c).key), v[k]);
    } else {
      const std::string name(entry_of(c).own_key());
      const bool slope = c.slope();
      Json& table = tree[gear_field(c.gear)]["modifications"];
      const std::string path = spec_key(job, setup, c);
      const std::string own = path.substr(path.rfind('.') + 1);
      // The amount for both flanks is the start value.
      if (slope && !table.contains(own) && table.contains(name)) table[own] = table[name];
      add(table, own, v[k]);
      // An amount for both flanks is also added to flanks with their own amount.
      for (const char* side : {"left_", "right_"})
        if (!slope && table.contains(side + name)) add(table, side + name, v[k]);
      // If each flank has its own amount, the amount for both has no effect.
      if (table.contains("left_" + name) && table.contains("right_" + name)) table.erase(name);
    }
  }
  // Tables follow plain values, as in a TOML file.
  Json ordered = Json::object();
  for (const bool tables : {false, true})
    for (const auto& [key, value] : tree.items())
      if (value.is_object() == tables) ordered[key] = value;
  return ordered;
}

// The worst over the scenarios, at the reported positions.
std::vector<AimedLoad> aimed_loads(const LoadedAim& load, const CompensationTask& task,
                                   const std::vector<double>& found) {
  std::vector<AimedLoad> loads;
  for (const double torque : load.torques()) loads.push_back({torque, {}, {}});
  const std::vector<double> zero(found.size(), 0.0);
  for (int s = 0; s < task.scenarios; ++s) {
    for (const bool after : {false, true}) {
      const auto pair = task.pair_at(after ? found : zero, s);
      if (!pair) continue;
      const auto scores = load.scores(*pair, task.fine_positions);
      for (std::size_t i = 0; i < loads.size(); ++i) {
        LoadedScore& worst = after ? loads[i].after : loads[i].before;
        worst = worse_of(worst, i < scores.size() ? scores[i] : no_score());
      }
    }
  }
  return loads;
}

// The verdict on the corrected spec; `loads` is the effect of the corrections under torque.
Result<Verdict> judge_corrected(const Json& corrected, const SolvedJob& job,
                                const std::vector<AimedLoad>& loads) {
  auto read = read_spec_tree(corrected);
  if (!read) return read.error();
  JobSpec spec = std::move(read).take();
  spec.contact.pattern = false;
  spec.contact.map.reset();
  auto solved = solve(spec, Scope::pair);
  if (!solved) return solved.error();
  SolvedJob with = std::move(solved).take();
  const auto contact = answer_contact(with);
  if (!contact) return contact.error();
  // Warnings about the range of errors, which includes those of the spec, and about the load.
  for (const Warning& w : job.warnings) {
    if (w.code == WarningCode::contact_lost || w.code == WarningCode::load_unfinished)
      with.warnings.push_back(w);
  }
  for (const AimedLoad& load : loads)
    if (load.after.edge_carries) with.warnings.push_back(edge_carries_at(load.torque));
  return judge(with, {.contact = &contact->driving, .load = !loads.empty()});
}

}  // namespace

Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress, int curves) {
  if (!can_minimise()) {
    return Error{"compensate", "",
                 "this build has no minimiser (NLopt) and cannot compute corrections; use the "
                 "installed program",
                 FailureKind::not_in_build};
  }
  if (auto error = missing_error(SpecUse::compensate, job.spec)) return *error;
  auto made = setup_of(job);
  if (!made) return made.error();
  const ContactSetup setup = std::move(made).take();
  const CompensateInput& input = job.spec.compensate;
  if (auto error = check_corrections(setup, input)) return *error;
  CompensateAnswer answer;
  for (const std::size_t place : input.corrections)
    answer.corrections.push_back(kCorrections[place].correction);
  if (input.corrections.empty()) answer.corrections = usual_corrections(setup);
  const bool gear2_drives = gearwright::gear2_drives(job.spec);
  // Checked before a search, because no correction of a workshop makes teeth longer.
  if (std::isnan(
          peak_to_peak(transmission_error(setup.pair(gear2_drives), job.spec.contact.positions))))
    return nothing_touches(setup);
  const std::vector<NamedErrors> scenarios = scenarios_of(setup, input);
  for (const NamedErrors& s : scenarios) answer.scenarios.push_back(s.name);
  std::vector<ContactErrors> errors;
  for (const NamedErrors& s : scenarios) errors.push_back(s.errors);
  CompensationTask task = compensation_task(setup, answer.corrections, errors, gear2_drives);
  task.positions = kPositions;
  task.progress = progress;
  task.curves = curves;
  task.fine_positions = job.spec.contact.positions;
  answer.aim = input.aim;
  std::optional<LoadedAim> load;
  if (under_load(job.spec.compensate.aim)) {
    auto aimed = LoadedAim::of(job, progress);
    if (!aimed) return aimed.error();
    load = std::move(aimed).take();
    task.aim = load->aim();
    task.fine_positions = load->positions();
    task.positions = std::min(kLoadPositions, task.fine_positions);
    task.curves = std::min(curves, kLoadCurves);
  }
  if (input.centering_arcsec) task.centering = Angle::arcseconds(*input.centering_arcsec);
  answer.setting = arc_setting(job, setup);
  answer.lead = lead_without_slope(job, setup);
  if (answer.setting && answer.setting->angle_nominal) {
    // Deviation of the rack angle from the drawing at the end of the flank.
    constexpr Angle kProfileEnd = Angle::degrees(10);
    task.profile = {*answer.setting->angle_nominal, kProfileEnd};
  }
  std::vector<double> closed_forms(answer.corrections.size(), 0.0);
  for (std::size_t k = 0; k < closed_forms.size(); ++k) {
    const WorkshopCorrection& c = answer.corrections[k];
    if (c.what == CorrectionOf::tool_setting && answer.setting)
      closed_forms[k] = answer.setting->exact;
    if (c.what == CorrectionOf::cutter_lead && c.gear == 1 && answer.lead)
      closed_forms[k] = answer.lead->exact[0].value_or(Angle()).rad() / kRadPerDeg;
  }
  task.starts.push_back(std::move(closed_forms));
  answer.result = compensate(task);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (answer.result.each_after[i].nothing_touches())
      return nothing_touches_under(setup, scenarios[i].name, scenarios[i].errors);
  }
  const auto contact_lost = [](const Warning& w) {
    return w.code == WarningCode::contact_lost || w.code == WarningCode::contact_lost_to_undercut;
  };
  if (answer.result.after.lost &&
      std::none_of(job.warnings.begin(), job.warnings.end(), contact_lost)) {
    job.warnings.push_back({WarningCode::contact_lost,
                            "Contact is lost at some positions, and no correction in the searched "
                            "range restores it; the error covers the remaining positions.",
                            0});
  }
  if (load) answer.loads = aimed_loads(*load, task, answer.result.value);
  for (const AimedLoad& l : answer.loads)
    if (std::isnan(l.after.max_pressure))
      job.warnings.push_back(
          {WarningCode::load_unfinished,
           fmt::format("At {} N m the corrected teeth have no result at a position, because no "
                       "teeth touch there or the forces do not converge.",
                       format_number(l.torque / kMmPerM)),
           0});
  for (std::size_t k = 0; k < answer.corrections.size(); ++k) {
    answer.spec_keys.push_back(spec_key(job, setup, answer.corrections[k]));
    answer.at_bound.push_back(at_bound(task.corrections[k], answer.result.value[k]));
  }
  if (auto warning = bound_warning(answer)) job.warnings.push_back(std::move(*warning));
  answer.corrected = std::make_shared<const SpecTree>(
      SpecTree{corrected_spec(job, setup, answer.corrections, answer.result.value)});
  auto verdict = judge_corrected(answer.corrected->tables, job, answer.loads);
  if (!verdict) return verdict.error();
  answer.verdict = std::move(verdict).take();
  return answer;
}

}  // namespace gearwright
