#include "apps/cli/step_module.hpp"

#ifdef GEARWRIGHT_STEP_MODULE

#include <dlfcn.h>

#include <cstring>
#include <optional>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"

namespace gearwright::cli {

namespace {

namespace fs = std::filesystem;

using Version = const char* (*)();
using Document = void (*)(const std::vector<ToothedBody>&, const std::string&,
                          std::optional<Result<StepDocument>>&);

// Beside the program, as the build leaves it, or where the installation has it.
std::optional<fs::path> module_path() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  for (const char* folder : {"", GEARWRIGHT_STEP_FOLDER}) {
    const fs::path path = program.parent_path() / folder / GEARWRIGHT_STEP_MODULE;
    if (fs::is_regular_file(path, error)) return path;
  }
  return std::nullopt;
}

Document load(const fs::path& path) {
  const auto fail = [&](const char* why) -> Document {
    throw IoError("cannot load " + path.string() + ", which writes STEP files: " + why);
  };
  // Never unloaded: OCCT keeps objects to the end of the program.
  void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) return fail(dlerror());
  const auto version = reinterpret_cast<Version>(dlsym(module, "gearwright_step_version"));
  const auto document = reinterpret_cast<Document>(dlsym(module, "gearwright_step_document"));
  if (!version || !document || std::strcmp(version(), kVersion) != 0)
    return fail("it is of another version of gearwright");
  return document;
}

}  // namespace

StepMaker step_maker() {
  const auto path = module_path();
  if (!path) return {};
  return [path = *path](const std::vector<ToothedBody>& bodies, const std::string& name) {
    static const Document document = load(path);
    std::optional<Result<StepDocument>> made;
    document(bodies, name, made);
    return *std::move(made);
  };
}

}  // namespace gearwright::cli

#else

namespace gearwright::cli {

StepMaker step_maker() { return {}; }

}  // namespace gearwright::cli

#endif
