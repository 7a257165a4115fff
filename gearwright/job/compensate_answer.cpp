#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/corrected_spec.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/continuous.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/load/nearby_load.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

constexpr int kPositions = kLeastSpanPositions;
// Under load, computing the curve of the transmission error takes about a hundred times as long as
// without load. The search for corrections of loaded teeth therefore uses fewer positions and fewer
// curves.
constexpr int kLoadPositions = 16, kLoadCurves = 120;

bool gear2_drives(const JobSpec& spec) {
  return (under_load(spec.compensate.aim) ? spec.load.driver : spec.contact.driver) == 2;
}

struct NamedErrors {
  std::vector<ErrorValue> values;  // as in Scenario
  ContactErrors errors;
};

std::vector<ContactErrors> errors_of(const std::vector<NamedErrors>& scenarios) {
  std::vector<ContactErrors> errors;
  for (const NamedErrors& s : scenarios) errors.push_back(s.errors);
  return errors;
}

// Returns the scenario in which the errors with the indices `ranged` have the values `value`, in
// the units of their keys. All other errors are those of the spec.
NamedErrors scenario_at(const ContactSetup& setup, const std::vector<std::size_t>& ranged,
                        const std::array<double, kErrorCount>& value) {
  NamedErrors s{{}, setup.place().errors};
  for (const std::size_t i : ranged) {
    s.errors = with_error(setup, s.errors, i, value[i]);
    s.values.push_back({i, value[i]});
  }
  return s;
}

std::vector<std::size_t> ranged_errors(const CompensateInput& input) {
  std::vector<std::size_t> ranged;
  for (std::size_t i = 0; i < kErrorCount; ++i)
    if (input.range[i]) ranged.push_back(i);
  return ranged;
}

// Returns a list of scenarios. The first has the errors of the spec. One scenario for each corner
// of the range follows.
std::vector<NamedErrors> scenarios_of(const ContactSetup& setup, const CompensateInput& input) {
  std::vector<NamedErrors> list{{{}, setup.place().errors}};
  const std::vector<std::size_t> ranged = ranged_errors(input);
  if (ranged.empty()) return list;
  for (std::size_t corner = 0; corner < (1u << ranged.size()); ++corner) {
    std::array<double, kErrorCount> value{};
    for (std::size_t k = 0; k < ranged.size(); ++k)
      value[ranged[k]] = (*input.range[ranged[k]])[(corner >> k) & 1u];
    list.push_back(scenario_at(setup, ranged, value));
  }
  return list;
}

// Returns errors within the ranges of [compensate.range], in the units of their keys, for which the
// peak-to-peak transmission error of the pair exceeds `known`. Returns none if the search finds no
// such errors.
std::optional<std::array<double, kErrorCount>> worse_inside_ranges(const ContactSetup& setup,
                                                                   const JobSpec& spec, Angle known,
                                                                   Progress* progress) {
  const std::vector<std::size_t> ranged = ranged_errors(spec.compensate);
  std::array<double, kErrorCount> value = spec.errors.value;
  std::vector<ScatterTolerance> tolerances;
  for (const std::size_t i : ranged) {
    const auto& [least, greatest] = *spec.compensate.range[i];
    const ErrorEntry& e = error_entries()[i];
    const auto around = Distribution::of({{least - value[i], greatest - value[i]}});
    if (!around) return std::nullopt;
    tolerances.push_back({std::string(e.key), e.si(), *around, static_cast<VaryingError>(i), {}});
  }
  if (ranged.empty()) return std::nullopt;
  const auto x = worse_inside(setup, tolerances, spec.contact.driver == 2, known, progress);
  if (!x) return std::nullopt;
  for (std::size_t k = 0; k < ranged.size(); ++k) {
    const auto& [least, greatest] = *spec.compensate.range[ranged[k]];
    const double digit = std::pow(10.0, std::floor(std::log10(greatest - least)) - 3.0);
    double& v = value[ranged[k]];
    v = std::clamp(digit * std::round((v + (*x)[k]) / digit), least, greatest);
  }
  return value;
}

// Computes the corrections for the scenarios. Without load, the function also searches the ranges
// for errors with which the corrected pair has a greater transmission error than in every scenario.
// If it finds such errors, they become a further scenario, and the corrections are computed again.
// At most kMostInside scenarios are added in this way.
Compensation compensated(const SolvedJob& job, const ContactSetup& setup, CompensationTask& task,
                         const std::vector<WorkshopCorrection>& corrections, bool gear2_drives,
                         std::vector<NamedErrors>& scenarios) {
  constexpr int kMostInside = 4;
  Compensation result = compensate(task);
  for (int k = 0; k < kMostInside && !task.aim; ++k) {
    const auto changed = setup.changed(change_of(corrections, result.value, gear2_drives));
    if (!changed) break;
    const auto inside =
        worse_inside_ranges(*changed, job.spec, result.after.peak_to_peak, task.progress);
    if (!inside) break;
    scenarios.push_back(scenario_at(setup, ranged_errors(job.spec.compensate), *inside));
    const CompensationTask wider =
        compensation_task(setup, corrections, errors_of(scenarios), gear2_drives);
    task.pair_at = wider.pair_at;
    task.scenarios = wider.scenarios;
    result = compensate(task);
  }
  return result;
}

std::optional<Warning> bound_warning(const CompensateAnswer& answer) {
  std::string list;
  for (const FoundCorrection& c : answer.corrections) {
    if (!c.at_bound) continue;
    list += fmt::format("{}{}, {:g} {}", list.empty() ? "" : "; ", c.words, c.value,
                        unit_text(unit_of(c.key)));
  }
  if (list.empty()) return std::nullopt;
  return Warning{
      WarningCode::correction_at_bound,
      fmt::format(
          "These corrections are at the end of the searched range: {}. Larger corrections might be "
          "better, but errors that need them are too large for flank modifications.",
          list),
      0};
}

// Returns, for each torque, the worst score over all scenarios, without and with the corrections.
// The scores are computed at the positions of the report.
std::vector<AimedLoad> aimed_loads(const LoadedAim& load, const LoadedAim::Scores& scores_of,
                                   const CompensationTask& task, const std::vector<double>& found) {
  std::vector<AimedLoad> loads;
  for (const double torque : load.torques()) loads.push_back({torque, {}, {}});
  const std::vector<double> zero(found.size(), 0.0);
  for (int s = 0; s < task.scenarios; ++s) {
    for (const bool after : {false, true}) {
      const auto scores = scores_of(after ? found : zero, s, task.fine_positions);
      for (std::size_t i = 0; i < loads.size(); ++i) {
        LoadedScore& worst = after ? loads[i].after : loads[i].before;
        worst = worse_of(worst, i < scores.size() ? scores[i] : no_score());
      }
    }
  }
  return loads;
}

// Returns the verdict on the corrected spec. `loads` contains the scores under torque without and
// with the corrections.
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
  // Of the warnings of the job, only those about lost contact and about missing results under load
  // are added. They apply to the scenarios, which answer_contact() does not analyse.
  for (const Warning& w : job.warnings) {
    if (w.code == WarningCode::contact_lost || w.code == WarningCode::load_unfinished)
      with.warnings.push_back(w);
  }
  std::vector<double> at_edges;
  for (const AimedLoad& load : loads)
    if (load.after.edge_carries) at_edges.push_back(load.torque);
  if (!at_edges.empty()) with.warnings.push_back(edge_carries_at(at_edges));
  return judge(with, {.contact = &contact->driving, .load = !loads.empty()});
}

// Adds the closed forms for circular-arc teeth to the answer. Returns the values of the corrections
// with which the search starts. If a correction has no closed form, its start value is 0.
std::vector<double> closed_forms(const SolvedJob& job, const ContactSetup& setup,
                                 const std::vector<WorkshopCorrection>& corrections,
                                 CompensateAnswer& answer) {
  std::vector<double> values(corrections.size(), 0.0);
  const ArcPair* const arcs = job.pair->arcs();
  if (!arcs) return values;
  answer.setting = arc_setting(*arcs, setup);
  answer.lead = lead_without_slope(*arcs, setup, job.spec.contact.driver == 2);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const WorkshopCorrection& c = corrections[k];
    if (c.is(CutterSetting::tool_setting) && answer.setting) values[k] = answer.setting->exact;
    if (c.is(CutterSetting::cutter_lead) && c.gear == 1 && answer.lead)
      values[k] = answer.lead->exact[0].value_or(Angle()).rad() / kRadPerDeg;
  }
  return values;
}

void warn_of_positions(SolvedJob& job, const CompensateAnswer& answer) {
  if (answer.after.lost && !warns(job, WarningCode::contact_lost)) {
    job.warnings.push_back(
        {WarningCode::contact_lost,
         "Contact is lost at some positions, and no correction in the searched range restores "
         "contact. The transmission error covers the remaining positions.",
         0});
  }
  for (const AimedLoad& l : answer.loads)
    if (std::isnan(l.after.max_pressure))
      job.warnings.push_back(
          {WarningCode::load_unfinished,
           fmt::format("At {} N m there is no result for a position of the corrected teeth, "
                       "because no teeth touch there or the forces do not converge.",
                       format_number(newton_metres(l.torque))),
           0});
}

}  // namespace

Result<CompensateAnswer> answer_compensate(SolvedJob& job, Progress* progress, int curves) {
  if (auto error = missing_error(SpecUse::compensate, job.spec)) return *error;
  auto made = setup_of(job);
  if (!made) return made.error();
  const ContactSetup setup = std::move(made).take();
  const CompensateInput& input = job.spec.compensate;
  const auto corrections = corrections_of(setup, input.corrections, "compensate.corrections");
  if (!corrections) return corrections.error();
  CompensateAnswer answer;
  const bool gear2_drives = gearwright::gear2_drives(job.spec);
  // Without corrections, the pair must have contact in at least one position. Otherwise, there is
  // no transmission error to minimise.
  if (!sampled_peak_to_peak(
          transmission_error(setup.pair(gear2_drives), job.spec.contact.positions)))
    return nothing_touches(setup);
  std::vector<NamedErrors> scenarios = scenarios_of(setup, input);
  const bool with_load = under_load(input.aim);
  CompensationTask task =
      compensation_task(with_load ? with_fields_for(setup, *corrections) : setup, *corrections,
                        errors_of(scenarios), gear2_drives);
  task.positions = kPositions;
  task.progress = progress;
  task.curves = curves;
  task.fine_positions = job.spec.contact.positions;
  answer.aim = input.aim;
  std::optional<LoadedAim> load;
  LoadedAim::Scores scores;
  if (with_load) {
    auto aimed = LoadedAim::of(job, progress);
    if (!aimed) return aimed.error();
    load = std::move(aimed).take();
    scores = load->scores_of(task);
    task.aim = load->aim(task, scores, *corrections);
    task.fine_positions = load->positions();
    task.positions = std::min(kLoadPositions, task.fine_positions);
    task.curves = std::min(curves, kLoadCurves);
  }
  if (input.centering_arcsec) task.centering = Angle::arcseconds(*input.centering_arcsec);
  task.starts.push_back(closed_forms(job, setup, *corrections, answer));
  if (answer.setting && answer.setting->angle_nominal) {
    // Difference between the rack angle at the end of the flank and the rack angle of the drawing.
    constexpr Angle kProfileEnd = Angle::degrees(10);
    task.profile = {*answer.setting->angle_nominal, kProfileEnd};
  }
  const Compensation result = compensated(job, setup, task, *corrections, gear2_drives, scenarios);
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (result.each_after[i].nothing_touches())
      return nothing_touches_under(setup, errors_text(scenarios[i].values), scenarios[i].errors);
    answer.scenarios.push_back({scenarios[i].values, result.each_before[i], result.each_after[i]});
  }
  answer.before = result.before;
  answer.after = result.after;
  answer.nothing_to_correct = result.nothing_to_correct();
  answer.centering = result.centering;
  if (load) answer.loads = aimed_loads(*load, scores, task, result.value);
  warn_of_positions(job, answer);
  for (std::size_t k = 0; k < corrections->size(); ++k) {
    const WorkshopCorrection& c = (*corrections)[k];
    answer.corrections.push_back(found_correction(c, result.value[k],
                                                  spec_key(setup, c, gear2_drives),
                                                  at_bound(task.corrections[k], result.value[k])));
  }
  if (auto warning = bound_warning(answer)) job.warnings.push_back(std::move(*warning));
  Json corrected = corrected_spec(job, setup, *corrections, result.value, gear2_drives);
  corrected.erase("compensate");
  answer.spec = to_value(corrected);
  answer.corrected = std::make_shared<const SpecTree>(SpecTree{std::move(corrected)});
  auto verdict = judge_corrected(answer.corrected->tables, job, answer.loads);
  if (!verdict) return verdict.error();
  answer.verdict = std::move(verdict).take();
  if (!answer.nothing_to_correct)
    answer.verdict.headline.insert(0, "This verdict applies to the pair with all corrections. ");
  return answer;
}

namespace {

// Two pressures count as equal if they differ by less than this value, MPa. It is about one
// ten-thousandth of a usual flank pressure.
constexpr double kSamePressure = 0.1;

}  // namespace

Result<LoadedAim> LoadedAim::of(SolvedJob& job, Progress* progress) {
  auto made = load_task(job);
  if (!made) return made.error();
  Held held{std::move(made).take(), {}, job.spec.compensate.aim};
  LoadRequest& request = held.task.request;
  request.rotations.clear();
  request.root_stress = false;
  request.progress = progress;
  SliceResolutions resolutions(job.spec.load.slices.has_value());
  auto found = resolutions.solve(held.task, one_contact);
  if (!found) return found.error();
  request.slices = found->slices;
  held.compliance = *found->compliance;
  request.progress = nullptr;        // the progress counts trials, not the steps of an analysis
  std::vector<Warning> of_the_pair;  // warnings about the uncorrected pair; they are not reported
  if (auto error = judge_load(held.task, found->contacts.front(), of_the_pair)) return *error;
  return LoadedAim(std::make_shared<const Held>(std::move(held)));
}

std::vector<LoadedScore> LoadedAim::scores(const ContactPair& pair, int positions) const {
  const LoadTask& task = held_->task;
  LoadRequest request = task.request;
  request.positions = positions;
  return loaded_scores(
      loaded_contact(pair, task.setup.gear(1), task.setup.gear(2), held_->compliance, request));
}

LoadedAim::Scores LoadedAim::scores_of(const CompensationTask& task) const {
  using Key = std::tuple<std::vector<double>, int, int>;
  const auto known = std::make_shared<std::map<Key, std::vector<LoadedScore>>>();
  return [self = *this, pair_at = task.pair_at, known](const std::vector<double>& v, int scenario,
                                                       int positions) {
    const auto [at, is_new] = known->try_emplace({v, scenario, positions});
    if (const auto pair = is_new ? pair_at(v, scenario) : nullptr)
      at->second = self.scores(*pair, positions);
    return at->second;
  };
}

CompensationAim LoadedAim::aim(const CompensationTask& task, const Scores& scores_of,
                               const std::vector<WorkshopCorrection>& corrections) const {
  const bool pressure = held_->aim == CompensateAim::pressure;
  CompensationAim aim;
  aim.same = pressure ? kSamePressure : kSameError.rad();
  aim.of = [scores_of, pressure](const std::vector<double>& v, int scenario, int positions) {
    const auto scores = scores_of(v, scenario, positions);
    if (scores.empty()) return kInfinity;
    double worst = 0.0;
    for (const LoadedScore& s : scores)
      worst = std::max(worst, pressure ? s.max_pressure : s.peak_to_peak.rad());
    return worst;
  };
  const auto influences = influences_of(corrections);
  if (!influences || held_->task.request.regime == LoadRegime::point) return aim;
  aim.near = [self = *this, pair_at = task.pair_at, pressure, influences](
                 const std::vector<double>& v, int scenario, int positions) {
    const LoadTask& loaded = self.held_->task;
    LoadRequest request = loaded.request;
    request.positions = positions;
    const auto load = std::make_shared<const NearbyLoad>(
        *pair_at(v, scenario), loaded.setup.gear(1), loaded.setup.gear(2), self.held_->compliance,
        request, *influences);
    const auto in_mm = [](std::vector<double> change) {
      for (double& um : change) um *= kMmPerUm;
      return change;
    };
    const auto value = [load, pressure, in_mm](const std::vector<double>& change) {
      const NearbyLoad::Span span = load->span(in_mm(change), false);
      return !span.value ? kInfinity : pressure ? span.max_pressure : *span.value;
    };
    const auto tangents = [load, pressure, in_mm](const std::vector<double>& change) {
      auto made = load->tangents(in_mm(change));
      if (!made) return Tangents{};
      const GreatestTangent greatest = [pressure,
                                        of = *std::move(made)](const Eigen::VectorXd& um) {
        const Eigen::VectorXd step = um * kMmPerUm;
        Tangent t = pressure ? of.pressure_squared(step) : of.span(step);
        t.slope *= kMmPerUm;
        return t;
      };
      const auto n = static_cast<Eigen::Index>(change.size());
      return Tangents{greatest(Eigen::VectorXd::Zero(n)).value, greatest};
    };
    return CompensationAim::Estimate{value, tangents};
  };
  return aim;
}

}  // namespace gearwright
