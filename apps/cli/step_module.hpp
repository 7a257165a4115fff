// The writer of STEP files, in a module that is loaded when the first file is written.
#pragma once

#include "gearwright/job/files.hpp"

namespace gearwright::cli {

/// Empty where this build, or this installation, has no such module.
StepMaker step_maker();

}  // namespace gearwright::cli
