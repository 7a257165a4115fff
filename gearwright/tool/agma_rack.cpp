#include "gearwright/tool/agma_rack.hpp"

#include <algorithm>
#include <array>

namespace gearwright {

namespace {

AgmaRack rack_of(std::string_view name, double degrees, double addendum, double dedendum,
                 double radius) {
  StraightRack rack;
  rack.addendum = addendum;
  rack.dedendum = dedendum;
  rack.root_fillet_radius = radius;
  rack.named = true;
  return {name, rack, Angle::degrees(degrees)};
}

}  // namespace

const AgmaRack* agma_rack(std::string_view name) {
  static const std::array racks{
      rack_of("AGMA-14.5", 14.5, 1.0, 1.157, 0.209), rack_of("AGMA-20", 20.0, 1.0, 1.25, 0.3),
      rack_of("AGMA-25", 25.0, 1.0, 1.25, 0.3), rack_of("AGMA-stub", 20.0, 0.8, 1.0, 0.3)};
  const auto it =
      std::find_if(racks.begin(), racks.end(), [&](const AgmaRack& r) { return r.name == name; });
  return it == racks.end() ? nullptr : &*it;
}

}  // namespace gearwright
