// The shape of a value of a result: the lengths of its lists, and whether the value can be null.
// The shape follows from the type of the getter. Entries of the catalogue therefore state only the
// facts that do not follow from this type.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/value.hpp"

namespace gearwright {

/// The shape of the values of a getter that returns R. It consists of the lengths of nested lists,
/// and a flag that is true if no value is null. A list whose values are all null counts as null. A
/// Value may have any shape.
template <class R>
struct Shape;
template <bool always>
struct OneShape {
  static constexpr bool kAlways = always;
  static std::vector<int> list() { return {}; }
};
template <class T, int length, bool always>
struct ListShape {
  static constexpr bool kAlways = always;
  static std::vector<int> list() {
    std::vector<int> lengths = Shape<T>::list();
    lengths.insert(lengths.begin(), length);
    return lengths;
  }
};
template <class R>
struct Shape : OneShape<std::is_arithmetic_v<R> || std::is_same_v<R, Angle> ||
                        std::is_convertible_v<const R&, std::string_view>> {};
template <>
struct Shape<ValueRecord> : OneShape<true> {};
template <>
struct Shape<ValueMap> : OneShape<true> {};
template <>
struct Shape<Vec2> : ListShape<double, 2, true> {};
template <>
struct Shape<Vec3> : ListShape<double, 3, true> {};
template <class T>
struct Shape<std::vector<T>> : ListShape<T, 0, true> {};
template <class T, std::size_t n>
struct Shape<std::array<T, n>> : ListShape<T, int{n}, Shape<T>::kAlways> {};
template <class T>
struct Shape<std::optional<T>> {
  static constexpr bool kAlways = false;
  static std::vector<int> list() { return Shape<T>::list(); }
};

}  // namespace gearwright
