// How an error about two gears names a member of one of them: "gear1.teeth".
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

/// The error of a gear as one of gear 1 or 2.
inline Error of_gear(int which, Error error) { return within(gear_field(which), std::move(error)); }

}  // namespace gearwright
