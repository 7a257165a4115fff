// The catalogue of inputs: what is said of each key of a spec, once.
//
//   Key        name in the file, symbol, kind, range with its reason, default, what it needs or
//              excludes, one sentence of meaning, and the member of an input struct that it sets
//   KeyTable   the keys of one table of a spec
//
// Reading, the nearest-name hint, the tables of docs/spec.md and the JSON Schema of specs are made
// from it. A new key is one entry of one of the *_keys.cpp files.
#pragma once

#include <functional>
#include <limits>
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

/// A value as it stands in a file: a number, a whole number or the place of a word in its list, a
/// switch, a text.
using KeyValue = std::variant<double, int, bool, std::string>;

enum class KeyKind {
  number,
  whole,
  boolean,
  text,
  word,   ///< one of `words`
  table,  ///< one of `tables`
  any     ///< whatever stands there: not read in this version
};

constexpr double kMaxInput = 1e9;  ///< of any number of a spec, in its unit
constexpr double kMaxWholeInput = 1e6;

/// The numbers that are allowed, and why no others.
struct KeyRange {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool lo_open = false, hi_open = false;  ///< the end itself is not allowed
  bool zero = true;                       ///< false: 0 is not allowed
  std::string reason{};                   ///< goes on after the range: ", usually 14.5 to 30"

  // One end may be infinite.
  static KeyRange between(double lo, double hi, std::string reason = "") {
    return {lo, hi, false, false, true, std::move(reason)};
  }
  static KeyRange inside(double lo, double hi, std::string reason = "") {  ///< without the ends
    return {lo, hi, true, true, true, std::move(reason)};
  }
  static KeyRange above(double lo, double hi, std::string reason = "") {  ///< without the lower end
    return {lo, hi, true, false, true, std::move(reason)};
  }
  static KeyRange positive() { return above(0.0, std::numeric_limits<double>::infinity()); }
  static KeyRange not_negative(std::string reason = "") {
    return between(0.0, std::numeric_limits<double>::infinity(), std::move(reason));
  }

  bool contains(double x) const {
    return (lo_open ? x > lo : x >= lo) && (hi_open ? x < hi : x <= hi) && (zero || x != 0.0);
  }
  bool limited() const;
  /// What is wrong with `value`: "must lie between 1 and 60, usually 14.5 to 30".
  /// Domain  limited() (contract)
  std::string sentence(double value) const;
};

/// A list instead of one value.
struct KeyList {
  std::size_t least = 1, most = 1;
  bool single = false;  ///< one value without a list will do, too
};

/// Where the value of a plain key goes: a member, or a member's member, of the input struct.
/// Degrees become an Angle; the place of a word in its list becomes the enumerator.
class KeyPlace {
 public:
  KeyPlace() = default;  ///< the reader has code for this key
  template <class T, class V>
  KeyPlace(V T::*member)  // NOLINT(google-explicit-constructor): an entry names the member
      : KeyPlace(within<T>([member](T& t) -> V& { return t.*member; })) {}
  /// within<T>([](T& t) -> auto& { return t.limits.contact_ratio; })
  template <class T, class F>
  static KeyPlace within(F reach);

  explicit operator bool() const { return put_ != nullptr; }
  KeyKind kind() const { return kind_; }
  bool is_angle() const { return angle_; }
  /// Domain  an input of the type that the entry names (contract)
  template <class T>
  void put(T& input, const KeyValue& value) const {
    GW_EXPECTS(owner_ == &kOwner<T>);
    put_(&input, value);
  }
  template <class T>
  bool same(const T& a, const T& b) const {
    GW_EXPECTS(owner_ == &kOwner<T>);
    return same_(&a, &b);
  }

 private:
  template <class T>
  static constexpr char kOwner = 0;  // its address stands for the type

  static void store(double& to, const KeyValue& v) { to = std::get<double>(v); }
  static void store(Angle& to, const KeyValue& v) { to = Angle::degrees(std::get<double>(v)); }
  static void store(int& to, const KeyValue& v) { to = std::get<int>(v); }
  static void store(bool& to, const KeyValue& v) { to = std::get<bool>(v); }
  static void store(std::string& to, const KeyValue& v) { to = std::get<std::string>(v); }
  template <class E>
  requires std::is_enum_v<E>
  static void store(E& to, const KeyValue& v) { to = static_cast<E>(std::get<int>(v)); }
  template <class V>
  static void store(std::optional<V>& to, const KeyValue& v) {
    store(to.emplace(), v);
  }
  template <class V>
  struct Bare {
    using type = V;
  };
  template <class V>
  struct Bare<std::optional<V>> {
    using type = V;
  };

  KeyKind kind_ = KeyKind::any;
  bool angle_ = false;
  const char* owner_ = nullptr;
  std::function<void(void*, const KeyValue&)> put_;
  std::function<bool(const void*, const void*)> same_;
};

struct KeyTable;

/// One key of a table.
struct Key {
  std::string_view key;       ///< as in the file, "helix_angle_deg"
  std::string_view symbol{};  ///< ISO 21771, "β"
  KeyKind kind = KeyKind::number;
  std::vector<std::string_view> words{};  ///< of a word; of other kinds: words that will do, too
  KeyRange range{};                       ///< of each number
  std::optional<KeyList> list{};
  std::string
      form{};  ///< what may stand there, where kind and range do not say it: "a number or …"
  KeyPlace place{};  ///< none: the reader has code for it
  bool required = false;
  std::vector<std::string_view> needs{};     ///< keys that must stand beside it
  std::vector<std::string_view> excludes{};  ///< keys that may not stand beside it
  /// The tables it may be, told apart by their key `kind`.
  std::vector<const KeyTable& (*)()> tables{};
  std::string_view fallback{};  ///< what holds when it is absent: a value as in the file, or words
  bool in_documents = true;     ///< false: the prose beside the table says it
  std::string_view meaning;     ///< one sentence, lower case, without the full stop
  /// The members it sets, as errors name them; none: what its name says, "helix_angle" of
  /// helix_angle_deg.
  std::vector<std::string> fields{};
  std::vector<std::string_view> also{};  ///< what people write for it: "module", "dp"

  /// `fields`, or the one of the name.
  std::vector<std::string> members() const;
};

/// The keys of one table of a spec, in the order in which people read them.
struct KeyTable {
  std::string_view name;     ///< in documents and in the schema: "pair", "rack_circular_arc"
  std::string_view meaning;  ///< one sentence
  std::vector<Key> keys;

  const Key* find(std::string_view key) const;
  std::vector<std::string> names() const;
};

/// The unit that a key's name ends with, without the underscore: "mm"; empty: none.
std::string_view key_unit(std::string_view key);

/// What may stand there, as a sentence says it: "a number", "one of "right", "left"", or `form`.
std::string form_of(const Key& key);

/// A meaning without what only documents show: backticks and numbers of equations.
std::string plain_words(std::string_view meaning);

/// Letters to add, drop or exchange.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// What a word may have been meant to be, and what is known: "did you mean mass? Known are …". A
/// word is a slip of another one where at most one of three letters differs, or a part of it;
/// capitals do not count.
/// `meant`: what the word means here, where that is known.
std::string word_hint(const std::string& word, const std::vector<std::string>& known,
                      std::string_view meant = {});

template <class T, class F>
KeyPlace KeyPlace::within(F reach) {
  using V = std::remove_reference_t<decltype(reach(std::declval<T&>()))>;
  using B = typename Bare<V>::type;
  KeyPlace place;
  place.kind_ = std::is_enum_v<B>                ? KeyKind::word
                : std::is_same_v<B, bool>        ? KeyKind::boolean
                : std::is_same_v<B, int>         ? KeyKind::whole
                : std::is_same_v<B, std::string> ? KeyKind::text
                                                 : KeyKind::number;
  place.angle_ = std::is_same_v<B, Angle>;
  place.owner_ = &kOwner<T>;
  place.put_ = [reach](void* input, const KeyValue& v) {
    store(reach(*static_cast<T*>(input)), v);
  };
  place.same_ = [reach](const void* a, const void* b) {
    // `reach` wants something to change; it is only looked at.
    auto& at_a = reach(*const_cast<T*>(static_cast<const T*>(a)));  // NOLINT
    auto& at_b = reach(*const_cast<T*>(static_cast<const T*>(b)));  // NOLINT
    return at_a == at_b;
  };
  return place;
}

}  // namespace gearwright
