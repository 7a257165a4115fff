// From one gear or two as a drawing gives them to gears and a pair: what is absent follows, and what
// contradicts itself is an error.
//
// Shifts and centre distance complete each other, a cutter's numbers become those of the gear that it
// cuts, a backlash sets the thickness of the teeth, absent face widths are 10 m_n with a warning.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

struct ArrangedEnds;

/// With a pair its gears are the pair's.
struct Arranged {
  GivenPair completed;              ///< the input with what follows: shifts, thickness, tips
  std::vector<Gear> gears{};        ///< one or two
  std::optional<Pair> pair{};       ///< of two gears, where the pair was wanted
  std::vector<Warning> warnings{};  ///< of gears and pair, with the gear's number
  std::shared_ptr<const ArrangedEnds> ends{};  ///< of its tolerances; none: it has none
  std::shared_ptr<const GivenPair> given{};    ///< the input as it was

  /// Gear 1 or 2.   Domain  there is such a gear (contract)
  const Gear& gear(int which) const {
    GW_EXPECTS(which >= 1 && which <= static_cast<int>(gears.size()));
    return gears[static_cast<std::size_t>(which - 1)];
  }
};

/// The same at both ends of its tolerances. `lower`: the thinnest teeth, and with them the centre
/// distance with the most backlash; `upper`: the thickest, and the least. What is made, and contact,
/// is that of the mean of the allowances.
struct ArrangedEnds {
  Arranged lower, upper;
};

enum class Scope {
  gears,       ///< each gear by itself; the pair is used only to find an absent profile shift
  pair,        ///< the mounted pair is wanted: gear 2 must be there
  everything,  ///< the pair if there are two gears
};

/// Domain    a first gear (contract)
/// Errors    the input's member at fault, "gear2.profile_shift", "pair.center_distance"
Result<Arranged> arrange(const GivenPair& given, Scope scope = Scope::everything);

}  // namespace gearwright
