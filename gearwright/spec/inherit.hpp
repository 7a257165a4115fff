// What gear 2 has from gear 1 when its table leaves it out: module, pressure angle, rack, material,
// quality and the angle of the helix, of the opposite hand; an internal gear has the same hand.
//
// Internal to spec/ and the programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gearwright/spec/json.hpp"

namespace gearwright {

struct Inherited {
  Json tree;                         ///< the spec with the keys of gear 2 written out
  bool helix_angle = false;          ///< gear 2's is gear 1's: to the verb `fit` it is not given
  std::vector<std::string> noted{};  ///< keys that no number of gear 2 shows: material, quality
};

/// The table is that of a rack, form = "rack".
bool is_rack(const Json& gear);

/// The gears are those of a mounted pair: both have teeth. Of its shape nothing is handed on to a
/// gear that is cut by a gear or given by its base cylinder; no helix where the axes cross by a given angle; no
/// rack of arcs that cuts one gear of a pair alone.
Inherited inherit(const Json& tree);

}  // namespace gearwright
