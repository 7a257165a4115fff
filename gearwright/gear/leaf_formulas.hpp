// Formulas of one gear for any number type: the text of gear/leaf_formulas.inc, and the selection
// functions that it uses instead of branches.
#pragma once

#include <cmath>

#include "gearwright/math/involute.hpp"

namespace gearwright::leaf {

/// The second if either is NaN, as in vector instructions.
template <class T>
T min_of(const T& a, const T& b) {
  return a < b ? a : b;
}
template <class T>
T max_of(const T& a, const T& b) {
  return a > b ? a : b;
}
template <class T>
bool is_less(const T& a, const T& b) {
  return a < b;
}
template <class T>
T pick(bool condition, const T& a, const T& b) {
  return condition ? a : b;
}

#define GW_LEAF_INLINE inline
#include "gearwright/gear/leaf_formulas.inc"
#undef GW_LEAF_INLINE

}  // namespace gearwright::leaf
