// The catalogue of inputs. Each key of a spec is described only here.
//
//   Key        name in the file, symbol, kind, range with its reason, default, keys that it needs
//              or excludes, one sentence of meaning, and the member of an input struct that it sets
//   KeyTable   the keys of one table of a spec, and a rule that relates several keys
//   KeyPlace   the member in which the value of a key is stored (key_place.hpp)
//
// Several parts of the program use the catalogue: the reader, the suggestions for unknown keys, the
// tables of docs/spec.md, and the JSON Schema of specs. A new key is one entry in one of the
// *_keys.cpp files.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/key_place.hpp"

namespace gearwright {

constexpr double kMaxInput = 1e9;  ///< limit of every number in a spec, in the unit of its key
constexpr double kMaxWholeInput = 1e6;

/// The permitted numbers, and the reason for the limits.
struct KeyRange {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool lo_open = false, hi_open = false;  ///< true if the end itself is not allowed
  bool zero = true;                       ///< false if 0 is not allowed
  std::string reason{};                   ///< text after the range, ", usually 14.5 to 30"

  // Either end may be infinite.
  static KeyRange between(double lo, double hi, std::string reason = "") {
    return {lo, hi, false, false, true, std::move(reason)};
  }
  static KeyRange inside(double lo, double hi, std::string reason = "") {  ///< ends excluded
    return {lo, hi, true, true, true, std::move(reason)};
  }
  static KeyRange above(double lo, double hi, std::string reason = "") {  ///< lower end excluded
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
  /// Returns the error for `value`, for example "must lie between 1 and 60, usually 14.5 to 30".
  ///
  /// Domain    limited() (contract)
  std::string sentence(double value) const;
};

/// The order of the numbers in a list. If `sentence` is empty, any order is allowed.
struct ListOrder {
  bool strict = false;          ///< true if no number may be repeated
  std::string_view sentence{};  ///< message for a list in another order; each {} stands for the
                                ///< first or the last number
};

inline constexpr ListOrder kLowerFirst{false, "must be two numbers in rising order"};

struct KeyList {
  std::size_t least = 1, most = 1;
  bool single = false;  ///< a single value without a list is also allowed
  ListOrder order{};
  std::string_view noun{};  ///< noun for one word of the list: "objective"
  /// Returns the word of which `word` is a synonym, or "" if it is not a synonym.
  std::string_view (*meant)(std::string_view word) = nullptr;
  std::string_view must{};  ///< requirement on the value, for the errors about this list; {} stands
                            ///< for `most`; if empty, form_of() gives the requirement
  int first = 1;            ///< index of the first element in the path of an element
  bool numbers = false;     ///< true if a key whose value is a table also allows a list of numbers
  /// Returns the numbers of the series with the name `word`, for example the modules of "ISO54-I".
  /// Returns an empty list if there is no such series.
  std::vector<double> (*series)(std::string_view word) = nullptr;
};

/// A key that sets the value of another key, `of`. The given value has another unit than the value
/// of `of`, or belongs to the transverse section instead of the normal section.
struct KeyAlias {
  std::string_view of;
  double (*value)(double given, double cos_beta) = nullptr;  ///< converts to the unit of `of`
  bool transverse = false;  ///< true if the value belongs to the transverse section; the conversion
                            ///< then depends on the helix angle
};

struct KeyTable;

/// The text in place of a default for a required key.
inline constexpr std::string_view kRequired = "required";

/// One key of a table. Most keys are made by one of the functions below and completed by the
/// functions with_…().
struct Key {
  using Words = std::vector<std::string_view>;

  std::string_view key;       ///< name in the file, "helix_angle_deg"
  std::string_view symbol{};  ///< symbol of ISO 21771, "β"
  KeyKind kind = KeyKind::number;
  Words words{};  ///< the permitted words; if the kind is not `word`, words that are permitted in
                  ///< addition
  KeyRange range{};
  std::optional<KeyList> list{};
  std::string
      form{};  ///< description of the permitted values, if kind and range do not describe them: "a
               ///< number or …"
  KeyPlace place{};  ///< empty if the reader handles this key
  bool required = false;
  Words needs{};                    ///< keys that must also be given
  Words excludes{};                 ///< keys that must not also be given
  std::string_view excludes_why{};  ///< rule of the error if a key of `excludes` is also given; if
                                    ///< empty, the rule is that only one of the keys can be given
  /// The possible tables, distinguished by their key `kind`.
  std::vector<const KeyTable& (*)()> tables{};
  std::string_view fallback{};  ///< the default, written as in the file or described in words
  bool in_documents = true;     ///< false if the text of the documents already describes the key
  std::string_view meaning;     ///< one sentence, lower case, without the full stop
  /// The names of the members that this key sets, as used in errors of the engine. The default is
  /// the name of the key without its unit, for example "helix_angle" for helix_angle_deg.
  std::vector<std::string> fields{};
  Words also{};  ///< other names that users may try: "module", "dp"
  KeyAlias alias{};

  /// Makes a key for a number or for numbers by name. If the KeyPlace is a member of type int, the
  /// value must be a whole number.
  static Key number(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
                    std::string_view fallback, std::string_view meaning);
  static Key positive(std::string_view key, std::string_view symbol, KeyPlace place,
                      std::string_view fallback, std::string_view meaning);
  static Key not_negative(std::string_view key, std::string_view symbol, KeyPlace place,
                          std::string_view fallback, std::string_view meaning);
  static Key word(std::string_view key, Words words, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  static Key flag(std::string_view key, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  static Key text(std::string_view key, KeyPlace place, std::string_view fallback,
                  std::string_view meaning);
  /// Makes a key for a table inside this table, such as bore in [gear1.bore]. The inner table has
  /// its own heading in the documents.
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
  Key with_excludes(Words keys, std::string_view why = {}) && {
    excludes = std::move(keys);
    excludes_why = why;
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

  /// Returns `fields` if it is not empty. Otherwise returns the name of the key without its unit,
  /// or, for an alias, the name of the key that the alias sets.
  std::vector<std::string> members() const;
};

/// The keys of one table of a spec, in the order for documents.
struct KeyTable {
  std::string_view name;     ///< name in documents and in the schema: "pair", "rack_circular_arc"
  std::string_view meaning;  ///< one sentence
  std::vector<Key> keys;
  KeyRule rule{};  ///< checks the values after reading; `needs` and `excludes` are checked
                   ///< separately for each key
  /// A spec may give a text or a list of numbers in place of the table, for example material =
  /// "16MnCr5". The text or list then sets this key. It is empty if the table has no such key.
  std::string_view shorthand{};

  const Key* find(std::string_view key) const;
  /// only() returns a table with only these keys, in this order. The table must have these keys.
  /// without() omits these keys. Neither result has the rule or the shorthand of the table.
  KeyTable only(const std::vector<std::string_view>& kept) const;
  KeyTable without(const std::vector<std::string_view>& left_out) const;
  std::vector<std::string> names() const;
  /// Returns the key and its aliases. A spec can give the value by any one of these keys.
  std::vector<std::string> ways(std::string_view key) const;
};

/// Returns the unit at the end of a key, without the underscore, for example "deg". The text is
/// empty if the key has no unit. The other function returns the key without this ending.
std::string_view key_unit(std::string_view key);
std::string_view without_unit(std::string_view key);

/// Returns the permitted values as part of a sentence, for example "a number". If the key has a
/// Key::form, the function returns this form.
std::string form_of(const Key& key);

/// Returns a meaning as plain text, without backticks and without numbers of equations.
std::string plain_words(std::string_view meaning);

/// Returns the least number of changes that turn one word into the other. A change inserts, deletes
/// or replaces a letter, or exchanges two neighbouring letters. No letter is changed twice.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the known word that the user probably meant by an unknown word. At most one letter in
/// three may differ, or one of the words must be a part of the other and have at least three
/// letters. Case is ignored. Returns an empty text if no word is similar.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

/// Returns the end of a message about an unknown word, for example "; did you mean mass?". Returns
/// an empty text if no known word is similar.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// Returns the rule for a value that must be one of the known words, for example "must be one of
/// "right", "left"; did you mean left?".
std::string one_of_rule(const std::string& word, const std::vector<std::string>& known);

/// Returns a suggestion for an unknown word, followed by the known words, for example "did you mean
/// mass? Known are …". `meant` is the word that the user means. It is empty if the caller does not
/// know this word.
std::string word_hint(const std::string& word, const std::vector<std::string>& known,
                      std::string_view meant = {});

}  // namespace gearwright
