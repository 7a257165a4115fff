// STEP files as the CAD kernel writes them: what step_document is measured against.
#pragma once

#include "gearwright/cad/step.hpp"

namespace gearwright {

/// As step_document.   Throws  IoError where the kernel gives up
Result<StepDocument> occt_step_document(const std::vector<ToothedBody>& bodies,
                                        const std::string& file_name);

}  // namespace gearwright
