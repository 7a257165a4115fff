// The modifications that are proposed for a pair, without their effects. Internal to job/.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The combined deviations of both gears in mm, normal to the flank. They are empty if neither gear
/// has a grade. The two gears deviate independently, so each value is the root of the sum of the
/// squares.
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
      short_deflection{};            ///< C_i  mm, for the shortest reliefs with the helix
                                     ///< modifications of the spec
  std::vector<std::string> remarks;  ///< sentences about reliefs that are missing or small
};

/// Proposes reliefs for the load alone and, if there is a pitch deviation, for the load and the
/// pitch deviation. The helix modifications of `lead` are added to all proposals except the first
/// reliefs at the tips, which show the effect of reliefs alone.
///
/// Domain    involute gears on parallel axes (contract)
ProposalList list_proposals(const SolvedJob& job, const LoadTask& task,
                            const PairCompliance& compliance, const LeadProposal& lead,
                            double pitch_deviation);

// The spec of a proposal is the spec of the job with other flank modifications.

/// The tree with the modifications of the proposal. Its reliefs replace all profile modifications
/// of both gears. Its crowning and slope replace all helix modifications. Reliefs, crowning and
/// slope each also replace a topography. The slope applies to the loaded flank of gear 1, which is
/// the left flank if gear 2 drives.
Json with_proposal(const Json& tree, const Proposal& proposal, bool gear2_drives);

}  // namespace gearwright
