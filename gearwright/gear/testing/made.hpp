// Makes the gear of a spec. If the gear cannot be made, the test fails with the reason.
#pragma once

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright::testing {

inline Gear made(const CylindricalSpec& spec) { return taken(make_gear(spec)); }

}  // namespace gearwright::testing
