// Computes the starts of short and long reliefs. A relief that is given by its amount alone is short.
//
//   ε_α   transverse contact ratio over the usable flanks       p_bt   transverse base pitch
//   ρ     radius of curvature of a flank, which gives the position on the path of contact
//
// Short tip reliefs on both gears leave one base pitch of the path without relief, so that an
// unrelieved tooth is always in contact. Each relief covers half of the rest, (ε_α − 1) p_bt/2.
// A long relief covers (ε_α − 1) p_bt, up to the end of the part of the path in which one tooth
// pair carries alone. Root reliefs divide the path in the same way from the other side.
//                                       theory: docs/theory/12-loaded-contact.md
#pragma once

#include <optional>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

enum class ReliefLength { short_relief, long_relief };

/// Start diameters of the tip reliefs and of the root reliefs of gear `which`, mm; none if the
/// flanks touch over at most one base pitch or the axes cross, and of long reliefs if they touch
/// over two base pitches or more, so that no pair carries alone.
///
/// Formula   [T12.29]
struct ReliefStarts {
  double tip, root;
};
std::optional<ReliefStarts> relief_starts(const InvolutePair& pair, int which,
                                          ReliefLength length = ReliefLength::short_relief);

/// True if a tip or root relief has no start.
bool lacks_relief_start(const GivenPair& given);
/// The error for the first relief without a start, if there is no mating gear.
Error missing_relief_start(const GivenPair& given);

/// Sets the start of each tip or root relief without one, on both gears of a pair.
///
/// Errors    `gearN.modifications.tip_relief.reach` if the pair has no such start
std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair);

}  // namespace gearwright
