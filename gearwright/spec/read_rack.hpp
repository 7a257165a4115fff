// Reads the rack of a gear: a name of a standard, straight flanks, or arcs.
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <optional>

#include "gearwright/spec/table_reader.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

/// [gearN] rack; by default ISO53-A. `module`, mm, chooses among the racks of GB/T 12759.
Rack read_rack(TableReader& gear, std::optional<double> module);

/// The same if only straight flanks are allowed.
StraightRack read_straight_rack(TableReader& gear);

}  // namespace gearwright
