// The verb batch: many specs through one process.
#pragma once

#include <string>

#include "apps/cli/verbs.hpp"

namespace gearwright::apps {

/// Reads specs from lines of JSON and writes answers as lines of JSON. Returns 1 if one of the
/// answers is an error, and 5 if one is a defect of Gearwright.
/// Throws    IoError
int batch_verb(const Options& o);

}  // namespace gearwright::apps
