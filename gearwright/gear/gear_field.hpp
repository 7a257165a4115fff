// Names of the members of gear 1 and gear 2 in errors, such as "gear1.teeth".
#pragma once

#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"

namespace gearwright {

/// "gear1" or "gear2"
inline std::string gear_field(int which) { return "gear" + std::to_string(which); }

/// "gear1.teeth"
inline std::string gear_field(int which, std::string_view member) {
  return gear_field(which) + "." + std::string(member);
}

/// Adds the prefix "gear1" or "gear2" to the field of an error.
inline Error of_gear(int which, Error error) { return within(gear_field(which), std::move(error)); }

}  // namespace gearwright
