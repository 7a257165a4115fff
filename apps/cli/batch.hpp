// The verb batch: many specs through one process.
#pragma once

#include <string>

#include "apps/cli/verbs.hpp"

namespace gearwright::apps {

/// Reads lines of JSON and writes lines of JSON. Returns 1 if one of them is an error, and 5 if one
/// is a defect of Gearwright.
/// Throws    IoError
int batch_verb(const Options& o);

}  // namespace gearwright::apps
