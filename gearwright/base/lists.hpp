// Short lists whose order matters.
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace gearwright {

/// True if the list contains the value.
template <class T, class List>
bool is_in(const T& value, const List& list) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

/// Appends the value if the list does not contain it. Returns true if it is appended.
template <class List, class T>
bool add_once(List& list, T&& value) {
  if (is_in(value, list)) return false;
  list.emplace_back(std::forward<T>(value));
  return true;
}

/// Returns n numbers with equal steps, from `lo` to `hi`.   Domain  n ≥ 2
inline std::vector<double> evenly_spaced(double lo, double hi, int n) {
  std::vector<double> list;
  for (int i = 0; i < n; ++i) list.push_back(lo + (hi - lo) * (static_cast<double>(i) / (n - 1)));
  return list;
}

}  // namespace gearwright
