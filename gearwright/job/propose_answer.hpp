// Flank modifications for a pair under load, with their effects: the verb `propose`.
//
// The amounts follow from the greatest torque, the grades of the gears and the deflection of their
// shafts. Each proposal is a spec, and its effects are those that `load` computes for this spec. The
// tables of the teeth are computed once. Internal to job/ and the programs.
//                           theory: docs/theory/12-loaded-contact.md, [T12.27] to [T12.33]
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct ProposeAnswer : ProposeView {
  std::vector<Json> specs;  ///< of the proposals, the spec as given first
  /// Sentences about each of the specs, as in Answer.
  std::vector<std::vector<std::string>> notes;
  Verdict verdict;  ///< of the recommended proposal, whose warnings the job then has
};

/// Errors    `load.torques` missing, without a torque of [rating]; teeth with point contact;
///           double-helical gears; as answer_load
Result<ProposeAnswer> answer_propose(SolvedJob& job, Progress* progress = nullptr);

/// The index of the recommended proposal; 0 is the spec as given.
///
/// Formula   [T12.33]
/// Domain    at least one proposal (contract)
/// Law       its transmission error is at most that of the first one
std::size_t recommended(const std::vector<Proposal>& proposals);

/// {"propose"}, under its title.
Json propose_json(const SolvedJob& job, const ProposeAnswer& answer);
std::string propose_listing(const SolvedJob& job, const ProposeAnswer& answer);

/// The proposals in the report of `run`; none without a torque in [load] and grades, for gears without
/// proposals, and if there is no result.
std::optional<ProposeAnswer> propose_part(const SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
