// The seven flank modifications, said once: names, words, symbols, members; and from them the keys
// of [gearN.modifications].
//
// A key holds for both flanks; with right_ or left_ before it for one, where it counts more.
#pragma once

#include <array>
#include <string_view>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/gear/modifications.hpp"

namespace gearwright {

/// A modification: a relief with amount, reach and shape, or an amount alone.
struct ModificationEntry {
  std::string_view name;    ///< "tip_relief": its key is tip_relief_um
  std::string_view symbol;  ///< C_αa
  std::string_view words;   ///< "tip relief"
  RemovalField::Parameter parameter;
  Relief FlankModifications::*relief;  ///< one of these two, the other is null
  double FlankModifications::*amount;
  std::string_view reach;        ///< end of the key of a relief's reach, "_start_mm"
  std::string_view reach_words;  ///< "from diameter"
  std::string_view meaning;      ///< what is removed

  double amount_of(const FlankModifications& m) const {
    return relief ? (m.*relief).amount : m.*amount;
  }
  /// Whether the drawing says where it lies; an amount alone lies on the whole flank.
  bool placed(const FlankModifications& m) const { return !relief || (m.*relief).reach; }
};

/// In the order of RemovalField::kParameters.
const std::array<ModificationEntry, 7>& modification_entries();

constexpr std::array<std::string_view, 2> kFlankSides{"right_", "left_"};
/// How members of one flank are named: "modifications.right.tip_relief.amount".
constexpr std::array<std::string_view, 2> kFlankMembers{"right.", "left."};

const KeyTable& modification_keys();

}  // namespace gearwright
