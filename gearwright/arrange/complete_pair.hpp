// Computes the absent ones of profile shifts, centre distance and shaft angle of a pair.
// Internal to arrange/.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// The position of the gears of the pair. Computed shifts and shortened tips are written into the
/// gears of `given`, and a shaft angle that follows from the centre distance into its pair.
/// `shift_wanted` is true if one or both shifts are absent and follow from the centre distance.
///
/// Domain    two gears (contract)
/// Errors    `gear2.helix_angle` if a sign seems to be missing; as check_partners, complete_shifts
///           and complete_place
Result<PairPlace> complete_pair(GivenPair& given, bool shift_wanted);

}  // namespace gearwright
