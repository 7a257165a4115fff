#include "gearwright/job/load_report.hpp"

#include <algorithm>

#include "gearwright/arrange/load_standard.hpp"
#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

namespace {

// The positions of the result, or a separate pitch if the spec has other rotations.
Result<LoadedContact> over_a_pitch(const SolvedJob& job, const LoadAnalysis& answer,
                                   Progress* progress) {
  if (job.spec.load.rotations.empty()) return *answer.contact;
  SolvedJob again = job;  // its warnings have been reported
  auto made = load_task(again);
  if (!made) return made.error();
  LoadTask task = std::move(made).take();
  task.request.rotations.clear();
  task.request.progress = progress;
  auto contact = task.contact(*answer.compliance);
  if (auto error = judge_load(task, contact, again.warnings)) return *error;
  return contact;
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
    job.warnings.push_back({code, "No analysis under load: " + why.message() + ".", 0});
    return std::optional<LoadPart>();
  }
  LoadPart part{std::move(made).take(), std::nullopt};
  if (part.answer.contact) {
    auto contact = over_a_pitch(job, part.answer, progress);
    if (!contact) return contact.error();
    part.report = LoadScene{{&job.gears[0], &job.gears[1]},
                            job.pair->parallel(),
                            input.driver == 2,
                            std::move(contact).take(),
                            load_standard(job, part.answer)};
  }
  return std::optional(std::move(part));
}

}  // namespace gearwright
