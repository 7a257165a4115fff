// Teeth thinned for the backlash that [pair] asks for.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/pair/partners.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

/// Sets the thickness allowances of both gears so that the pair has the backlash at its place, split
/// as [pair] says. Backlash is linear in the allowances of involute teeth and nearly so in those of
/// arcs; it is measured on the mounted pair itself, so that it is what the answer says it is.
///
/// Accuracy  1e-9 mm, or degrees
/// Domain    wants_backlash(spec.pair), two gears cut by racks, their shifts complete (contract)
/// Errors    `pair.backlash…` where no teeth have it
std::optional<Error> thin_for_backlash(JobSpec& spec, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings);

}  // namespace gearwright
