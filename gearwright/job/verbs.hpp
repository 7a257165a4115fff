// Defines the table of the verbs, which all interfaces use.
//
// Each row of the table is a verb with its name, its meaning, an example, the properties of its
// result and its function. The command line (with its help, completion and manual page), batch,
// case files, Python and the page read this table. A new verb needs one row and one function.
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
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// The specs of a drive.
struct DriveSpecs {
  Json expanded;                                ///< the spec with its graph
  std::vector<Json> meshes;                     ///< each mesh as a pair
  std::vector<std::vector<std::string>> notes;  ///< as Answer::notes, for each mesh
};

/// The result of a verb. The output for users is made only on request.
struct Answer {
  Json record;                     ///< every quantity, with the keys of the catalogue
  std::vector<Warning> warnings;   ///< about the gears and the results
  std::optional<Verdict> verdict;  ///< none if the verb judges no gears
  std::vector<Json> specs;  ///< specs that the verb proposes (branches, candidates, corrections)
  /// For each of the specs, sentences about its origin, followed by facts that are important for
  /// the user. The list may be empty.
  std::vector<std::vector<std::string>> notes;
  std::function<DriveSpecs()> drive_specs;  ///< empty if the result is no drive
  std::string why_none;                  ///< the reason, if a verb that proposes specs finds none
  std::function<std::string()> listing;  ///< the record for a terminal
  std::function<std::string()> csv;      ///< empty if the verb has no table
  /// The text that --json prints. Empty if it is that of answer_json() with the usual line breaks.
  std::function<std::string()> json;
  std::function<Json(UnitSystem)> rows;  ///< rows of the page (job/result_rows.hpp); may be empty
  UnitSystem units =
      UnitSystem::mm;  ///< units of the specs, the notes and the output for users; `record` is in
                       ///< mm
};

/// Returns the answer with its specs and sentences in the units of the spec. The record stays in
/// mm.
Answer in_units_of(const JobSpec& spec, Answer answer);

/// Returns the record in the units of the answer. If the verb judges gears, `warnings` and
/// `verdict` follow. If it does not, `warnings` follow only if there are any.
Json answer_json(const Answer& answer);
/// Returns the text that the option --json prints.
std::string answer_json_text(const Answer& answer);
std::string answer_text(const Answer& answer);

struct Verb {
  const char* name;
  const char* meaning;  ///< one sentence without its full stop
  const char* example;
  SpecUse use;       ///< use of the spec by the verb; it determines the inputs that are required
  bool csv, strict;  ///< `csv`: true if the result has a table; `strict`: true if it has a verdict
  bool lasts;        ///< true if the verb may take seconds; its progress is then shown
  /// The kind of the option --take. A verb has no such option, a flag for a single proposed spec,
  /// or a number that selects one of several specs.
  enum class Take { none, flag, number } take;
  const char* take_meaning;
  Result<Answer> (*solve)(const JobSpec& spec, Progress* progress);
  const char* key = "";                       ///< key of the result in the record; empty if the
                                              ///< record has the gears and the pair instead
  const QuantityTable& (*table)() = nullptr;  ///< the quantities of the result

  /// Returns the answer in the units of the spec.
  ///
  /// Throws  IoError if a file named in the spec cannot be read
  Result<Answer> run(const JobSpec& spec, Progress* progress) const;
};

/// Returns all verbs, in the order in which users see them.
std::span<const Verb> verbs();
/// Returns the verb with this name, or null if there is none.
const Verb* find_verb(std::string_view name);
/// Returns "gear, pair, …".
std::string verb_names();

/// Returns the JSON of the result of a verb. If the name is empty, the verb is `pair` for two gears
/// or a rack, and `gear` for one gear.
///
/// Domain    the verb exists (contract)
Result<Json> answer_json(std::string_view verb, const JobSpec& spec, Progress* progress = nullptr);

struct BatchLine {
  std::string text;  ///< JSON on one line: the result, or {"error": …}
  enum class Outcome {
    answered,
    failed,    ///< the text is the error of the spec
    violated,  ///< the text is the error of a defect of Gearwright (base/contract.hpp)
  } outcome = Outcome::answered;
};
/// Reads a spec in JSON and computes its result with `answer`. If this fails, the text of this line
/// is the error, and the other lines of the batch are not affected. It is also an error if the spec
/// lacks an input that `use` requires.
BatchLine batch_line(const std::function<Result<Json>(const JobSpec&)>& answer,
                     const std::string& spec, SpecUse use = SpecUse::geometry);
/// Reads a spec in JSON and computes its result with a verb, like answer_json().
BatchLine batch_line(std::string_view verb, const std::string& spec);

}  // namespace gearwright
