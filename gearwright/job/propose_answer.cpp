#include "gearwright/job/propose_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/judgement.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

std::optional<Error> not_made_for(const SolvedJob& job) {
  if (auto error = one_helix_error(job)) return error;
  Error error{"", "", "", FailureKind::not_under_load};
  if (job.pair->arcs()) {
    error.field = "gear1.rack";
    error.rule =
        "cuts circular arcs, which touch at points. Proposals are made only for involute teeth "
        "on parallel axes, because reliefs and crownings follow from the load along the contact "
        "lines";
    return error;
  }
  if (!job.pair->parallel()) {
    error.field = "pair.shaft_angle";
    error.value = format_number(job.pair->shaft_angle().deg());
    error.rule =
        "crosses the axes, so that the teeth touch at points. Proposals are made only for involute "
        "teeth on parallel axes, because reliefs and crownings follow from the load along the "
        "contact lines";
    return error;
  }
  return std::nullopt;
}

void complete_torque(JobSpec& spec, Json& tree) {
  const auto torque = torque_of_rating(spec);
  if (!torque) return;
  spec.load.torques = {*torque};
  spec.load.given = true;
  tree["load"]["torque_Nm"] = *torque;
}

LoadedScore worst_of(const std::vector<LoadedScore>& scores) {
  LoadedScore worst = scores.front();
  for (const LoadedScore& s : scores) worst = worse_of(worst, s);
  return worst;
}

// Returns the scores for each torque. If a position has no result, all scores are no_score().
std::vector<LoadedScore> scores_of(const LoadedContact& contact) {
  auto scores = loaded_scores(contact);
  if (scores.empty()) scores.assign(contact.torques.size(), no_score());
  return scores;
}

// Computes the effects of the modifications of a task in the same way as the verb `load`. Warnings
// about the result are added to `warnings`.
std::optional<Error> find_effects(Proposal& p, const LoadTask& task,
                                  const PairCompliance& compliance,
                                  const std::optional<double>& helix_deviation,
                                  std::vector<Warning>& warnings) {
  const LoadedContact contact =
      loaded_contact(task.pair(), task.setup.gear(1), task.setup.gear(2), compliance, task.request);
  if (auto error = judge_load(task, contact, warnings)) return error;
  const auto scores = scores_of(contact);
  for (std::size_t i = 0; i < scores.size(); ++i)
    p.loads.push_back({task.request.torques[i], scores[i]});
  p.worst = worst_of(scores);
  const auto most = std::max_element(
      contact.torques.begin(), contact.torques.end(),
      [](const LoadedTorque& x, const LoadedTorque& y) { return x.torque < y.torque; });
  for (const LoadedPosition& at : most->positions)
    p.transmission_error.push_back({at.rotation1.deg(), at.te.arcsec()});
  if (!helix_deviation) return std::nullopt;
  std::vector<LoadedScore> both;
  for (const LoadedContact& limit : contacts_at_limits(task, compliance, *helix_deviation))
    both.push_back(worst_of(scores_of(limit)));
  p.at_limits = worst_of(both);
  return std::nullopt;
}

// Returns the load task of a job, without root stress.
Result<LoadTask> quick_task(SolvedJob& job) {
  auto made = load_task(job);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.root_stress = false;
  return task;
}

Result<SolvedJob> job_of(const Json& tree) {
  const auto spec = read_spec_tree(tree);
  if (!spec) return spec.error();
  return solve(*spec, Scope::pair);
}

std::string arrow(double from, double to, int decimals) {
  return fmt::format("{} → {}", fixed_decimals(from, decimals), fixed_decimals(to, decimals));
}

// Returns the score whose pressure is compared with other proposals. If the gears have a helix
// slope deviation, this is the score at the limits of the deviation.
const LoadedScore& pressed(const Proposal& p) { return p.at_limits ? *p.at_limits : p.worst; }

// Greatest factor by which the pressure may increase in order to relieve edges at the limits of the
// helix slopes. Because p_H ∝ √F, 10 % more pressure corresponds to 21 % more torque.
constexpr double kMostPressure = 1.1;

// Returns 0 if no edge carries load, 1 if an edge carries load only at the limits of the helix
// slopes, and 2 if an edge carries load without deviations. If the pressure exceeds kMostPressure ·
// least, the result is at least 1.
int edge_rank(const Proposal& p, double least) {
  if (p.worst.edge_carries) return 2;
  return pressed(p).edge_carries || p.worst.max_pressure > kMostPressure * least;
}

bool rises(const LoadedScore& s, const LoadedScore& given) {
  return std::isfinite(given.peak_to_peak.rad()) && s.peak_to_peak.rad() > given.peak_to_peak.rad();
}

bool has_result(const Proposal& p) {
  return std::isfinite(p.worst.peak_to_peak.rad()) && std::isfinite(pressed(p).max_pressure);
}

// True if a proposal has a result whose transmission error does not exceed that of the given spec.
bool is_possible(const Proposal& p, const Proposal& given) {
  return has_result(p) && !rises(p.worst, given.worst);
}

// Returns the first proposal with a result, to which the others are compared. This is the spec as
// given if it has a result. If no proposal has one, the spec as given is returned too.
std::size_t reference(const std::vector<Proposal>& list) {
  const auto it = std::find_if(list.begin(), list.end(), has_result);
  return it == list.end() ? 0 : static_cast<std::size_t>(it - list.begin());
}

// Returns the least pressure among the possible proposals without a loaded edge. Both the pressure
// and the edges refer to the nominal teeth, without deviations.
double least_pressure(const std::vector<Proposal>& list) {
  double least = kInfinity;
  for (const Proposal& p : list)
    if (is_possible(p, list.front()) && !p.worst.edge_carries)
      least = std::min(least, p.worst.max_pressure);
  return least;
}

std::optional<std::size_t> quietest_without_edge(const std::vector<Proposal>& list) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const LoadedScore& s = list[i].worst;
    if (s.edge_carries || !std::isfinite(s.peak_to_peak.rad())) continue;
    if (!best || s.peak_to_peak.rad() < list[*best].worst.peak_to_peak.rad()) best = i;
  }
  return best;
}

// Returns a sentence about a possible proposal in which no edge carries load, even at the limits of
// the helix slopes. If there are several, it is the one with the least transmission error. The text
// is empty if there is no such proposal, or if its pressure does not exceed that of `best`.
std::string too_pressed(const std::vector<Proposal>& list, const Proposal& best) {
  std::optional<std::size_t> free;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Proposal& p = list[i];
    if (!is_possible(p, list.front()) || edge_rank(p, kInfinity) > 0) continue;
    if (!free || p.worst.peak_to_peak.rad() < list[*free].worst.peak_to_peak.rad()) free = i;
  }
  if (!free || list[*free].worst.max_pressure <= best.worst.max_pressure) return "";
  const double pressure = list[*free].worst.max_pressure;
  return fmt::format(
      " Proposal {} has no loaded edge at the limits of the helix slopes, but its pressure without "
      "deviations is {:.0f} % greater than the pressure of this proposal ({} N/mm²).",
      *free + 1, 100 * (pressure / best.worst.max_pressure - 1),
      arrow(best.worst.max_pressure, pressure, 0));
}

std::string reason_of(const std::vector<Proposal>& list, std::size_t best) {
  const Proposal& given = list.front();
  const Proposal& p = list[best];
  std::string edges;
  if (given.worst.edge_carries && !p.worst.edge_carries)
    edges = "No edge of a tooth carries load in this proposal. ";
  if (p.at_limits && (given.worst.edge_carries || given.at_limits->edge_carries) &&
      !p.worst.edge_carries && !p.at_limits->edge_carries)
    edges =
        "No edge of a tooth carries load in this proposal, not even at the limits of the helix "
        "slopes. ";
  std::string text =
      best == 0 ? std::string(
                      "The spec as given is the best proposal. Only proposals that do not increase "
                      "the transmission error are compared with the spec as given.")
      : !has_result(given)
          ? fmt::format(
                "The spec as given has no result under this load. {}Of all proposals, this "
                "proposal has the least sum of transmission error and pressure, each relative to "
                "proposal {}.",
                edges, reference(list) + 1)
          : fmt::format(
                "{}This proposal has the least sum of transmission error ({}″) and pressure ({} "
                "N/mm²{}), each relative to the spec as given. Only proposals that do not increase "
                "the transmission error are compared. A proposal with more changes is recommended "
                "only if it is better by 1 %.",
                edges, arrow(given.worst.peak_to_peak.arcsec(), p.worst.peak_to_peak.arcsec(), 2),
                arrow(pressed(given).max_pressure, pressed(p).max_pressure, 0),
                p.at_limits ? " at the limits of the helix slopes" : "");
  // Proposals are compared by the transmission error of the nominal teeth. At the limits of the
  // helix slopes, the transmission error may therefore exceed that of the spec as given.
  if (p.at_limits && given.at_limits && rises(*p.at_limits, *given.at_limits))
    text += fmt::format(
        " At the limits of the helix slopes, its transmission error is greater than that of the "
        "spec as given ({}″).",
        arrow(given.at_limits->peak_to_peak.arcsec(), p.at_limits->peak_to_peak.arcsec(), 2));
  if (p.at_limits && p.at_limits->edge_carries && !p.worst.edge_carries)
    text += " At the limits of the helix slopes, an edge of a tooth carries load." +
            too_pressed(list, p);
  if (!p.worst.edge_carries) return text;
  if (const auto other = quietest_without_edge(list))
    text += fmt::format(
        " An edge of a tooth carries load, so the pressure is a lower bound. Of the proposals "
        "without a loaded edge, proposal {} has the least transmission error, {}″.",
        *other + 1, fixed_decimals(list[*other].worst.peak_to_peak.arcsec(), 2));
  return text;
}

std::string origin(const ProposeAnswer& a, std::size_t i) {
  if (i == 0) return "This is the spec as given.";
  return fmt::format("Proposal {} of `gearwright propose`: {}.", i + 1, words_of(a.proposals[i]));
}

}  // namespace

std::size_t recommended(const std::vector<Proposal>& list) {
  GW_EXPECTS(!list.empty());
  // A proposal with a smaller edge_rank() is always better. At equal rank, the proposal with the
  // smaller merit is better. Later proposals change more of the spec. At equal rank, a later
  // proposal is therefore chosen only if its merit is smaller by more than 1 %.
  constexpr double kWorth = 0.99;
  const Proposal& given = list.front();
  const Proposal& unit = list[reference(list)];
  const auto merit = [&](const Proposal& p) {
    return p.worst.peak_to_peak.rad() / unit.worst.peak_to_peak.rad() +
           pressed(p).max_pressure / pressed(unit).max_pressure;
  };
  const double least = least_pressure(list);
  std::size_t best = 0;
  double best_merit = merit(given);
  bool found = is_possible(given, given);
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (!is_possible(list[i], given)) continue;
    const int rank = edge_rank(list[i], least);
    const int best_rank = edge_rank(list[best], least);
    const double m = merit(list[i]);
    if (found && (rank > best_rank || (rank == best_rank && !(m < kWorth * best_merit)))) continue;
    best = i;
    best_merit = m;
    found = true;
  }
  return best;
}

std::optional<ProposeAnswer> propose_part(const SolvedJob& job, Progress* progress) {
  if (!job.pair || job.spec.load.torques.empty() || !job.spec.load.rotations.empty() ||
      not_made_for(job) || !grade_deviations(job).pitch)
    return std::nullopt;
  SolvedJob own = job;  // a copy, because `run` already reports the warnings of the spec as given
  auto made = answer_propose(own, progress);
  return made ? std::optional(std::move(made).take()) : std::nullopt;
}

Result<ProposeAnswer> answer_propose(SolvedJob& job, Progress* progress) {
  if (auto error = missing_error(SpecUse::propose, job.spec)) return *error;
  if (auto error = not_made_for(job)) return *error;
  ProposeAnswer a;
  SolvedJob given = job;
  Json tree = job.spec.tree->tables;
  complete_torque(given.spec, tree);
  a.torque = from_newton_metres(
      *std::max_element(given.spec.load.torques.begin(), given.spec.load.torques.end()));
  const GradeDeviations grades = grade_deviations(given);
  a.pitch_deviation = grades.pitch;
  a.helix_deviation = grades.helix;

  std::vector<SolvedJob> jobs{given};
  auto made = quick_task(jobs.front());
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.progress = progress;
  const auto compliance = task.compliance();
  if (!compliance) return compliance.error();
  if (task.request.deflects()) a.deflection = face_deflection(task, *compliance, a.torque);
  task.request.progress = nullptr;  // null, because the progress counts proposals
  Proposal first;
  if (auto error = find_effects(first, task, *compliance, grades.helix, jobs.front().warnings))
    return *error;
  a.proposals.push_back(std::move(first));
  a.specs.push_back(tree);

  const double face_1 = given.gear(1).spec.face_width;
  const LeadProposal lead =
      propose_lead(a.deflection.value_or(FaceDeflection()), grades.helix.value_or(0.0), face_1,
                   std::min(face_1, given.gear(2).spec.face_width));
  const ProposalList wanted =
      list_proposals(given, task, *compliance, lead, grades.pitch.value_or(0.0));
  a.short_deflection = wanted.short_deflection;
  begin_stage(progress, "computing the proposals under load",
              static_cast<std::int64_t>(wanted.proposals.size()));
  std::vector<std::string> left_out;
  for (Proposal p : wanted.proposals) {
    count_step(progress);
    Json spec = with_proposal(tree, p, given.spec.load.driver == 2);
    // The order of keys has no meaning, so the specs are compared with sorted keys
    // (nlohmann::json).
    const nlohmann::json sorted = spec;
    const auto same = std::find_if(a.specs.begin(), a.specs.end(),
                                   [&](const Json& s) { return nlohmann::json(s) == sorted; });
    if (same != a.specs.end()) {
      const auto i = static_cast<std::size_t>(same - a.specs.begin());
      const Proposal& known = a.proposals[i];
      p.loads = known.loads;
      p.worst = known.worst;
      p.at_limits = known.at_limits;
      p.transmission_error = known.transmission_error;
      jobs.push_back(jobs[i]);
      a.proposals.push_back(std::move(p));
      a.specs.push_back(std::move(spec));
      continue;
    }
    auto own = job_of(spec);
    std::optional<Error> error;
    if (own) {
      jobs.push_back(std::move(own).take());
      const auto its = quick_task(jobs.back());
      error = its ? find_effects(p, *its, *compliance, grades.helix, jobs.back().warnings)
                  : std::optional<Error>(its.error());
      if (error) jobs.pop_back();
    } else {
      error = own.error();  // the teeth cannot have these modifications
    }
    if (error) {
      left_out.push_back(
          fmt::format("The proposal \"{}\" is left out: {}.", words_of(p), error->message()));
      continue;
    }
    a.proposals.push_back(std::move(p));
    a.specs.push_back(std::move(spec));
  }
  for (std::size_t i = 0; i < a.specs.size(); ++i) a.proposals[i].spec = to_value(a.specs[i]);
  a.recommended = recommended(a.proposals);
  a.reason = reason_of(a.proposals, a.recommended);
  for (const auto& remarks : {wanted.remarks, left_out})
    for (const std::string& remark : remarks) a.reason += " " + remark;
  if (job.spec.errors.any())
    a.reason +=
        " No proposal corrects [errors] by a helix slope. The command `gearwright compensate` "
        "computes corrections of these errors.";
  for (std::size_t i = 0; i < a.proposals.size(); ++i) a.notes.push_back({origin(a, i)});
  job.warnings = jobs[a.recommended].warnings;
  a.verdict = judge(jobs[a.recommended], {.load = true});
  return a;
}

}  // namespace gearwright
