// The verbs that answer a spec: one table, which all doors walk.
//
// A verb is a row of the table: its name, what it computes, an example, what its answer has, and the
// function that makes the answer. The command line with its help, completion and manual page, batch, case
// files, Python and the page read this table. A new verb is one row and one function.
// Internal to job/ and the programs.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// What a verb found. The forms for people are made when they are called.
struct Answer {
  Json record;                           ///< every quantity, by the catalogue
  std::vector<Warning> warnings;         ///< of the gears and of what was computed
  std::optional<Verdict> verdict;        ///< none: the verb judges no gears
  std::vector<Json> specs;               ///< that it proposes: branches, candidates, corrections
  std::string why_none;                  ///< why `specs` is empty, if it can be
  std::function<std::string()> listing;  ///< the record for a terminal
  std::function<std::string()> csv;      ///< empty: the verb has no table
};

/// The record, then `warnings` and `verdict` if gears are judged.
Json answer_json(const Answer& answer);
/// The listing, warnings and verdict.
std::string answer_text(const Answer& answer);

struct Verb {
  const char* name;
  const char* meaning;  ///< one sentence without its full stop
  const char* example;
  SpecUse use;       ///< for which a spec must be complete
  bool csv, strict;  ///< the answer has a table; it has a verdict
  bool lasts;        ///< it may take seconds: its progress is shown
  /// The option --take: none; a flag, of the one spec that is proposed; the number of one of them.
  enum class Take { none, flag, number } take;
  const char* take_meaning;
  /// Throws  IoError when a file that the spec names cannot be read
  Result<Answer> (*run)(const JobSpec& spec, Progress* progress);
};

/// In the order in which a user meets them.
std::span<const Verb> verbs();
/// Null: there is no such verb.
const Verb* find_verb(std::string_view name);
/// "gear, pair, …"
std::string verb_names();

/// The JSON of a verb's answer; of an empty name that of `pair` where there are two gears, else of
/// `gear`.   Domain  such a verb (contract)
Result<Json> answer_json(std::string_view verb, const JobSpec& spec, Progress* progress = nullptr);

/// What a batch writes for one spec.
struct BatchLine {
  std::string text;       ///< JSON on one line: the answer, or {"error": …}
  bool violated = false;  ///< the error is a mistake of ours (base/contract.hpp)
};
/// The line of a spec in JSON by `answer`. Whatever goes wrong with it is its error: what a batch
/// does with the other lines never depends on it. What the spec lacks for `use` is an error, too.
BatchLine batch_line(const std::function<Result<Json>(const JobSpec&)>& answer,
                     const std::string& spec, SpecUse use = SpecUse::geometry);
/// The same by a verb, as answer_json has it.
BatchLine batch_line(std::string_view verb, const std::string& spec);

}  // namespace gearwright
