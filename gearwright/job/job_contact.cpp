#include "gearwright/job/job_contact.hpp"

#include <fmt/format.h>

#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/modification_keys.hpp"

namespace gearwright {

ContactErrors errors_of(const SolvedJob& job) {
  if (!job.pair && !job.rack) return {};
  // An error of a rack's teeth is rejected later, so its amount does not matter.
  const std::array<const Gear*, 2> gears{job.rack ? &job.rack->pinion : &job.pair->gear(1),
                                         job.rack ? &job.rack->pinion : &job.pair->gear(2)};
  ContactErrors errors;
  for (std::size_t i = 0; i < kErrorCount; ++i)
    error_entries()[i].set(errors, gears, job.spec.errors.value[i]);
  return errors;
}

Result<ContactSetup> setup_of(const SolvedJob& job) {
  if (auto error = one_helix_error(job)) return *error;
  return setup_of(job, errors_of(job));
}

ContactErrors with_error(const ContactSetup& setup, ContactErrors errors, std::size_t index,
                         double value) {
  error_entries()[index].set(errors, setup.gears(), value);
  return errors;
}

bool alike_halves(const SolvedJob& job) {
  const ContactErrors errors = errors_of(job);
  return job.halves[0]->given.stagger_pitches == 0.0 && errors == mirrored(errors);
}

std::vector<NamedInfluence> influences_of(const SolvedJob& job) {
  std::vector<NamedInfluence> list;
  for (const ErrorEntry& e : error_entries()) {
    if (e.kind && !(job.rack && e.gear == 2))
      list.push_back({fmt::format("{}_per_{}", e.name(), e.unit()), e.si(), {*e.kind}});
  }
  for (int which = 1; which <= (job.rack ? 1 : 2); ++which) {
    const auto& flanks = job.completed.gear(which).modifications;
    if (!any_modification(flanks)) continue;
    for (const ModificationEntry& m : modification_entries()) {
      if (!m.placed(flanks[0]) && !m.placed(flanks[1])) continue;
      list.push_back({fmt::format("gear{}_{}_per_um", which, m.name),
                      kMmPerUm,
                      {ErrorKind::center_distance, which, m.parameter}});
    }
  }
  return list;
}

}  // namespace gearwright
