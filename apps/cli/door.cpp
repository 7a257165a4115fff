#include "apps/cli/door.hpp"

#include <nlohmann/json.hpp>

#include "apps/common/speaking.hpp"
#include "gearwright/spec/toml_text.hpp"

namespace gearwright::cli {

Result<JobSpec> Door::read(SpecUse use) {
  auto text = read_spec_text(options_.spec);
  if (!text) return text.error();
  text_ = std::move(text).take();
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
  return cli::fail(given_ ? spelled(error, *given_) : error, options_.json,
                   text_ ? &*text_ : nullptr);
}

int take_spec(const Options& o, const Door& door, const std::vector<Json>& specs,
              const std::string& too_many) {
  const auto number = static_cast<std::size_t>(*o.take);
  if (number > specs.size()) return door.fail({"--take", std::to_string(number), too_many});
  if (o.json) {
    print_json(specs[number - 1]);
  } else {
    print(toml_text(specs[number - 1]));
  }
  return 0;
}

}  // namespace gearwright::cli
