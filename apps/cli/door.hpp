// How a verb takes its spec, says what is wrong with it, and ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/verbs.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::apps {

/// The spec of a verb: read once, from a file or a pipe, and what is wrong with it said by its lines.
class Door {
 public:
  explicit Door(const Options& o) : options_(o) {}

  /// What the spec lacks for `use` is an error, too.
  Result<JobSpec> read(SpecUse use = SpecUse::geometry);
  Result<SolvedJob> solve(Scope scope, SpecUse use = SpecUse::geometry);
  /// Says what is wrong, in the keys that the spec has; the exit status.
  int fail(const Error& error) const;

 private:
  const Options& options_;
  std::optional<SpecText> text_;
  std::optional<GivenKeys> given_;
};

// For scripts: 4 where the verdict is not green and they want it to be.
inline int status(const Options& o, const Verdict& verdict) {
  return o.strict && verdict.level != Level::green ? 4 : 0;
}

}  // namespace gearwright::apps
