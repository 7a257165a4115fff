// The spec of a proposal, which is the spec of the job with other flank modifications. Internal to
// job/.
#pragma once

#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// The tree with the modifications of the proposal. Its reliefs replace all profile modifications
/// of both gears. Its crowning and slope replace all helix modifications. Either of these also
/// replaces a topography. The slope applies to the loaded flank of gear 1, which is the left flank
/// if gear 2 drives.
Json with_proposal(const Json& tree, const Proposal& proposal, bool gear2_drives);

}  // namespace gearwright
