#include "gearwright/base/number_text.hpp"

#include <fmt/format.h>

namespace gearwright {

std::string fixed_decimals(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::string short_decimals(double x, int most) {
  std::string text = fixed_decimals(x, most);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace gearwright
