// The least centre distance of a crossed pair, exact and as it was found by hand: where on the
// curve a(α_wn) the approximate solutions of pair/series.hpp lie, and what they cost.
#pragma once

#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Near the least centre distance, magnified; empty where there is nothing to compare: no least
/// centre distance, gears of two racks, or a difference of less than 1e-6 µm.
///
/// Domain    crossed axes (contract)
std::string min_distance_figure(const InvolutePair& pair);

/// The solutions with the exact place at the angle of each: Δ to the exact solution. A sentence
/// where all agree (the sum of shifts is nothing), empty where there are none.
///
/// Domain    crossed axes (contract)
std::string min_distance_table(const InvolutePair& pair);

/// Both, folded away: they are for whoever checks a calculation by hand.
///
/// Domain    crossed axes (contract)
std::string min_distance_part(const InvolutePair& pair);

}  // namespace gearwright
