// Returns whether a gear, or a pair, has a warning with this code.
#pragma once

#include <algorithm>

#include "gearwright/gear/gear.hpp"

namespace gearwright::testing {

template <class Warned>
bool warns(const Warned& of, WarningCode code) {
  return std::any_of(of.warnings.begin(), of.warnings.end(),
                     [&](const Warning& w) { return w.code == code; });
}

}  // namespace gearwright::testing
