// The verb `propose` computes flank modifications for a pair under load, and their effects.
//
// The amounts follow from the greatest torque, the accuracy grades of the gears and the deflection
// of their shafts. Each proposal is a spec, and its effects are the results of `load` for this
// spec. The compliance of the teeth is computed only once. Internal to job/ and the programs.
//                            theory: docs/theory/12-loaded-contact.md, [T12.27] to [T12.33]
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

struct ProposeAnswer : ProposeView {
  std::vector<Json> specs;  ///< one for each proposal; the first one is the spec as given
  /// Sentences about each of the specs, as in Answer::notes.
  std::vector<std::vector<std::string>> notes;
  Verdict verdict;  ///< on the recommended proposal; its warnings replace those of the job
};

/// Errors    `load.torques` if neither [load] nor [rating] gives a torque; teeth with point
///           contact; double-helical gears; the errors of answer_load
Result<ProposeAnswer> answer_propose(SolvedJob& job, Progress* progress = nullptr);

/// Returns the index of the recommended proposal. Index 0 is the spec as given. `base_radius_2` is
/// r_b2 in mm, which converts the transmission error to the line of action.
///
/// Formula   [T12.33]
/// Domain    at least one proposal (contract)
/// Law       the transmission error of the recommended proposal exceeds that of the first proposal
///           by at most 0.5 µm along the line of action
std::size_t recommended(const std::vector<Proposal>& proposals, double base_radius_2);

std::string propose_listing(const SolvedJob& job, const ProposeAnswer& answer);

/// Returns the proposals in the report of `run`. There are none if [load] has no torque or lists
/// rotations, if the gears have no accuracy grades, if `propose` does not support the gears, or if
/// the computation fails.
std::optional<ProposeAnswer> propose_part(const SolvedJob& job, Progress* progress);

// The modifications proposed for a pair, without their effects. Only files of job/ use them.

/// The combined deviations of both gears in mm, normal to the flank. They are empty if neither gear
/// has an accuracy grade. The two gears deviate independently, so each value is the root of the sum
/// of the squares of both deviations.
///
/// Formula   [T12.28], [T12.32]
struct GradeDeviations {
  std::optional<double> pitch;  ///< deviation of the base pitch
  std::optional<double> helix;  ///< deviation of the helix slope, over the common face
};
GradeDeviations grade_deviations(const SolvedJob& job);

struct ProposalList {
  std::vector<Proposal> proposals;
  std::optional<std::array<double, 2>>
      short_deflection{};            ///< C_i mm, of the shortest reliefs that exist for the helix
                                     ///< modifications of the spec
  std::vector<std::string> remarks;  ///< sentences about reliefs that are missing or small
};

/// Proposes reliefs for the load alone and, if there is a pitch deviation, for the load together
/// with the pitch deviation. If `lead` has helix modifications, the first proposals are tip reliefs
/// without them. These proposals show the effect of reliefs alone. All other proposals contain the
/// modifications of `lead`.
///
/// Domain    involute gears on parallel axes (contract)
ProposalList list_proposals(const SolvedJob& job, const LoadTask& task,
                            const PairCompliance& compliance, const LeadProposal& lead,
                            double pitch_deviation);

/// Returns the tree with the modifications of the proposal. The reliefs of the proposal replace all
/// profile modifications of both gears. The crowning and the slope of the proposal replace all
/// helix modifications. Each of them also replaces a topography. The slope applies to the loaded
/// flank of gear 1. This is the left flank if gear 2 drives.
Json with_proposal(const Json& tree, const Proposal& proposal, bool gear2_drives);

}  // namespace gearwright
