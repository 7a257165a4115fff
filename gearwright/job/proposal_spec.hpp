// The spec of a proposal: that of the job with other flank modifications. Internal to job/.
#pragma once

#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The tree with the modifications of the proposal. Its reliefs replace all profile modifications of
/// both gears, its crowning and slope replace all helix modifications, and either replaces a
/// topography. The slope is that of the loaded flank of gear 1, the left one if gear 2 drives.
Json with_proposal(const Json& tree, const Proposal& proposal, bool gear2_drives);

}  // namespace gearwright
