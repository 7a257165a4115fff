// Numbers as text for people and files, each function one rule. Numbers of sentences about an input are
// format_number's (base/error.hpp).
#pragma once

#include <string>

namespace gearwright {

/// So many decimals, never "-0.00".
///
/// Domain    finite, decimals ≥ 0
std::string fixed_decimals(double x, int decimals);

/// The same without the zeros at its end: "1.5", "2".
std::string short_decimals(double x, int most);

}  // namespace gearwright
