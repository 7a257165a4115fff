// The keys of [gearN.rack]: the straight rack, the racks F and P, double circular arcs, and any
// chain of arcs. Lengths are in normal modules.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& straight_rack_keys();
const KeyTable& arc_rack_keys();         ///< kind = "circular_arc"
const KeyTable& double_arc_rack_keys();  ///< kind = "double_circular_arc"
const KeyTable& rack_of_arcs_keys();     ///< kind = "arcs"
const KeyTable& rack_arc_keys();         ///< the keys of each table in `arcs`

}  // namespace gearwright
