// Writes results to stdout and messages to stderr, and determines the exit status of the programs.
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec_text.hpp"

namespace gearwright::apps {

/// Prints the whole text to stdout in one operation, so that a full disk is
/// detected.   Throws  IoError
void print(const std::string& text);
/// Prints the JSON to stdout. Bytes that are not valid UTF-8, for example in a file name, become
/// U+FFFD.   Throws  IoError
void print_json(const Json& j);
/// Prints a spec that a verb proposes, as JSON or as TOML. The notes precede the TOML. With JSON,
/// all notes except the first one are written to stderr.
void print_spec(const Json& spec, bool json, const std::vector<std::string>& notes = {});
/// Prints an answer as JSON, as CSV or as text. If `take` is given, prints only the spec with this
/// number, or returns an error if the answer has no such spec.
std::optional<Error> print_answer(const Answer& answer, bool json, bool csv,
                                  const std::optional<int>& take);
/// Returns the error for a number after `--take` that exceeds the number of specs. If there are no
/// specs, `why_none` is the reason.
Error no_such_spec(int take, std::size_t specs, const std::string& why_none);
/// Returns {"error": …} with the line, the column and the name of the spec, if they are known.
/// The keys in the error must already be keys of the spec.
Json refusal_json(const Error& error, const SpecText* text);
/// Reports that the input is wrong or that the gears are impossible, and returns status 1. If
/// `json` is true, also prints the error as JSON. The keys in the error must already be keys of the
/// spec (catalogue/spelling.hpp). `text` is the spec that contains the error. If `text` is given,
/// the report also contains the name of the spec and the line, unless the error refers to an
/// option.
int fail(const Error& error, bool json, const SpecText* text = nullptr);
/// Reports a wrong command line and returns status 2.
int usage(const std::string& message);
/// The exit status of a defect of Gearwright itself (base/contract.hpp).
inline constexpr int kViolated = 5;
/// Runs `work` and returns its status, or kViolated if it violates a contract. The violation is
/// reported and, if requested, also printed as JSON.
int guarded(const std::function<int()>& work, bool json);

/// The line on stderr that shows the progress of a computation. The line first appears two seconds
/// after the start. On a terminal, the line is overwritten every half second and finally cleared.
/// Elsewhere, a new line is printed every ten seconds.
class StatusLine {
 public:
  ~StatusLine() { clear(); }
  /// If the next text is due, calls `text` with the seconds since the start and shows the result.
  void show(const std::function<std::string(double seconds)>& text);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  bool terminal_ = is_terminal(stderr);
  std::optional<double> shown_;  // s from the start to the last text
};

}  // namespace gearwright::apps
