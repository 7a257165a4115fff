#include "gearwright/job/load_report.hpp"

#include <algorithm>

#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

namespace {

// The result over equal positions of one pitch. If the spec has other rotations, it is computed
// again.
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
    if (job.halves[0] && input.deflection_slope == 0.0 && alike_halves(job))
      part.report->halves.resize(1);
  }
  return std::optional(std::move(part));
}

}  // namespace gearwright
