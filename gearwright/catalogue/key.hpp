// The catalogue of inputs: the description of each key of a spec, written once.
//
//   Key        name in the file, symbol, kind, range with its reason, default, keys it needs or
//              excludes, one sentence of meaning, and the member of an input struct that it sets
//   KeyTable   the keys of one table of a spec, and the rule that they keep together
//   KeyPlace   the member, key_place.hpp
//
// The reader, the suggestions for unknown keys, the tables of docs/spec.md and the JSON Schema of
// specs use it. A new key is one entry of one of the *_keys.cpp files.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/key_place.hpp"

namespace gearwright {

constexpr double kMaxInput = 1e9;  ///< limit of any number of a spec, in its unit
constexpr double kMaxWholeInput = 1e6;

/// The permitted numbers, and the reason.
struct KeyRange {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool lo_open = false, hi_open = false;  ///< the end itself is not allowed
  bool zero = true;                       ///< false: 0 is not allowed
  std::string reason{};                   ///< text after the range, ", usually 14.5 to 30"

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
  /// The error of `value`: "must lie between 1 and 60, usually 14.5 to 30".
  ///
  /// Domain    limited() (contract)
  std::string sentence(double value) const;
};

/// The order of the numbers of a list; without a sentence any order.
struct ListOrder {
  bool strict = false;          ///< true if no number may be repeated
  std::string_view sentence{};  ///< message for a list in another order; its {} are the first and
                                ///< the last number
};

inline constexpr ListOrder kLowerFirst{false, "must be two numbers in rising order"};

/// A list instead of one value.
struct KeyList {
  std::size_t least = 1, most = 1;
  bool single = false;      ///< a single value without a list is also allowed
  ListOrder order{};        ///< of numbers
  std::string_view noun{};  ///< noun for a word of the list: "objective"
  /// Returns the word for which another word is a synonym; empty if there is no such word.
  std::string_view (*meant)(std::string_view word) = nullptr;
  std::string_view must{};  ///< for tables: requirement on the list
  int first = 1;            ///< number of its first element in a path
  bool numbers = false;     ///< for a key of a table: a list of numbers is allowed instead
};

/// A key that gives the value of the key `of` in another unit or section.
struct KeyAlias {
  std::string_view of;
  double (*value)(double given, double cos_beta) = nullptr;  ///< in the unit of `of`
  bool transverse = false;  ///< true for a value in the transverse section, which depends on the
                            ///< helix angle
};

struct KeyTable;

/// The fallback of a required key.
inline constexpr std::string_view kRequired = "required";

/// One key of a table. Most are made by one of the functions below and completed by with_…().
struct Key {
  using Words = std::vector<std::string_view>;

  std::string_view key;       ///< as in the file, "helix_angle_deg"
  std::string_view symbol{};  ///< ISO 21771, "β"
  KeyKind kind = KeyKind::number;
  Words words{};     ///< permitted words; for other kinds: words that are also allowed
  KeyRange range{};  ///< of each number
  std::optional<KeyList> list{};
  std::string
      form{};  ///< description of the permitted values, if kind and range do not show it: "a number
               ///< or …"
  KeyPlace place{};  ///< none if the reader handles this key
  bool required = false;
  Words needs{};     ///< keys that must also be given
  Words excludes{};  ///< keys that must not also be given
  /// The possible tables, distinguished by their key `kind`.
  std::vector<const KeyTable& (*)()> tables{};
  std::string_view fallback{};  ///< value if the key is absent, as in the file or in words
  bool in_documents = true;     ///< false if the text of the documents describes it
  std::string_view meaning;     ///< one sentence, lower case, without the full stop
  /// The members that it sets, as in errors; by default the member of its name, "helix_angle" for
  /// helix_angle_deg.
  std::vector<std::string> fields{};
  Words also{};  ///< other names that users try: "module", "dp"
  KeyAlias alias{};

  /// A key for a number, or for a whole number if its place holds one.
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

  /// Returns `fields`, or the member with the name of the key.
  std::vector<std::string> members() const;
};

/// The keys of one table of a spec, in the order for documents.
struct KeyTable {
  std::string_view name;     ///< in documents and in the schema: "pair", "rack_circular_arc"
  std::string_view meaning;  ///< one sentence
  std::vector<Key> keys;
  KeyRule rule{};  ///< for the values that were read; "needs" and "excludes" are checked for each
                   ///< key
  /// The key whose text may stand in place of the table: material = "16MnCr5"; empty if none.
  std::string_view shorthand{};

  const Key* find(std::string_view key) const;
  std::vector<std::string> names() const;
  /// The key and its aliases.
  std::vector<std::string> ways(std::string_view key) const;
};

/// The unit at the end of a key's name, without the underscore: "mm"; empty if there is none.
std::string_view key_unit(std::string_view key);

/// The permitted values as part of a sentence: "a number", "one of "right", "left"", or `form`.
std::string form_of(const Key& key);

/// A meaning without markup for documents: backticks and numbers of equations.
std::string plain_words(std::string_view meaning);

/// Number of letters to insert, delete or exchange.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// A suggestion for an unknown word, with the known words: "did you mean mass? Known are …". A word
/// is a misspelling of another one if at most one of three letters differs, or if it is a part of
/// it. Case is ignored. `meant` is the intended word, if it is known.
std::string word_hint(const std::string& word, const std::vector<std::string>& known,
                      std::string_view meant = {});

}  // namespace gearwright
