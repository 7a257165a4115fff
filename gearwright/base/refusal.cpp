#include "gearwright/base/refusal.hpp"

#include <fmt/format.h>

#include <utility>

namespace gearwright {

Error refused(std::string key, double value, const std::string& why) {
  std::string message = fmt::format("{} = {}: {}", key, value, why);
  return {std::move(key), fmt::format("{}", value), std::move(message)};
}

}  // namespace gearwright
