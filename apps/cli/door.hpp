// Reads the spec of a verb, reports its errors, and ends the verb.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/verbs.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::apps {

/// The spec of a verb: it is read once, from a file or a pipe, and its errors are reported with
/// their lines.
class Door {
 public:
  explicit Door(const Options& o) : options_(o) {}

  /// An input that is missing for `use` is an error, too.
  Result<JobSpec> read(SpecUse use = SpecUse::geometry);
  Result<SolvedJob> solve(Scope scope, SpecUse use = SpecUse::geometry);
  /// Reports the error in the keys of the spec. Returns the exit status.
  int fail(const Error& error) const;

 private:
  const Options& options_;
  std::optional<SpecText> text_;
  std::optional<GivenKeys> given_;
};

// Returns 4, for scripts, if the verdict is not green and --strict is given.
inline int status(const Options& o, const Verdict& verdict) {
  return o.strict && verdict.level != Level::green ? 4 : 0;
}

}  // namespace gearwright::apps
