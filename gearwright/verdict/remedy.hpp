// What would help against one finding, with the numbers of this very pair where it has them: how
// far a tip may reach, which gear wants more shift, that a given centre distance asked for the
// shifts. Without a pair, or where nothing more is known, what meaning_of says.
#pragma once

#include <optional>
#include <string>

#include "gearwright/pair/pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright::detail {

/// The tip diameter of gear `tip` (1 or 2) at which its contact ends just where the mating gear's
/// usable flank begins (on its base circle where no flank is known), mm; none where the tip need
/// not be turned down or the mating flank has no such end. A greatest one; of an internal gear the
/// least.
std::optional<double> tip_that_clears(const InvolutePair& pair, int tip);

/// One sentence or two, plain words; empty: nothing to do.
std::string remedy_for(const Warning& warning, const Judged& judged);

}  // namespace gearwright::detail
