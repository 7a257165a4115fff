// What a verb prints with --json, for doors that ask for many answers: case files, batches.
// Internal to job/ and the program.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "gearwright/base/headway.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Verbs that answer a spec with one JSON object and write no file.
inline constexpr std::array<std::string_view, 9> kAnswering{
    "gear", "pair", "measure", "contact", "compensate", "load", "fit", "identify", "rate"};

/// The answer of one of kAnswering; of an empty verb that of `pair` where there are two gears, else
/// of `gear`.
///
/// Domain    such a verb (contract)
/// Throws    IoError when a file that the spec names cannot be read
Result<Json> answer_json(std::string_view verb, const JobSpec& spec, Headway* headway = nullptr);

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
