// The catalogue of inputs: what is said of each key of a spec, once.
//
//   Key        name in the file, symbol, kind, range with its reason, default, what it needs or
//              excludes, one sentence of meaning, and the member of an input struct that it sets
//   KeyTable   the keys of one table of a spec, and the rule that they keep together
//   KeyPlace   the member, key_place.hpp
//
// Reading, the nearest-name hint, the tables of docs/spec.md and the JSON Schema of specs are made
// from it. A new key is one entry of one of the *_keys.cpp files.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/key_place.hpp"

namespace gearwright {

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

/// The order of a list's numbers; without a sentence any.
struct ListOrder {
  bool strict = false;          ///< no number stands there twice
  std::string_view sentence{};  ///< of a list that breaks it; its {} are the first and the last
};

inline constexpr ListOrder kLowerFirst{false, "must be two numbers, the lower one first"};

/// A list instead of one value.
struct KeyList {
  std::size_t least = 1, most = 1;
  bool single = false;      ///< one value without a list will do, too
  ListOrder order{};        ///< of numbers
  std::string_view noun{};  ///< what a word of the list is: "objective"
  /// The word that is meant by another one; empty: none.
  std::string_view (*meant)(std::string_view word) = nullptr;
  std::string_view must{};  ///< of tables: what the list must be
  int first = 1;            ///< number of its first element in a path
  bool numbers = false;     ///< of a key for a table: the list that may stand there has numbers
};

/// A key that gives in another unit or section what the key `of` gives.
struct KeyAlias {
  std::string_view of;
  double (*value)(double given, double cos_beta) = nullptr;  ///< in the unit of `of`
  bool transverse = false;  ///< of the transverse section: the helix angle counts
};

struct KeyTable;

/// The fallback of a key that must be there.
inline constexpr std::string_view kRequired = "required";

/// One key of a table. Most are made by one of the functions below and completed by with_…().
struct Key {
  using Words = std::vector<std::string_view>;

  std::string_view key;       ///< as in the file, "helix_angle_deg"
  std::string_view symbol{};  ///< ISO 21771, "β"
  KeyKind kind = KeyKind::number;
  Words words{};     ///< of a word; of other kinds: words that will do, too
  KeyRange range{};  ///< of each number
  std::optional<KeyList> list{};
  std::string
      form{};  ///< what may stand there, where kind and range do not show it: "a number or …"
  KeyPlace place{};  ///< none: the reader has code for it
  bool required = false;
  Words needs{};     ///< keys that must stand beside it
  Words excludes{};  ///< keys that may not stand beside it
  /// The tables it may be, told apart by their key `kind`.
  std::vector<const KeyTable& (*)()> tables{};
  std::string_view fallback{};  ///< what holds when it is absent: a value as in the file, or words
  bool in_documents = true;     ///< false: the prose beside the table has it
  std::string_view meaning;     ///< one sentence, lower case, without the full stop
  /// The members it sets, as errors name them; none: that of its name, "helix_angle" of
  /// helix_angle_deg.
  std::vector<std::string> fields{};
  Words also{};  ///< what people write for it: "module", "dp"
  KeyAlias alias{};

  /// A number; whole if its place holds one.
  static Key number(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
                    std::string_view fallback, std::string_view meaning);
  static Key positive(std::string_view key, std::string_view symbol, KeyPlace place,
                      std::string_view fallback, std::string_view meaning);
  static Key not_negative(std::string_view key, std::string_view symbol, KeyPlace place,
                          std::string_view fallback, std::string_view meaning);
  static Key word(std::string_view key, Words words, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  /// true or false.
  static Key flag(std::string_view key, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  static Key text(std::string_view key, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  /// A table within the table, [gear1.bore]; documents show it by a heading.
  static Key part(std::string_view key, const KeyTable& (*table)(), KeyPlace place,
                  std::string_view meaning);

  Key with_list(KeyList l) && {
    list = l;
    return std::move(*this);
  }
  Key with_form(std::string f) && {
    form = std::move(f);
    return std::move(*this);
  }
  Key with_needs(Words keys) && {
    needs = std::move(keys);
    return std::move(*this);
  }
  Key with_excludes(Words keys) && {
    excludes = std::move(keys);
    return std::move(*this);
  }
  Key with_fields(std::vector<std::string> f) && {
    fields = std::move(f);
    return std::move(*this);
  }
  Key with_also(Words w) && {
    also = std::move(w);
    return std::move(*this);
  }
  Key with_alias(KeyAlias a) && {
    alias = a;
    return std::move(*this);
  }
  Key undocumented() && {
    in_documents = false;
    return std::move(*this);
  }

  /// `fields`, or the one of the name.
  std::vector<std::string> members() const;
};

/// The keys of one table of a spec, in the order in which people read them.
struct KeyTable {
  std::string_view name;     ///< in documents and in the schema: "pair", "rack_circular_arc"
  std::string_view meaning;  ///< one sentence
  std::vector<Key> keys;
  KeyRule rule{};  ///< of what was read; needs and excludes are those of the keys

  const Key* find(std::string_view key) const;
  std::vector<std::string> names() const;
  /// The key, and those whose alias it is.
  std::vector<std::string> ways(std::string_view key) const;
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

}  // namespace gearwright
