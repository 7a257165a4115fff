// Reads what replaces the rack's work on a gear: circular fillets, and a pinion cutter.
//
// Internal to spec/: parts of read_gear.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// [gearN.root_fillet] and [gearN.tip_fillet].
void read_fillets(TableReader& gear, GearInput& g);

/// `cut_by` and `profile_shift_pair`; `node` is the gear's table, `mate` the other's or null.
void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g);

}  // namespace gearwright
