// The name of a member of one of two gears in an error: "gear1.teeth".
#pragma once

#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// "gear1", "gear2".
inline std::string gear_field(int which) { return "gear" + std::to_string(which); }

/// "gear1.teeth"
inline std::string gear_field(int which, std::string_view member) {
  return gear_field(which) + "." + std::string(member);
}

/// Prefixes the error of a gear with gear1 or gear2.
inline Error of_gear(int which, Error error) { return within(gear_field(which), std::move(error)); }

}  // namespace gearwright
