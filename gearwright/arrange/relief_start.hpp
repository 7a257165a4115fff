// Computes where short and long reliefs start. A relief that is given by its amount alone is short.
//
//   ε_α   transverse contact ratio over the usable flanks       p_bt   transverse base pitch
//   ρ     radius of curvature of a flank, which gives the position on the path of contact
//
// Short tip reliefs on both gears leave one base pitch of the path without relief, so an unrelieved
// tooth is always in contact. Each relief covers half of the remaining path, (ε_α − 1) p_bt/2. A
// long relief covers (ε_α − 1) p_bt. It ends where single pair contact begins. Root reliefs divide
// the path in the same way from the other end.
//                                       theory: docs/theory/12-loaded-contact.md
#pragma once

#include <optional>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

enum class ReliefLength { short_relief, long_relief };

/// Start diameters of the tip reliefs and of the root reliefs of gear `which`, mm. None if the axes
/// cross or the contact ratio of the flanks is at most 1. Long reliefs also need a contact ratio
/// below 2, because otherwise there is no single pair contact.
///
/// Formula   [T12.29]
struct ReliefStarts {
  double tip, root;
};
std::optional<ReliefStarts> relief_starts(const InvolutePair& pair, int which,
                                          ReliefLength length = ReliefLength::short_relief);

/// True if some tip or root relief has no start.
bool lacks_relief_start(const GivenPair& given);
/// The error about the first relief without a start, if there is no mating gear.
Error missing_relief_start(const GivenPair& given);

/// Sets the start of each tip or root relief that has none, on both gears of a pair.
///
/// Errors    `gearN.modifications.tip_relief.reach` if the pair allows no such start
std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair);

}  // namespace gearwright
