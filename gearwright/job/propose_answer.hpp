// The verb `propose` computes flank modifications for a pair under load, and their effects.
//
// The amounts are computed from the greatest torque, the grades of the gears and the deflection of
// their shafts. Each proposal is a spec, and its effects are the results of `load` for this spec.
// The compliance of the teeth is computed only once. Internal to job/ and the programs.
//                            theory: docs/theory/12-loaded-contact.md, [T12.27] to [T12.33]
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
  std::vector<Json> specs;  ///< one for each proposal; the first one is the spec as given
  /// Sentences about each of the specs, as in Answer.
  std::vector<std::vector<std::string>> notes;
  Verdict verdict;  ///< on the recommended proposal, with its warnings instead of the warnings of
                    ///< the job
};

/// Computes the proposals, their effects and the verdict on the recommended one.
///
/// Errors    `load.torques` if neither [load] nor [rating] gives a torque; teeth with point
///           contact; double-helical gears; the errors of answer_load
Result<ProposeAnswer> answer_propose(SolvedJob& job, Progress* progress = nullptr);

/// The index of the recommended proposal; 0 is the spec as given.
///
/// Formula   [T12.33]
/// Domain    at least one proposal (contract)
/// Law       the transmission error of the recommended proposal is at most that of the first
///           proposal
std::size_t recommended(const std::vector<Proposal>& proposals);

/// A record with the title, and with the result under "propose".
Json propose_json(const SolvedJob& job, const ProposeAnswer& answer);
std::string propose_listing(const SolvedJob& job, const ProposeAnswer& answer);

/// The proposals in the report of `run`. There are none if [load] has no torque, if the gears have
/// no grades, if `propose` does not support the gears, or if the computation fails.
std::optional<ProposeAnswer> propose_part(const SolvedJob& job, Progress* progress = nullptr);

}  // namespace gearwright
