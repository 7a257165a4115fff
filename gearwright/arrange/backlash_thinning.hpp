// Thins the teeth for a required backlash. Internal to arrange/.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/partners.hpp"

namespace gearwright {

/// Sets the thickness allowances of both gears so that the pair has the backlash at its place, split
/// by `backlash_split`. Backlash is linear in the allowances of involute teeth and nearly so in those of
/// arcs; it is measured on the mounted pair itself, so it equals the backlash of the result.
///
/// Accuracy  1e-9 mm, or degrees
/// Domain    given.pair.wants_backlash(), two gears cut by racks, their shifts complete (contract)
/// Errors    `pair.backlash…` if no teeth have it
std::optional<Error> thin_for_backlash(GivenPair& given, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings);

}  // namespace gearwright
