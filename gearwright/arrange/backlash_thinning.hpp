// Thins the teeth to obtain a required backlash. Internal to arrange/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// Sets the thickness allowances of both gears so that the mounted pair has the requested backlash.
/// `backlash_split` divides the thinning between the gears. Backlash depends linearly on the
/// allowances of involute teeth, and nearly linearly on the allowances of circular-arc teeth. The
/// function computes the backlash of the mounted pair and corrects the allowances until it equals
/// the requested one.
///
/// Accuracy  1e-9 mm, or degrees
/// Domain    given.pair.wants_backlash(), two gears cut by racks, their shifts complete (contract)
/// Errors    `pair.backlash…` if no allowances give this backlash
std::optional<Error> thin_for_backlash(GivenPair& given, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings);

}  // namespace gearwright
