#include "gearwright/cad/write_step.hpp"

#include "gearwright/base/output_file.hpp"

namespace gearwright {

Result<StepReport> write_step(const std::vector<ToothedBody>& bodies,
                              const std::filesystem::path& path, const StepOptions& options) {
  auto document = step_document(bodies, path.filename().string(), options);
  if (!document) return document.error();
  write_file(path, document->text);
  return document->report;
}

}  // namespace gearwright
