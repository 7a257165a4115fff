// A STEP file on the disk.
#pragma once

#include <filesystem>

#include "gearwright/cad/step.hpp"

namespace gearwright {

/// Writes the text of step_document to `path`, whole or not at all.
///
/// Throws    IoError naming the path, where the file cannot be written
Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path, const StepOptions& options = {});

}  // namespace gearwright
