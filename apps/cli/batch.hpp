// The verb batch, which computes many specs in one process.
#pragma once

#include "apps/cli/verbs.hpp"

namespace gearwright::apps {

/// Reads specs from lines of JSON and writes answers as lines of JSON. Returns 1 if an answer is
/// the error of a spec, and 5 if an answer reports a defect of Gearwright.
/// Throws    IoError
int batch_verb(const Options& o);

}  // namespace gearwright::apps
