// The keys of [gearN.rack]: the straight rack, racks F and P, double circular arcs, any chain of
// arcs. Lengths are in normal modules.
#pragma once

#include "gearwright/catalogue/key.hpp"

namespace gearwright {

const KeyTable& straight_rack_keys();
const KeyTable& arc_rack_keys();         ///< kind = "circular_arc"
const KeyTable& double_arc_rack_keys();  ///< kind = "double_circular_arc"
const KeyTable& rack_of_arcs_keys();     ///< kind = "arcs"
const KeyTable& rack_arc_keys();         ///< of each table in `arcs`

/// What a table `arcs` calls a part: its place in rack_arc_keys' words.
enum class ArcPart { root_fillet, flank, joint, tip_fillet };

/// One table of `arcs`.
struct RackArcInput {
  ArcPart part = ArcPart::flank;
  double center_height = 0.0, center_offset = 0.0, radius = 0.0;
  Angle begin, end;
};

}  // namespace gearwright
