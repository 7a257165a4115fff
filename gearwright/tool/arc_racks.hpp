// Any of the racks of arcs, as a gear's spec holds one.
#pragma once

#include <variant>

#include "gearwright/tool/arc_rack.hpp"
#include "gearwright/tool/double_arc_rack.hpp"
#include "gearwright/tool/rack_of_arcs.hpp"

namespace gearwright {

using AnyArcRack = std::variant<ArcRack, DoubleArcRack, RackOfArcs>;

inline Result<RackOfArcs> arcs_of(const RackOfArcs& rack) { return rack; }

inline Result<RackOfArcs> arcs_of(const AnyArcRack& rack) {
  return std::visit([](const auto& r) { return arcs_of(r); }, rack);
}

inline double addendum_of(const AnyArcRack& rack) {
  return std::visit([](const auto& r) { return r.addendum; }, rack);
}

inline double dedendum_of(const AnyArcRack& rack) {
  return std::visit([](const auto& r) { return r.dedendum; }, rack);
}

}  // namespace gearwright
