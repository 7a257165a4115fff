#include "gearwright/job/compensate_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/torque.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/compensate_forms.hpp"
#include "gearwright/job/compensate_load.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/corrected_spec.hpp"
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
  auto corrections = corrections_of(setup, input.corrections, "compensate.corrections");
  if (!corrections) return corrections.error();
  CompensateAnswer answer;
  answer.corrections = std::move(corrections).take();
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
                       format_number(newton_metres(l.torque))),
           0});
  for (std::size_t k = 0; k < answer.corrections.size(); ++k) {
    answer.spec_keys.push_back(spec_key(setup, answer.corrections[k], gear2_drives));
    answer.at_bound.push_back(at_bound(task.corrections[k], answer.result.value[k]));
  }
  if (auto warning = bound_warning(answer)) job.warnings.push_back(std::move(*warning));
  Json corrected =
      corrected_spec(job, setup, answer.corrections, answer.result.value, gear2_drives);
  corrected.erase("compensate");
  answer.corrected = std::make_shared<const SpecTree>(SpecTree{std::move(corrected)});
  auto verdict = judge_corrected(answer.corrected->tables, job, answer.loads);
  if (!verdict) return verdict.error();
  answer.verdict = std::move(verdict).take();
  return answer;
}

}  // namespace gearwright
