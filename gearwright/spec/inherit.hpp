// Values that gear 2 takes from gear 1 if its table omits them: module, pressure angle, rack, face
// width, gap and stagger of a double-helical gear, material, quality and the angle of the helix, of
// the opposite hand; an internal gear has the same hand. A material that is only a name becomes a table.
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
  bool helix_angle = false;          ///< gear 2 takes the helix of gear 1; not given for `fit`
  std::vector<std::string> noted{};  ///< keys that no number of gear 2 shows: material, quality
};

/// The table is that of a rack, form = "rack".
bool is_rack(const Json& gear);

/// The spec with every material that is given by its name alone, material = "16MnCr5", as a table
/// [material] with this name.
Json with_named_materials(const Json& tree);

/// Copies values for the gears of a mounted pair, which both have teeth. A gear that is cut by a
/// gear or given by its base cylinder takes no shape. No helix is taken if the axes cross at a
/// given angle, no rack of arcs that cuts only one gear of a pair, and nothing by an unknown gear
/// whose mating gear has no module.
Inherited inherit(const Json& tree);

}  // namespace gearwright
