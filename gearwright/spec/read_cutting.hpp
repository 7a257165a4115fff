// Reads the pinion cutter of a gear, which replaces its rack.
//
// Internal to spec/: a part of read_gear.
#pragma once

#include "gearwright/spec/spec.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

/// `cut_by` and `profile_shift_pair`; `node` is the gear's table, `mate` the other's or null.
void read_cut_by(TableReader& gear, const Json& node, const Json* mate, GearInput& g);

}  // namespace gearwright
