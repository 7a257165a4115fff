// The verb batch: many specs through one process.
#pragma once

#include <string>

#include "apps/cli/verbs.hpp"

namespace gearwright::apps {

/// Lines of JSON in, lines of JSON out; 1 if one of them is an error, 5 if one is a mistake of ours.
/// Throws    IoError
int batch_verb(const Options& o);

}  // namespace gearwright::apps
