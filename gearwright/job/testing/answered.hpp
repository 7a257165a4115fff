// Computes the answer of a verb for the tree of a spec, for the tests of job/.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::testing {

/// Returns the record of the answer. For an error, returns a record with its "key" and its "rule",
/// in which the keys are those of a spec file.
inline Json answered(const Json& tree, std::string_view verb) {
  const auto spec = read_spec_tree(tree, {}, find_verb(verb)->use);
  const auto answer = spec ? answer_json(verb, *spec) : Result<Json>(spec.error());
  if (answer) return *answer;
  const Error error = spec ? spelled(answer.error(), spec->given) : answer.error();
  return {{"key", error.field}, {"rule", error.rule}};
}

}  // namespace gearwright::testing
