// The spec's pair under torque, and probes of its teeth: the verb `load`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright {

struct LoadAnswer {
  std::optional<LoadedContact> contact;  ///< none: only probes were asked
  std::vector<ProbeAnswer> probes;       ///< of spec.load.probes
};

/// Errors    `load` without torque and probes; `gear2` missing; `pair.…` and `gearN.…` where loaded
///           contact is not made for such gears; `gearN.material.poisson_ratio`, `gearN.bore.…`,
///           `load.slices` too many, `load.probe[i].…`; as ContactSetup
Result<LoadAnswer> answer_load(SolvedJob& job, Headway* headway = nullptr);

/// The same under this one torque on gear 1, N m, with the other numbers of [load].
Result<LoadedContact> contact_under(SolvedJob& job, double torque);

LoadView load_view(const SolvedJob& job, const LoadAnswer& answer);

}  // namespace gearwright
