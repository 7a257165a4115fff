// Computes one gear, or two gears and their pair, from the data of a drawing. Absent values are
// computed from the given values. Contradictory values cause an error.
//
// Profile shifts and centre distance determine each other. A cutter determines the module and the
// angles of the gear that it cuts. A required backlash determines the tooth thickness. If no face
// width is given, it is 10 m_n, and there is a warning. Gear 2 may be a rack.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

struct ArrangedEnds;

/// The completed input, and the gears and the pair made from it. If there is a pair, `gears` are
/// the gears of this pair.
struct Arranged {
  GivenPair completed;              ///< the input with computed shifts, thickness and tips
  std::vector<Gear> gears{};        ///< one or two; only the pinion if gear 2 is a rack
  std::optional<Pair> pair{};       ///< none for a single gear, or if no pair was requested
  std::optional<RackPair> rack{};   ///< the pinion with its rack, if gear 2 is a rack
  std::vector<Warning> warnings{};  ///< warnings about the gears and the pair
  std::shared_ptr<const ArrangedEnds> ends{};  ///< results at the ends of the tolerances
  std::shared_ptr<const GivenPair> given{};    ///< the unchanged input

  /// Returns gear 1 or 2.   Domain  this gear exists (contract)
  const Gear& gear(int which) const {
    GW_EXPECTS(which >= 1 && which <= static_cast<int>(gears.size()));
    return gears[which - 1];
  }
  /// True if gear 1 is mounted with another gear or with a rack.
  bool mounted() const { return pair || rack; }
  int parts() const { return static_cast<int>(gears.size()) + (rack ? 1 : 0); }
};

/// Gears and pair at both ends of their tolerances, that is, with every toleranced number at a
/// limit of its tolerance. `lower` has the thinnest teeth and the centre distance with the most
/// backlash. `upper` has the thickest teeth and the centre distance with the least backlash.
/// The nominal result and the contact analysis use the mean of each allowance.
struct ArrangedEnds {
  Arranged lower, upper;
};

enum class Scope {
  gears,       ///< each gear separately; the pair is used only to compute absent values, such as a
               ///< profile shift
  pair,        ///< the pair; gear 2 or a rack must exist
  everything,  ///< all gears, and the pair if there are two gears or a rack
};

/// Computes the absent data, then makes the gears and, if `scope` includes the pair, mounts them.
///
/// Domain    gear 1 is given (contract)
/// Errors    the field of the error is the invalid member of the input: "gear2.profile_shift",
///           "pair.center_distance"; for a rack the errors of mount_rack(), and the member of
///           `pair` with the backlash if the pinion or the rack cannot have it
Result<Arranged> arrange(const GivenPair& given, Scope scope = Scope::everything);

/// Returns the error of modifications that do not fit the flanks of a gear, and none if they fit or
/// if the gear has no usable flank.
///
/// Errors    `modifications.…` as make_removal_field
std::optional<Error> flank_error(const Gear& gear, const std::array<FlankModifications, 2>& flanks);

/// Checks that the modifications of every gear fit its flanks, so that all verbs and all remedies
/// reject the same modifications. A gear without a usable flank has a warning instead.
///
/// Errors    `gearN.modifications.…` as make_removal_field
std::optional<Error> check_flanks(const Arranged& arranged);

}  // namespace gearwright
