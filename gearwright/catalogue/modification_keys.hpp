// The table of the flank modifications with their words, symbols and keys. The keys of
// [gearN.modifications] are made from it.
//
// A key without a prefix applies to both flanks. A key with the prefix right_ or left_ applies to
// one flank and takes precedence.
#pragma once

#include <array>
#include <string_view>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/gear/modifications.hpp"

namespace gearwright {

/// A modification. The key of "tip_relief" is tip_relief_um.
struct ModificationEntry : ModificationMember {
  std::string_view symbol;       ///< C_αa
  std::string_view words;        ///< "tip relief"
  std::string_view reach;        ///< ending of the key for the reach of a relief, "_start_mm"
  std::string_view reach_words;  ///< "from diameter"
  std::string_view meaning;      ///< the material removed
};

/// The entries in the order of kModifications.
const std::array<ModificationEntry, kModifications.size()>& modification_entries();

constexpr std::array<std::string_view, 2> kFlankSides{"right_", "left_"};
/// Prefixes of the members of one flank: "modifications.right.tip_relief.amount".
constexpr std::array<std::string_view, 2> kFlankMembers{"right.", "left."};

const KeyTable& modification_keys();

}  // namespace gearwright
