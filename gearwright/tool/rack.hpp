// The rack that cuts a gear, with straight sides (involute teeth) or with circular arcs.
#pragma once

#include <variant>

#include "gearwright/tool/arc_rack.hpp"
#include "gearwright/tool/double_arc_rack.hpp"
#include "gearwright/tool/rack_of_arcs.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

/// A StraightRack cuts involute teeth. The other racks cut circular-arc teeth, and `arcs_of`
/// returns their arcs.
using Rack = std::variant<StraightRack, ArcRack, DoubleArcRack, RackOfArcs>;

inline bool is_straight(const Rack& rack) { return std::holds_alternative<StraightRack>(rack); }

inline Result<RackOfArcs> arcs_of(const RackOfArcs& rack) { return rack; }

/// Returns the addendum of the gear tooth above the datum line, in normal modules.
inline double addendum_of(const Rack& rack) {
  return std::visit([](const auto& r) { return r.addendum; }, rack);
}

/// Returns the depth of the cutter below the datum line, in normal modules.
inline double dedendum_of(const Rack& rack) {
  return std::visit([](const auto& r) { return r.dedendum; }, rack);
}

}  // namespace gearwright
