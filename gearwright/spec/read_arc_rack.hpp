// Reads a rack of arcs: [gearN.rack] with kind "circular_arc", "double_circular_arc" or "arcs", and
// rack = "GBT12759".
//
// Internal to spec/: throws SpecError, as the readers of single values do.
#pragma once

#include <optional>

#include "gearwright/spec/once.hpp"
#include "gearwright/spec/table_reader.hpp"
#include "gearwright/tool/rack.hpp"

namespace gearwright {

/// The rack of arcs of a gear's table; nothing when its rack is another one, or absent. `module`
/// chooses among the standard's racks.
std::optional<Rack> read_arc_rack(TableReader& gear, const Once& module);

}  // namespace gearwright
