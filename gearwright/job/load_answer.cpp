#include "gearwright/job/load_answer.hpp"

#include "gearwright/arrange/load_standard.hpp"
#include "gearwright/arrange/loaded_halves.hpp"

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

}  // namespace gearwright
