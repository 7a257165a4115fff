#include "gearwright/job/load_answer.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

std::optional<double> torque_of_rating(const JobSpec& spec) {
  if (!spec.load.torques.empty() || !(spec.rating.input.torque > 0.0)) return std::nullopt;
  const double torque = spec.rating.input.torque;
  // A torque that is computed from power and speed has many digits. It is rounded, but at least
  // four digits of a small torque are kept.
  double steps = 1e3;  // per N m
  while (torque * steps < 1e3) steps *= 10;
  return std::round(torque * steps) / steps;
}

namespace {

std::optional<Error> complete_load(SolvedJob& job) {
  if (auto error = missing_error(SpecUse::load, job.spec)) return error;
  const auto torque = torque_of_rating(job.spec);
  if (!torque || !job.spec.load.probes.empty()) return std::nullopt;
  job.spec.load.torques = {*torque};
  job.spec.load.given = true;
  job.warnings.push_back(
      {WarningCode::torque_of_rating,
       fmt::format(
           "[load] gives no torque, so the nominal torque of [rating], {} N m on gear 1, is used. "
           "This torque does not contain K_A.",
           format_number(*torque)),
       0});
  return std::nullopt;
}

}  // namespace

Result<LoadAnalysis> answer_load(SolvedJob& job, Progress* progress) {
  if (auto error = complete_load(job)) return *error;
  if (job.halves[0])
    return loaded_halves(job, job.halves, errors_of(job), job.spec.load, job.warnings, progress);
  return loaded(job, errors_of(job), job.spec.load, job.warnings, progress);
}

Result<LoadTask> load_task(SolvedJob& job) {
  if (auto error = complete_load(job)) return *error;
  if (auto error = one_helix_error(job)) return *error;
  return load_task(job, errors_of(job), job.spec.load, job.warnings);
}

Result<std::vector<LoadTask>> load_tasks(SolvedJob& job) {
  if (job.halves[0] && !complete_load(job))
    return load_tasks_of_halves(job, job.halves, errors_of(job), job.spec.load, job.warnings);
  auto task = load_task(job);
  if (!task) return task.error();
  return std::vector{std::move(task).take()};
}

namespace {

std::string torque_rows(UnitSystem units, const std::vector<std::string>& names,
                        const std::vector<LoadTorqueView>& torques) {
  std::vector<ValueRecord> records;
  for (const LoadTorqueView& t : torques) records.push_back(load_torque_quantities().of(t));
  return row_listing(units, names, records,
                     {"torque_Nm", "peak_to_peak_arcsec", "mesh_stiffness_N_per_mm_um.mean",
                      "contact_stiffness_N_per_um.mean", "max_pressure_MPa", "max_root_stress_MPa",
                      "face_load_factor"});
}

std::string noise_rows(const SolvedJob& job, const LoadedTorque& torque, LoadRegime regime) {
  std::string out;
  const UnitSystem units = job.spec.units();
  if (regime == LoadRegime::line)
    out += fmt::format(
        "  {:<42}{} {}\n", "Peak to peak along the line of action",
        text_in(units, Unit::um, peak_to_peak_on_line(torque, job.gear(2)) * kUmPerMm, 3),
        unit_text(units, Unit::um));
  std::vector<std::string> waves;
  for (std::size_t k = 0; k < std::min<std::size_t>(5, torque.harmonics.size()); ++k)
    waves.push_back(fixed_decimals(torque.harmonics[k].arcsec(), 4));
  if (!waves.empty())
    out += fmt::format("  {:<42}{} ″\n", "Harmonics 1 to 5, amplitudes", fmt::join(waves, ", "));
  return out;
}

// Lists equally spaced positions of a torque, always fewer than 64. The option --json lists all
// positions.
std::string position_rows(UnitSystem units, const LoadTorqueView& view) {
  const auto& positions = view.torque->positions;
  const std::size_t step = std::max<std::size_t>(1, positions.size() / 32);
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  for (std::size_t at = 0; at < positions.size(); at += step) {
    const LoadedPosition& p = positions[at];
    names.emplace_back(p.solved() ? "" : p.unfinished ? "unfinished" : "no contact");
    records.push_back(load_position_quantities().of({view.torque, &p, view.all->regime}));
  }
  return row_listing(units, names, records,
                     {"rotation1_deg", "transmission_error_arcsec", "approach_um",
                      "max_pressure_MPa", "root_stress_MPa", "kind", "share"});
}

}  // namespace

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
  const auto views = torque_views(*answer.contact, answer.standard);
  for (std::size_t i = 0; i < views.size(); ++i) {
    out += listing_of(units, load_torque_quantities(), views[i]) +
           noise_rows(job, *views[i].torque, answer.contact->regime) +
           "  If a row has two values, the first is for gear 1.\n";
    if (!answer.halves.empty()) {
      std::vector<LoadTorqueView> halves;
      for (const LoadAnalysis& half : answer.halves)
        halves.push_back({&half.contact->torques[i], &*half.contact, {}});
      out += "\n" + torque_rows(units, {"half z > 0", "half z < 0"}, halves);
    }
    out += "\n" + position_rows(units, views[i]) + "\n";
  }
  if (const LoadedTorque* quiet = quietest(*answer.contact)) {
    std::vector<std::string> names;
    for (const LoadTorqueView& view : views)
      names.emplace_back(view.torque == quiet ? "quietest" : "");
    out += torque_rows(units, names, views);
  }
  return out;
}

namespace {

// Returns the result at equally spaced positions over one pitch. If the spec lists rotations, the
// answer has no such positions, and a second result is computed.
Result<LoadAnalysis> over_a_pitch(const SolvedJob& job, const LoadAnalysis& answer,
                                  Progress* progress) {
  if (job.spec.load.rotations.empty()) return answer;
  SolvedJob again = job;  // a copy, because the warnings of `job` have already been reported
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
  SliceResolutions resolutions(job.spec.load.slices.has_value(), *answer.compliance);
  auto found = resolutions.solve(task, one_contact);
  if (!found) return found.error();
  task.request.slices = found->slices;
  if (auto error = judge_load(task, found->contacts.front(), again.warnings)) return *error;
  LoadAnalysis pitch = answer;
  pitch.compliance = *found->compliance;
  pitch.contact = std::move(found->contacts.front());
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

Result<LoadPart> load_with_scene(SolvedJob& job, Progress* progress) {
  auto made = answer_load(job, progress);
  if (!made) return made.error();
  LoadPart part{std::move(made).take(), std::nullopt};
  if (!part.answer.contact) return part;
  const auto pitch = over_a_pitch(job, part.answer, progress);
  if (!pitch) return pitch.error();
  const std::vector<LoadStandard>& standard = part.answer.standard;
  part.report = scene_of(job, *pitch->contact, standard);
  for (const LoadAnalysis& half : pitch->halves)
    part.report->halves.push_back(scene_of(job, *half.contact, standard));
  if (pitch->halves.size() > 1) part.report->halves[1].part = "-2";
  if (job.halves[0] && equal_halves(*job.halves[0], errors_of(job), job.spec.load))
    part.report->halves.resize(1);
  return part;
}

Result<std::optional<LoadPart>> load_part(SolvedJob& job, Progress* progress) {
  const LoadInput& input = job.spec.load;
  if (input.torques.empty() && input.probes.empty()) return std::optional<LoadPart>();
  auto made = load_with_scene(job, progress);
  if (made) return std::optional(std::move(made).take());
  const bool alone = !job.spec.has(2) && !input.torques.empty();
  const bool apart = without_contact(made.error());
  const bool unsupported = made.error().kind == FailureKind::not_under_load;
  if (!alone && !apart && !unsupported) return made.error();
  const WarningCode code = apart ? WarningCode::no_contact : WarningCode::no_load;
  if (warns(job, code)) return std::optional<LoadPart>();
  const Error why = spelled(made.error(), job.spec.given);
  job.warnings.push_back(
      {code, "The analysis under load cannot be computed: " + why.message() + ".", 0});
  return std::optional<LoadPart>();
}

}  // namespace gearwright
