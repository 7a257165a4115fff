// Formulas of one gear for any scalar type. The formulas are in gear/leaf_formulas.inc. This file
// adds the selection functions that replace branches in the formulas.
#pragma once

#include <cmath>

#include "gearwright/math/involute.hpp"

namespace gearwright::leaf {

/// min_of() returns the lesser value and max_of() the greater value. If either value is NaN, both
/// functions return the second argument, as vector instructions do.
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
