// The table of the seven flank modifications with names, words, symbols and members. The keys of
// [gearN.modifications] are made from this table.
//
// A key applies to both flanks. With the prefix right_ or left_ it applies to one flank and takes
// precedence.
#pragma once

#include <array>
#include <string_view>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/gear/modifications.hpp"

namespace gearwright {

/// A modification. It is either a relief with amount, reach and shape, or an amount alone.
struct ModificationEntry {
  std::string_view name;    ///< "tip_relief"; the key is tip_relief_um
  std::string_view symbol;  ///< C_αa
  std::string_view words;   ///< "tip relief"
  RemovalField::Parameter parameter;
  Relief FlankModifications::*relief;  ///< `relief` or `amount` is set, and the other is null
  double FlankModifications::*amount;
  std::string_view reach;        ///< ending of the key for the reach of a relief, "_start_mm"
  std::string_view reach_words;  ///< "from diameter"
  std::string_view meaning;      ///< the material removed

  double amount_of(const FlankModifications& m) const {
    return relief ? (m.*relief).amount : m.*amount;
  }
  /// True if the reach of a relief is given. An amount alone needs no reach, because it applies to
  /// the whole flank, and the result is also true.
  bool placed(const FlankModifications& m) const { return !relief || (m.*relief).reach; }
};

/// The entries of all modifications, in the order of RemovalField::kParameters.
const std::array<ModificationEntry, 7>& modification_entries();

constexpr std::array<std::string_view, 2> kFlankSides{"right_", "left_"};
/// Prefixes of the members of one flank: "modifications.right.tip_relief.amount".
constexpr std::array<std::string_view, 2> kFlankMembers{"right.", "left."};

const KeyTable& modification_keys();

}  // namespace gearwright
