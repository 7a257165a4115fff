// One shape of complaint for every number that cannot be: the key, its value, what is allowed.
#pragma once

#include <string>

#include "gearwright/base/result.hpp"

namespace gearwright {

/// {key, value, "key = value: why"}; `why` says what is allowed and what would help.
Error refused(std::string key, double value, const std::string& why);

}  // namespace gearwright
