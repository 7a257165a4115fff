// Computes the start of a relief that is given by its amount alone, which is then a short relief.
//
//   ε_α   transverse contact ratio over the usable flanks       p_bt   transverse base pitch
//   ρ     radius of curvature of a flank, which gives the position on the path of contact
//
// Short tip reliefs on both gears leave one base pitch of the path without relief, so that an
// unrelieved tooth is always in contact. Each relief covers half of the rest, (ε_α − 1) p_bt/2.
// Root reliefs divide the path in the same way from the other side.
// Internal to arrange/.
#pragma once

#include <optional>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// Start diameters of the tip reliefs and of the root reliefs of gear `which` that leave one base
/// pitch of the path, mm; none if the flanks touch over at most one base pitch or the axes cross.
struct ReliefStarts {
  double tip, root;
};
std::optional<ReliefStarts> short_relief(const InvolutePair& pair, int which);

/// True if a tip or root relief has no start.
bool lacks_relief_start(const GivenPair& given);
/// The error for the first relief without a start, if there is no mating gear.
Error missing_relief_start(const GivenPair& given);

/// Sets the start of each tip or root relief without one, on both gears of a pair.
///
/// Errors    `gearN.modifications.tip_relief.reach` if the pair has no such start
std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair);

}  // namespace gearwright
