#include "gearwright/job/load_answer.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/load_standard.hpp"
#include "gearwright/arrange/loaded_halves.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/answer_text.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress) {
  if (auto error = missing_error(SpecUse::load, job.spec)) return *error;
  if (job.halves[0])
    return loaded_halves(job, job.halves, errors_of(job), job.spec.load, job.warnings, progress);
  return loaded(job, errors_of(job), job.spec.load, job.warnings, progress);
}

Result<LoadTask> load_task(SolvedJob& job) {
  if (auto error = missing_error(SpecUse::load, job.spec)) return *error;
  if (auto error = one_helix_error(job)) return *error;
  return load_task(job, errors_of(job), job.spec.load, job.warnings);
}

LoadView load_view(const SolvedJob& job, const LoadAnalysis& answer) {
  LoadView view;
  if (answer.contact) view.contact = &*answer.contact;
  // Each half carries half of the torque, so the values of the standard for one half apply to the
  // whole gears.
  if (answer.contact)
    view.standard = load_standard(job, answer.halves.empty() ? answer : answer.halves.front());
  for (const LoadAnalysis& half : answer.halves) view.halves.push_back(load_view(job, half));
  for (std::size_t i = 0; i < answer.probes.size(); ++i)
    view.probes.push_back({&answer.probes[i], !job.spec.load.probes[i].z});
  return view;
}

namespace {

// One line for each torque with the values that depend on the load.
std::string harris_map(const LoadedContact& contact, const LoadedTorque* quiet) {
  const bool lines = contact.regime == LoadRegime::line;
  std::string out =
      fmt::format("  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}{}\n", "torque", "TE p-p", "stiffness",
                  "pressure", "root 1", "root 2", lines ? fmt::format("{:>9}", "K_Hβ") : "");
  out += fmt::format("  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}\n", "N m", "arcsec",
                     unit_text(lines ? Unit::newton_per_mm_um : Unit::newton_per_um), "N/mm²",
                     "N/mm²", "N/mm²");
  for (const LoadedTorque& t : contact.torques)
    out += fmt::format(
        "  {:>11}{:>14}{:>16}{:>12}{:>11}{:>11}{}{}\n", format_number(newton_metres(t.torque)),
        fixed_decimals(t.peak_to_peak.arcsec(), 4), fixed_decimals(t.stiffness.mean, 3),
        fixed_decimals(t.max_pressure, 1), fixed_decimals(t.max_root_stress[0], 1),
        fixed_decimals(t.max_root_stress[1], 1),
        lines ? fmt::format("{:>9}", fixed_decimals(t.face_load_factor, 3)) : "",
        &t == quiet ? "  quietest" : "");
  return out;
}

// Lists both halves of a double-helical pair under torque number i.
std::string halves_listing(const LoadAnalysis& answer, std::size_t i) {
  std::string out = fmt::format("\n  {:<11}{:>14}{:>12}{:>11}{:>11}{:>9}\n", "", "TE p-p",
                                "pressure", "root 1", "root 2", "K_Hβ");
  for (std::size_t h = 0; h < 2; ++h) {
    const LoadedTorque& t = answer.halves[h].contact->torques[i];
    out +=
        fmt::format("  {:<11}{:>14}{:>12}{:>11}{:>11}{:>9}\n", h == 0 ? "half z > 0" : "half z < 0",
                    fixed_decimals(t.peak_to_peak.arcsec(), 4), fixed_decimals(t.max_pressure, 1),
                    fixed_decimals(t.max_root_stress[0], 1),
                    fixed_decimals(t.max_root_stress[1], 1), fixed_decimals(t.face_load_factor, 3));
  }
  return out;
}

}  // namespace

Json load_json(const SolvedJob& job, const LoadAnalysis& answer) {
  return titled_record(job.spec, "load", load_quantities().of(load_view(job, answer)));
}

std::string load_listing(const SolvedJob& job, const LoadAnalysis& answer) {
  const UnitSystem units = job.spec.units();
  std::string out = title_listing(job.spec);
  for (std::size_t i = 0; i < answer.probes.size(); ++i) {
    const LoadProbeInput& input = job.spec.load.probes[i];
    const ProbeAnswer& p = answer.probes[i];
    const auto position = [&](double mm) { return format_number(value_in(units, Unit::mm, mm)); };
    const std::string_view unit = unit_text(units, Unit::mm);
    out +=
        fmt::format("  Probe {} on gear {}, diameter {} {}: {:.6g} µm per {}\n", i + 1, input.gear,
                    position(input.diameter), unit, p.own * kUmPerMm, input.z ? "N" : "N/mm");
    for (std::size_t k = 0; k < p.profile.size(); ++k)
      out += fmt::format("    z = {:>9} {}{:>16.6g} µm per N\n", position(input.read_z[k]), unit,
                         p.profile[k] * kUmPerMm);
  }
  if (!answer.contact) return out;
  const LoadView whole = load_view(job, answer);
  const auto views = torque_views(*answer.contact, whole.standard);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const LoadedTorque& t = *views[i].torque;
    out += quantity_listing(units, load_torque_quantities().table(),
                            {load_torque_quantities().of(views[i])}, {});
    if (!answer.halves.empty()) out += halves_listing(answer, i);
    out +=
        fmt::format("\n  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11}  {}\n", "rotation1", "TE", "approach",
                    "pressure", "root 1", "root 2", whole.halves.empty() ? "shares" : "");
    out += fmt::format("  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11}\n", "°", "arcsec",
                       unit_text(units, Unit::um), "N/mm²", "N/mm²", "N/mm²");
    // The rows are limited to one page. --json has all positions.
    const std::size_t step = std::max<std::size_t>(1, t.positions.size() / 32);
    for (std::size_t at = 0; at < t.positions.size(); at += step) {
      const LoadedPosition& p = t.positions[at];
      if (!p.solved()) {
        out += fmt::format("  {:>11}{:>14}\n", fixed_decimals(p.rotation1.deg(), 4),
                           p.unfinished ? "unfinished" : "no contact");
        continue;
      }
      std::string shares;
      for (const LoadedPair& k : p.pairs) shares += fmt::format(" {:.3f}", k.share);
      out += fmt::format("  {:>11}{:>14}{:>12}{:>12}{:>11}{:>11} {}\n",
                         fixed_decimals(p.rotation1.deg(), 4), fixed_decimals(p.te.arcsec(), 4),
                         text_in(units, Unit::um, p.approach * kUmPerMm, 4),
                         fixed_decimals(p.max_pressure, 1), fixed_decimals(p.root_stress[0], 1),
                         fixed_decimals(p.root_stress[1], 1), shares);
    }
    out += "\n";
  }
  if (const LoadedTorque* quiet = quietest(*answer.contact))
    out += harris_map(*answer.contact, quiet);
  return out;
}

namespace {

// The result at equally spaced positions over one pitch. If the spec lists rotations instead, the
// result for these positions is computed here.
Result<LoadAnalysis> over_a_pitch(const SolvedJob& job, const LoadAnalysis& answer,
                                  Progress* progress) {
  if (job.spec.load.rotations.empty()) return answer;
  SolvedJob again = job;  // a copy, because its warnings have already been reported
  if (job.halves[0]) {
    again.spec.load.rotations.clear();
    auto made = answer_load(again, progress);
    if (!made) return made.error();
    return std::move(made).take();
  }
  auto made = load_task(again);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.rotations.clear();
  task.request.progress = progress;
  auto contact = task.contact(*answer.compliance);
  if (auto error = judge_load(task, contact, again.warnings)) return *error;
  LoadAnalysis pitch = answer;
  pitch.contact = std::move(contact);
  return pitch;
}

LoadScene scene_of(const SolvedJob& job, const LoadedContact& contact,
                   const std::vector<LoadStandard>& standard) {
  return {{&job.gears[0], &job.gears[1]},
          job.pair->parallel(),
          job.spec.load.driver == 2,
          contact,
          standard};
}

}  // namespace

Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress) {
  const LoadInput& input = job.spec.load;
  if (input.torques.empty() && input.probes.empty()) return std::optional<LoadPart>();
  auto made = answer_load(job, progress);
  if (!made) {
    const bool alone = !job.spec.has(2) && !input.torques.empty();
    const bool apart = without_contact(made.error());
    const bool unsupported = made.error().kind == FailureKind::not_under_load;
    if (!alone && !apart && !unsupported) return made.error();
    const WarningCode code = apart ? WarningCode::no_contact : WarningCode::no_load;
    const auto is_said = [&](const Warning& w) { return w.code == code; };
    if (std::any_of(job.warnings.begin(), job.warnings.end(), is_said))
      return std::optional<LoadPart>();
    const Error why = spelled(made.error(), job.spec.given);
    job.warnings.push_back(
        {code, "The analysis under load cannot be computed: " + why.message() + ".", 0});
    return std::optional<LoadPart>();
  }
  LoadPart part{std::move(made).take(), std::nullopt};
  if (part.answer.contact) {
    const auto pitch = over_a_pitch(job, part.answer, progress);
    if (!pitch) return pitch.error();
    const std::vector<LoadStandard> standard = load_view(job, part.answer).standard;
    part.report = scene_of(job, *pitch->contact, standard);
    for (const LoadAnalysis& half : pitch->halves)
      part.report->halves.push_back(scene_of(job, *half.contact, standard));
    if (pitch->halves.size() > 1) part.report->halves[1].part = "-2";
    if (job.halves[0] && equal_halves(*job.halves[0], errors_of(job), input))
      part.report->halves.resize(1);
  }
  return std::optional(std::move(part));
}

}  // namespace gearwright
