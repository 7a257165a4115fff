// STEP files as a module beside the program, which loads it when the first one is written: OCCT's
// sixty libraries cost 0.2 s at every start, and most runs write none.
//
// Both sides are of one build; `gearwright_step_version` says so before anything else is called.
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/version.hpp"
#include "gearwright/cad/step.hpp"

extern "C" {

__attribute__((visibility("default"))) const char* gearwright_step_version() {
  return gearwright::kVersion;
}

/// As step_document.   Throws  IoError
__attribute__((visibility("default"))) void gearwright_step_document(
    const std::vector<gearwright::ToothedBody>& bodies, const std::string& file_name,
    std::optional<gearwright::Result<gearwright::StepDocument>>& made) {
  made.emplace(gearwright::step_document(bodies, file_name));
}
}
