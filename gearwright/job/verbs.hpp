// The table of the verbs, which all interfaces use.
//
// A verb is a row of the table: its name, its meaning, an example, the properties of its result,
// and its function. The command line with its help, completion and manual page, batch, case files,
// Python and the page read this table. A new verb is one row and one function. Internal to job/ and
// the programs.
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

/// The result of a verb. Output for users is made on request.
struct Answer {
  Json record;                     ///< every quantity, by the catalogue
  std::vector<Warning> warnings;   ///< of the gears and of the results
  std::optional<Verdict> verdict;  ///< none if the verb judges no gears
  std::vector<Json> specs;  ///< proposals: branches, candidates, corrections; the meshes of a drive
  /// Sentences about each of the specs: its origin, then what the user should know. Or none.
  std::vector<std::vector<std::string>> notes;
  Json expanded;         ///< of a drive, the spec with its graph; otherwise null
  std::string why_none;  ///< reason if `specs` is empty, for verbs that propose specs
  std::function<std::string()> listing;  ///< the record for a terminal
  std::function<std::string()> csv;      ///< empty if the verb has no table
};

/// The record, then `warnings` and `verdict` if gears are judged.
Json answer_json(const Answer& answer);
/// The listing, warnings and verdict.
std::string answer_text(const Answer& answer);

struct Verb {
  const char* name;
  const char* meaning;  ///< one sentence without its full stop
  const char* example;
  SpecUse use;       ///< use for which the spec must be complete
  bool csv, strict;  ///< the result has a table; it has a verdict
  bool lasts;        ///< may take seconds, so its progress is shown
  /// The option --take: none; a flag, for a single proposed spec; the number of one of several.
  enum class Take { none, flag, number } take;
  const char* take_meaning;
  /// Throws  IoError if a file named in the spec cannot be read
  Result<Answer> (*run)(const JobSpec& spec, Progress* progress);
};

/// All verbs, in the order for users.
std::span<const Verb> verbs();
/// The verb of this name; null if there is none.
const Verb* find_verb(std::string_view name);
/// "gear, pair, …"
std::string verb_names();

/// The JSON of a verb's result. For an empty name it is that of `pair` if there are two gears,
/// otherwise of `gear`.
///
/// Domain    such a verb (contract)
Result<Json> answer_json(std::string_view verb, const JobSpec& spec, Progress* progress = nullptr);

/// The output of a batch for one spec.
struct BatchLine {
  std::string text;       ///< JSON on one line: the result, or {"error": …}
  bool violated = false;  ///< true if the error is a defect of Gearwright (base/contract.hpp)
};
/// The line for a spec in JSON, computed by `answer`. Every failure is its error, so other lines of
/// a batch are not affected. An input that is missing for `use` is an error, too.
BatchLine batch_line(const std::function<Result<Json>(const JobSpec&)>& answer,
                     const std::string& spec, SpecUse use = SpecUse::geometry);
/// The line for a spec, computed by a verb, as in answer_json.
BatchLine batch_line(std::string_view verb, const std::string& spec);

}  // namespace gearwright
