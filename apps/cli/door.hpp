// Reads the spec of a verb, reports its errors and returns its exit status.
#pragma once

#include <optional>

#include "apps/cli/verbs.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::apps {

/// Reads the spec of a verb once, from a file or a pipe, and reports its errors with
/// their lines.
class Door {
 public:
  /// `text` is the spec if it has already been read.
  explicit Door(const Options& o, const SpecText* text = nullptr) : options_(o) {
    if (text) text_ = *text;
  }

  /// Reads the spec. Returns an error if an input that `use` requires is missing.
  Result<JobSpec> read(SpecUse use = SpecUse::geometry);
  Result<SolvedJob> solve(Scope scope, SpecUse use = SpecUse::geometry);
  /// Reports the error with the keys of the spec and returns the exit status.
  int fail(const Error& error) const;

 private:
  const Options& options_;
  std::optional<SpecText> text_;
  std::optional<GivenKeys> given_;
};

// Returns 4 if --strict is given and the verdict is not green, for use in scripts. Otherwise returns 0.
inline int status(const Options& o, const Verdict& verdict) {
  return o.strict && verdict.level != Level::green ? 4 : 0;
}

}  // namespace gearwright::apps
