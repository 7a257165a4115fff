// The basic racks of North American practice, whose names include the pressure angle.
//
//   AGMA-20, AGMA-25   full depth      ANSI B6.1-1968 (AGMA 201.02)
//   AGMA-14.5          full depth      ASA B6.1-1932, for gears in service
//   AGMA-stub          stub, 20°       ASA B6.1-1932
//
// Lengths are in 1/P, which is a module. The tip rounding is 0.3 for AGMA-20 and AGMA-25, 4/3 of the clearance for
// AGMA-14.5 and 3/2 of the clearance for AGMA-stub.
#pragma once

#include <string_view>

#include "gearwright/base/angle.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

struct AgmaRack {
  std::string_view name;
  StraightRack rack;
  Angle normal_pressure_angle;  ///< α_n
};

/// The rack with this name, or null if there is none.
const AgmaRack* agma_rack(std::string_view name);

}  // namespace gearwright
