// Describes the member of an input struct in which the value of a key is stored. The type KeyPlace
// does not depend on the type of the struct.
//
//   KeyTarget   an input struct, whose type is checked at every use
//   KeyPlace    the way in which a value is stored in the struct
//   KeyRule     relations between the members of the struct
//
// The type of a member determines the kind of its key:
//
//   an Angle                                degrees
//   an enumerator                           a word, by its index in the list of words
//   a vector, or an array of two            a list
//   the numbers of the members of a set     numbers by name
//   a struct                                a sub-table
#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"

namespace gearwright {

/// Numbers by name, for example { sun = 10, planet = -10 }.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// A value as a file gives it. The types have this order: a number; a whole number, or the index of
/// a word in its list; a flag; a text; a list of numbers; a list of words; a list of texts; numbers
/// by name.
using KeyValue = std::variant<double, int, bool, std::string, std::vector<double>, std::vector<int>,
                              std::vector<std::string>, NamedNumbers>;

/// A type that stores one number for all names and separate numbers for single names. The names
/// are, for example, those of the gears of a set.
template <class V>
concept ByName = requires(V value, const std::string& name) {
  value.all;
  value.set(name, 0.0);
  { V::names() } -> std::convertible_to<std::vector<std::string>>;
};

enum class KeyKind {
  number,
  whole,
  boolean,
  text,
  word,     ///< one of `words`
  by_name,  ///< a number, or a table of numbers by name
  table,    ///< one of `tables`
  any       ///< any value
};

class KeyTarget {
 public:
  /// This constructor is implicit, so that a reference to any input struct can be passed.
  template <class T>
  requires(!std::is_same_v<T, KeyTarget>)
      KeyTarget(T& input)  // NOLINT(google-explicit-constructor)
      : input_(&input), type_(&kType<T>) {}

  /// Domain  an input of this type (contract)
  template <class T>
  T& as() const {
    GW_EXPECTS(type_ == &kType<T>);
    return *static_cast<T*>(input_);
  }

 private:
  template <class T>
  static constexpr char kType = 0;  // the address of this member identifies the type

  void* input_;
  const char* type_;
};

class KeyPlace {
 public:
  KeyPlace() = default;  ///< for a key that the reader handles
  /// This constructor is implicit, so that an entry of a table can be the member pointer itself.
  template <class T, class V>
  KeyPlace(V T::*member)  // NOLINT(google-explicit-constructor)
      : KeyPlace(within<T>([member](T& t) -> V& { return t.*member; })) {}
  template <class T, class M, class V>
  KeyPlace(M T::*outer, V M::*inner)
      : KeyPlace(within<T>([outer, inner](T& t) -> V& { return t.*outer.*inner; })) {}
  /// Makes a place for a member that T inherits.
  template <class T, class Base, class V>
  static KeyPlace inherited(V Base::*member) {
    return static_cast<V T::*>(member);
  }
  /// Makes a place for the member that a function returns: within<T>([](T& t) -> auto& { … })
  template <class T, class F>
  static KeyPlace within(F reach);
  /// Makes a place for a value that the function set(T&, const V&) stores. If the value is
  /// impossible, the function may return a sentence with the reason.
  template <class T, class V, class F>
  static KeyPlace by(F set);
  /// Makes a place for one number or two limits. mean(T&) returns a reference to the member for the
  /// number or for the mean of the limits. ends(T&) returns a reference to the optional array in
  /// which two limits are also stored.
  template <class T, class M, class E>
  static KeyPlace mean_and_ends(M mean, E ends);
  /// Makes a place for a table or, as a short form, for two numbers. reach(T&) returns a reference
  /// to the optional struct of the table, and `ends` is its member for the two numbers.
  template <class T, class S, class F>
  static KeyPlace ends_or_table(std::array<double, 2> S::*ends, F reach);
  /// Makes a place for a value that is checked but not stored.
  static KeyPlace unused();
  /// Returns the same place for a struct that is itself the member `outer` of another struct.
  template <class T, class M>
  KeyPlace inside(M T::*outer) const;

  /// Returns a copy of this place that also accepts a list of two limits and stores it in the
  /// member `ends`. All other values are stored as in this place.
  template <class T>
  KeyPlace or_ends(std::optional<std::array<double, 2>> T::*ends) const;

  /// Returns a copy of this place that also accepts a word in place of the number. If the word is
  /// given, set(T&) is called.
  template <class T, class F>
  KeyPlace or_word(F set) const;

  explicit operator bool() const { return put_ || part_; }
  KeyKind kind() const { return kind_; }
  bool is_angle() const { return angle_; }
  bool is_member() const { return same_ != nullptr; }
  /// The permitted names, if the value is a table of named numbers.
  const std::vector<std::string>& names() const { return names_; }
  /// Stores the value. If the value is impossible, returns a sentence with the reason.
  std::string put(KeyTarget input, const KeyValue& value) const { return put_(input, value); }
  /// Returns the struct in which a sub-table is stored: a new element at the end of a list, a new
  /// struct in an optional member, or the member itself. If the struct has a member `given`, this
  /// member is set to true.
  KeyTarget part(KeyTarget input) const { return part_(input); }
  /// True if the member has the same value in both structs.
  ///
  /// Domain  is_member() (contract)
  template <class T>
  bool same(T a, T b) const {
    GW_EXPECTS(is_member());
    return same_(a, b);
  }

 private:
  template <class V>
  struct Bare {
    using type = V;
  };
  template <class V>
  struct Bare<std::optional<V>> : Bare<V> {};
  template <class V>
  struct Bare<std::vector<V>> : Bare<V> {};
  template <class V>
  struct Bare<std::array<V, 2>> : Bare<V> {};

  template <class V>
  static constexpr KeyKind kind_of() {
    using B = typename Bare<V>::type;
    if (ByName<V>) return KeyKind::by_name;
    if (std::is_enum_v<B> || std::is_same_v<B, std::size_t>) return KeyKind::word;
    if (std::is_same_v<B, bool>) return KeyKind::boolean;
    if (std::is_same_v<B, int>) return KeyKind::whole;
    if (std::is_same_v<B, std::string>) return KeyKind::text;
    if (std::is_same_v<B, double> || std::is_same_v<B, Angle>) return KeyKind::number;
    return KeyKind::table;
  }

  template <class V>
  static V of_number(double x) {
    if constexpr (std::is_same_v<V, Angle>) {
      return Angle::degrees(x);
    } else {
      return static_cast<V>(x);
    }
  }
  static void store(Angle& to, const KeyValue& v) { to = Angle::degrees(std::get<double>(v)); }
  template <class V>
  static void store(V& to, const KeyValue& v) {
    if constexpr (ByName<V>) {
      const auto* named = std::get_if<NamedNumbers>(&v);
      if (!named) store(to.all, v);
      if (named)
        for (const auto& [name, number] : *named) to.set(name, number);
    } else if constexpr (kind_of<V>() == KeyKind::word) {
      to = static_cast<V>(std::get<int>(v));
    } else {
      to = std::get<V>(v);
    }
  }
  template <class V>
  static void store(std::optional<V>& to, const KeyValue& v) {
    store(to.emplace(), v);
  }
  // If a spec gives two limits, a member for one number is set to their mean.
  static void store(std::optional<double>& to, const KeyValue& v) {
    const auto* ends = std::get_if<std::vector<double>>(&v);
    to = ends ? (ends->front() + ends->back()) / 2 : std::get<double>(v);
  }
  template <class V>
  static void store(std::array<V, 2>& to, const KeyValue& v) {
    const auto& list = std::get<std::vector<double>>(v);
    to = {of_number<V>(list.front()), of_number<V>(list.back())};
  }
  static void store(std::array<std::string, 2>& to, const KeyValue& v) {
    const auto& list = std::get<std::vector<std::string>>(v);
    to = {list.front(), list.back()};
  }
  template <class V>
  static void store(std::vector<V>& to, const KeyValue& v) {
    to.clear();
    if constexpr (std::is_same_v<V, std::string>) {
      to = std::get<std::vector<std::string>>(v);
    } else if constexpr (kind_of<V>() == KeyKind::word) {
      for (const int word : std::get<std::vector<int>>(v)) to.push_back(static_cast<V>(word));
    } else {
      for (const double x : std::get<std::vector<double>>(v)) to.push_back(of_number<V>(x));
    }
  }

  template <class V>
  static KeyTarget open(V& table) {
    if constexpr (requires { table.given = true; }) table.given = true;
    return table;
  }
  template <class V>
  static KeyTarget open(std::optional<V>& table) {
    return open(table.emplace());
  }
  template <class V>
  static KeyTarget open(std::vector<V>& list) {
    return open(list.emplace_back());
  }

  KeyKind kind_ = KeyKind::any;
  bool angle_ = false;
  std::function<std::string(KeyTarget, const KeyValue&)> put_;
  std::function<KeyTarget(KeyTarget)> part_;
  std::function<bool(KeyTarget, KeyTarget)> same_;
  std::vector<std::string> names_;
};

/// A fault of a key: its value is impossible, or the key is missing. `why` is the reason.
struct KeyFault {
  std::string key;
  std::string why;
  bool missing = false;  ///< true if the key is missing; the message is then "is missing" followed
                         ///< by `why`
};

/// A function that returns true if the table that was read contains this key.
using KeyGiven = std::function<bool(std::string_view)>;

/// Checks relations between the keys of a table, and computes members from several keys. A rule is
/// a function of the input struct that is called after all keys have been read.
class KeyRule {
 public:
  KeyRule() = default;
  /// This constructor is implicit, so that an entry of a table can be the function itself.
  template <class T>
  KeyRule(std::optional<KeyFault> (*rule)(T&, const KeyGiven&))  // NOLINT
      : rule_([rule](KeyTarget input, const KeyGiven& given) {
          return rule(input.as<T>(), given);
        }) {}
  std::optional<KeyFault> fault(KeyTarget input, const KeyGiven& given) const {
    return rule_ ? rule_(input, given) : std::nullopt;
  }

 private:
  std::function<std::optional<KeyFault>(KeyTarget, const KeyGiven&)> rule_;
};

template <class T, class F>
KeyPlace KeyPlace::within(F reach) {
  using V = std::remove_reference_t<decltype(reach(std::declval<T&>()))>;
  KeyPlace place;
  place.kind_ = kind_of<V>();
  place.angle_ = std::is_same_v<typename Bare<V>::type, Angle>;
  if constexpr (ByName<V>) place.names_ = V::names();
  if constexpr (kind_of<V>() == KeyKind::table) {
    place.part_ = [reach](KeyTarget input) { return open(reach(input.as<T>())); };
  } else {
    place.put_ = [reach](KeyTarget input, const KeyValue& v) {
      store(reach(input.as<T>()), v);
      return std::string();
    };
    if constexpr (!ByName<V>)
      place.same_ = [reach](KeyTarget a, KeyTarget b) {
        return reach(a.as<T>()) == reach(b.as<T>());
      };
  }
  return place;
}

template <class T, class V, class F>
KeyPlace KeyPlace::by(F set) {
  KeyPlace place;
  place.kind_ = kind_of<V>();
  place.angle_ = std::is_same_v<typename Bare<V>::type, Angle>;
  place.put_ = [set](KeyTarget input, const KeyValue& given) -> std::string {
    V value{};
    store(value, given);
    if constexpr (std::is_void_v<std::invoke_result_t<F, T&, const V&>>) {
      set(input.as<T>(), value);
      return {};
    } else {
      return set(input.as<T>(), value);
    }
  };
  return place;
}

template <class T, class M, class E>
KeyPlace KeyPlace::mean_and_ends(M mean, E ends) {
  using Numbers = std::vector<double>;
  return by<T, Numbers>([mean, ends](T& input, const Numbers& given) {
    mean(input) = (given.front() + given.back()) / 2;
    if (given.size() == 2) ends(input) = {given[0], given[1]};
  });
}

template <class T, class S, class F>
KeyPlace KeyPlace::ends_or_table(std::array<double, 2> S::*ends, F reach) {
  KeyPlace place = within<T>(reach);
  place.put_ = [ends, reach](KeyTarget input, const KeyValue& given) {
    store(reach(input.as<T>()).emplace().*ends, given);
    return std::string();
  };
  return place;
}

template <class T, class M>
KeyPlace KeyPlace::inside(M T::*outer) const {
  KeyPlace place = *this;
  place.same_ = nullptr;
  if (put_)
    place.put_ = [outer, put = put_](KeyTarget input, const KeyValue& given) {
      return put(input.as<T>().*outer, given);
    };
  if (part_)
    place.part_ = [outer, part = part_](KeyTarget input) { return part(input.as<T>().*outer); };
  return place;
}

template <class T>
KeyPlace KeyPlace::or_ends(std::optional<std::array<double, 2>> T::*ends) const {
  KeyPlace place = *this;
  place.put_ = [ends, put = put_](KeyTarget input, const KeyValue& given) {
    if (!std::holds_alternative<std::vector<double>>(given)) return put(input, given);
    store(input.as<T>().*ends, given);
    return std::string();
  };
  return place;
}

template <class T, class F>
KeyPlace KeyPlace::or_word(F set) const {
  KeyPlace place = *this;
  place.put_ = [set, put = put_](KeyTarget input, const KeyValue& given) {
    if (!std::holds_alternative<int>(given)) return put(input, given);
    set(input.as<T>());
    return std::string();
  };
  return place;
}

inline KeyPlace KeyPlace::unused() {
  KeyPlace place;
  place.put_ = [](KeyTarget, const KeyValue&) { return std::string(); };
  return place;
}

}  // namespace gearwright
