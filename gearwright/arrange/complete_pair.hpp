// Profile shifts, centre distance and shaft angle complete each other.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// The place of the pair. Writes the shifts into the gears, a shaft angle that follows from the
/// centre distance into the pair, and shortened tips. `shift_wanted`: one shift or both are absent
/// and follow from the centre distance.
///
/// Domain    two gears (contract)
/// Errors    `gear2.helix_angle` if a sign seems to be missing; as check_partners, complete_shifts
///           and complete_place
Result<PairPlace> complete_pair(GivenPair& given, bool shift_wanted);

}  // namespace gearwright
