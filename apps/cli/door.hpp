// The spec of a verb: read once, from a file or a pipe, and what is wrong with it said by its lines.
#pragma once

#include <optional>

#include "apps/cli/verbs.hpp"
#include "gearwright/job/solved_job.hpp"

namespace gearwright::cli {

class Door {
 public:
  explicit Door(const Options& o) : options_(o) {}

  Result<JobSpec> read();
  Result<SolvedJob> solve(Scope scope);
  /// Says what is wrong, in the keys that the spec has; the exit status.
  int fail(const Error& error) const;

 private:
  const Options& options_;
  std::optional<SpecText> text_;
  std::optional<GivenKeys> given_;
};

}  // namespace gearwright::cli
