#include "gearwright/job/propose_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/continuous.hpp"
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

// Computes the effects of the modifications of a job in the same way as the verbs `load` and
// `contact`. `task` is the task of the job. Warnings about the result are added to the job. Returns
// the compliance without deviations of the helix slopes.
Result<const PairCompliance*> find_effects(Proposal& p, SolvedJob& job, LoadTask task,
                                           SliceResolutions& resolutions,
                                           const std::optional<double>& helix_deviation) {
  const auto solved =
      resolutions.solve(task, [](const LoadTask& with, const PairCompliance& compliance) {
        LoadRequest request = with.request;
        request.progress = nullptr;  // null, because the progress counts proposals
        return std::vector{loaded_contact(with.pair(), with.setup.gear(1), with.setup.gear(2),
                                          compliance, request)};
      });
  if (!solved) return solved.error();
  task.request.slices = solved->slices;
  task.request.progress = nullptr;
  const LoadedContact& contact = solved->contacts.front();
  if (auto error = judge_load(task, contact, job.warnings)) return *error;
  const auto scores = scores_of(contact);
  for (std::size_t i = 0; i < scores.size(); ++i)
    p.loads.push_back({task.request.torques[i], scores[i]});
  p.worst = worst_of(scores);
  const auto most = std::max_element(
      contact.torques.begin(), contact.torques.end(),
      [](const LoadedTorque& x, const LoadedTorque& y) { return x.torque < y.torque; });
  p.without_load = continuous_span(task.pair(), job.spec.contact.positions);
  for (const LoadedPosition& at : most->positions)
    p.transmission_error.push_back({at.rotation1.deg(), at.te.arcsec()});
  if (!helix_deviation) return solved->compliance;
  const auto limits =
      resolutions.solve(task, [&](const LoadTask& with, const PairCompliance& compliance) {
        return contacts_at_limits(with, compliance, *helix_deviation);
      });
  if (!limits) return limits.error();
  std::vector<LoadedScore> both;
  for (const LoadedContact& limit : limits->contacts) both.push_back(worst_of(scores_of(limit)));
  p.at_limits = worst_of(both);
  return solved->compliance;
}

// Returns the load task of a job over a whole pitch, without root stress. At single rotations, the
// transmission error would have no peak to peak, and loaded edges would be missed.
Result<LoadTask> quick_task(SolvedJob& job) {
  auto made = load_task(job);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.rotations.clear();
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

// Returns the score at the limits of the helix slope deviation or, without a deviation, of the
// nominal teeth.
const LoadedScore& at_limits_of(const Proposal& p) { return p.at_limits ? *p.at_limits : p.worst; }

// Greatest factor by which the pressure may increase in order to relieve edges at the limits of the
// helix slopes. Because p_H ∝ √F, 10 % more pressure corresponds to 21 % more torque.
constexpr double kMostPressure = 1.1;

// A difference of the transmission error along the line of action, mm, that is too small to justify
// more pressure. It is half of the step of 1 µm in which the amounts are made.
constexpr double kSameTransmission = 0.5 / kUmPerMm;

// Returns 0 if no edge carries load at the limits of the helix slopes, 1 if an edge carries load
// there, and 2 if the pressure without deviations exceeds kMostPressure · least.
int rank_of(const Proposal& p, double least) {
  if (p.worst.max_pressure > kMostPressure * least) return 2;
  return at_limits_of(p).edge_carries ? 1 : 0;
}

// Returns the score whose pressure is compared with that of other proposals of this rank. If an
// edge carries load at the limits of the helix slopes, the pressure there is only a lower bound.
const LoadedScore& pressed(const Proposal& p, int rank) {
  return rank == 0 ? at_limits_of(p) : p.worst;
}

bool rises(const LoadedScore& s, const LoadedScore& given) {
  return std::isfinite(given.peak_to_peak.rad()) && s.peak_to_peak.rad() > given.peak_to_peak.rad();
}

bool has_result(const Proposal& p) {
  return std::isfinite(p.worst.peak_to_peak.rad()) && std::isfinite(at_limits_of(p).max_pressure);
}

// True if a proposal has a result whose transmission error exceeds that of the given spec by at most
// `same`, rad.
bool is_possible(const Proposal& p, const Proposal& given, double same) {
  return has_result(p) && !(p.worst.peak_to_peak.rad() > given.worst.peak_to_peak.rad() + same);
}

// Returns the indices of the proposals that are compared by their pressure. They are possible, no
// edge of theirs carries load unless this is so in all possible proposals, and their transmission
// error exceeds the least one by at most `same`, rad.
std::vector<std::size_t> quiet_proposals(const std::vector<Proposal>& list, double same) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (is_possible(list[i], list.front(), same)) found.push_back(i);
  const auto has_edge = [&](std::size_t i) { return list[i].worst.edge_carries; };
  if (!std::all_of(found.begin(), found.end(), has_edge)) std::erase_if(found, has_edge);
  double least = kInfinity;
  for (const std::size_t i : found) least = std::min(least, list[i].worst.peak_to_peak.rad());
  std::erase_if(found,
                [&](std::size_t i) { return list[i].worst.peak_to_peak.rad() > least + same; });
  return found;
}

double least_pressure(const std::vector<Proposal>& list, const std::vector<std::size_t>& among) {
  double least = kInfinity;
  for (const std::size_t i : among) least = std::min(least, list[i].worst.max_pressure);
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

// Returns a sentence about a quiet proposal in which no edge carries load, even at the limits of the
// helix slopes. If there are several, it is the one with the least transmission error. The text is
// empty if there is no such proposal.
std::string too_pressed(const std::vector<Proposal>& list, const std::vector<std::size_t>& quiet,
                        const Proposal& best) {
  std::optional<std::size_t> free;
  for (const std::size_t i : quiet) {
    const Proposal& p = list[i];
    if (at_limits_of(p).edge_carries) continue;
    if (!free || p.worst.peak_to_peak.rad() < list[*free].worst.peak_to_peak.rad()) free = i;
  }
  if (!free) return "";
  const double pressure = list[*free].worst.max_pressure;
  return fmt::format(
      " Proposal {} has no loaded edge at the limits of the helix slopes, but its pressure without "
      "deviations is {:.0f} % greater than the pressure of this proposal ({} N/mm²).",
      *free + 1, 100 * (pressure / best.worst.max_pressure - 1),
      arrow(best.worst.max_pressure, pressure, 0));
}

std::string reason_of(const std::vector<Proposal>& list, std::size_t best, double base_radius_2) {
  const std::vector<std::size_t> quiet = quiet_proposals(list, kSameTransmission / base_radius_2);
  const Proposal& given = list.front();
  const Proposal& p = list[best];
  if (!has_result(p)) return "No proposal has a result under this load.";
  std::string edges;
  if (given.worst.edge_carries && !p.worst.edge_carries)
    edges = "No edge of a tooth carries load in this proposal. ";
  if (p.at_limits && (given.worst.edge_carries || given.at_limits->edge_carries) &&
      !p.worst.edge_carries && !p.at_limits->edge_carries)
    edges =
        "No edge of a tooth carries load in this proposal, not even at the limits of the helix "
        "slopes. ";
  const int rank = rank_of(p, least_pressure(list, quiet));
  const bool compared = best > 0 && has_result(given);
  const auto change = [&](double from, double to, int decimals) {
    return compared ? arrow(from, to, decimals) : fixed_decimals(to, decimals);
  };
  std::string text = fmt::format(
      "{}{}{} is recommended because its pressure ({} N/mm²{}) is the least of all proposals whose "
      "transmission error ({}″) is at most {:g} µm along the line of action greater than the least "
      "one. Proposals with a loaded edge are compared only if there are no others.",
      has_result(given) ? "" : "The spec as given has no result under this load. ", edges,
      best == 0 ? "The spec as given" : "This proposal",
      change(pressed(given, rank).max_pressure, pressed(p, rank).max_pressure, 0),
      p.at_limits && rank == 0 ? " at the limits of the helix slopes" : "",
      change(given.worst.peak_to_peak.arcsec(), p.worst.peak_to_peak.arcsec(), 2),
      kSameTransmission * kUmPerMm);
  if (p.at_limits)
    text += fmt::format(
        " A loaded edge at the limits of the helix slopes is worse, unless its absence costs more "
        "than {:.0f} % of pressure.",
        100 * (kMostPressure - 1));
  if (has_result(given))
    text += fmt::format(
        " Proposals that increase the transmission error by more than {:g} µm are not compared.",
        kSameTransmission * kUmPerMm);
  if (best > 0)
    text += " A proposal with more changes is recommended only if its pressure is lower by 1 %.";
  // Proposals are compared by the transmission error of the nominal teeth. At the limits of the
  // helix slopes, the transmission error may therefore exceed that of the spec as given.
  if (p.at_limits && given.at_limits && rises(*p.at_limits, *given.at_limits))
    text += fmt::format(
        " At the limits of the helix slopes, its transmission error is greater than that of the "
        "spec as given ({}″).",
        arrow(given.at_limits->peak_to_peak.arcsec(), p.at_limits->peak_to_peak.arcsec(), 2));
  if (p.at_limits && p.at_limits->edge_carries && !p.worst.edge_carries)
    text += " At the limits of the helix slopes, an edge of a tooth carries load." +
            too_pressed(list, quiet, p);
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

std::size_t recommended(const std::vector<Proposal>& list, double base_radius_2) {
  GW_EXPECTS(!list.empty() && base_radius_2 > 0.0);
  const std::vector<std::size_t> quiet = quiet_proposals(list, kSameTransmission / base_radius_2);
  const double least = least_pressure(list, quiet);
  int rank = 2;
  for (const std::size_t i : quiet) rank = std::min(rank, rank_of(list[i], least));
  // Later proposals change more of the spec. A later proposal is therefore chosen only if its
  // pressure is lower by more than 1 %.
  constexpr double kWorth = 0.99;
  std::optional<std::size_t> best;
  for (const std::size_t i : quiet) {
    if (rank_of(list[i], least) > rank) continue;
    if (!best ||
        pressed(list[i], rank).max_pressure < kWorth * pressed(list[*best], rank).max_pressure)
      best = i;
  }
  return best.value_or(0);
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
  SliceResolutions resolutions(given.spec.load.slices.has_value());
  Proposal first;
  const auto effects = find_effects(first, jobs.front(), task, resolutions, grades.helix);
  if (!effects) return effects.error();
  const PairCompliance& compliance = **effects;
  task.request.slices = {compliance.slices[0].count, compliance.slices[1].count};
  task.request.progress = nullptr;  // null, because the progress counts proposals
  if (task.request.deflects()) a.deflection = face_deflection(task, compliance, a.torque);
  a.proposals.push_back(std::move(first));
  a.specs.push_back(tree);

  const double face_1 = given.gear(1).spec.face_width;
  const LeadProposal lead =
      propose_lead(a.deflection.value_or(FaceDeflection()), grades.helix.value_or(0.0), face_1,
                   std::min(face_1, given.gear(2).spec.face_width));
  const ProposalList wanted =
      list_proposals(given, task, compliance, lead, grades.pitch.value_or(0.0));
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
      p.without_load = known.without_load;
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
      const auto found = its ? find_effects(p, jobs.back(), *its, resolutions, grades.helix)
                             : Result<const PairCompliance*>(its.error());
      if (!found) {
        error = found.error();
        jobs.pop_back();
      }
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
  const double base_radius_2 = given.gear(2).base_radius();
  a.recommended = recommended(a.proposals, base_radius_2);
  a.reason = reason_of(a.proposals, a.recommended, base_radius_2);
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
