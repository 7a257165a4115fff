#include "apps/cli/door.hpp"

#include "apps/common/output.hpp"

namespace gearwright::apps {

Result<JobSpec> Door::read(SpecUse use) {
  if (!text_) {
    auto text = read_spec_text(options_.spec);
    if (!text) return text.error();
    text_ = std::move(text).take();
  }
  auto spec = read_spec(*text_, use);
  if (spec) given_ = spec->given;
  return spec;
}

Result<SolvedJob> Door::solve(Scope scope, SpecUse use) {
  const auto spec = read(use);
  if (!spec) return spec.error();
  return gearwright::solve(*spec, scope);
}

int Door::fail(const Error& error) const {
  return apps::fail(given_ ? spelled(error, *given_) : error, options_.json,
                    text_ ? &*text_ : nullptr);
}

}  // namespace gearwright::apps
