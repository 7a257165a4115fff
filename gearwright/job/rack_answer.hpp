// The answer of the verbs gear and pair for a pinion and a rack. Internal to job/.
#pragma once

#include "gearwright/job/verbs.hpp"

namespace gearwright {

/// Errors    as solve() and mount_rack()
/// Domain    the spec has a rack (contract)
Result<Answer> answer_rack(const JobSpec& spec);

}  // namespace gearwright
