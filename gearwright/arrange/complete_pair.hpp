// Computes the profile shifts, the centre distance and the shaft angle of a pair if they are not
// given. Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// Returns the position of the gears of the pair. Computed shifts and shortened tips are written
/// into the gears of `given`. A shaft angle that follows from the centre distance is written into
/// `given.pair`. `shift_wanted` is true if at least one shift is absent and follows from the centre
/// distance.
///
/// Domain    two gears (contract)
/// Errors    `gear2.helix_angle` if a sign seems to be missing; the errors of check_partners,
///           complete_shifts and complete_place
Result<PairPlace> complete_pair(GivenPair& given, bool shift_wanted);

}  // namespace gearwright
