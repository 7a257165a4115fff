// The gear of a spec: the test fails with the reason where there is none.
#pragma once

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright::testing {

inline Gear made(const CylindricalSpec& spec) { return taken(make_gear(spec)); }

}  // namespace gearwright::testing
