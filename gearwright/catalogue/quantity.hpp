// The catalogue of results: the only description of each quantity, with its getter.
//
//   QuantityInfo            key, words (the standard's term), symbol, unit, digits, one sentence
//   Quantity<S>     the same with the getter from a subject S: a gear, a pair, a contact
//   Quantities<S>   all quantities of a subject; of(subject) is the record for all interfaces
//
// JSON, the terminal's listing, the page's tables, CSV, the schema of results and the tables of
// docs/spec.md are made from it. A new quantity is one entry of one of the *_quantities.cpp files.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearwright/catalogue/value.hpp"

namespace gearwright {

enum class Unit {
  none,
  mm,
  um,
  deg,
  arcsec,
  per_mm,
  mm_per_rad,
  m_per_s,
  newton,
  newton_metre,
  kilowatt,
  megapascal,
  per_minute,
  hertz,
  newton_per_mm,
  newton_per_mm_um,  ///< stiffness of a mesh per face width
  newton_per_um,
  celsius,
  kg,
  kg_per_mm,
  modules,          ///< normal modules; users see no unit
  modules_squared,  ///< of a region of two shifts
  percent           ///< a fraction of 1; users see 100 times it
};

enum class Type {
  number,
  whole,
  index,  ///< a whole number that may exceed 2³¹
  flag,
  word,
  text,
  record,
  map
};

/// The interfaces at which a quantity is given.
enum Doors : unsigned {
  kJson = 1,     ///< JSON, and readers of JSON
  kListing = 2,  ///< the tables of the terminal
  kPage = 4,     ///< the tables of the report
  kPeople = kListing | kPage,
  kAllDoors = kJson | kPeople
};

/// The meaning of two values of a list.
enum class Two {
  values,  ///< two of a list
  gears,   ///< gear 1, gear 2: a column each
  ends     ///< from, to
};

struct QuantityTable;

/// The description of a quantity.
struct QuantityInfo {
  std::string key;     ///< in JSON, with its unit: "tip_diameter_mm"
  std::string words;   ///< the term of ISO 21771 or ISO 1122-1 where there is one
  std::string symbol;  ///< "d_a", indices after the underscore
  Unit unit = Unit::none;
  std::string group{};    ///< heading for users
  std::string meaning{};  ///< one sentence, and the condition of its existence; without the full
                          ///< stop
  Type type = Type::number;
  std::vector<int> list{};            ///< lengths of nested lists, 0: any; empty: one value
  Two two = Two::values;              ///< of a list of two
  bool always = false;                ///< never null
  std::vector<std::string> one_of{};  ///< of a word
  unsigned doors = kAllDoors;
  std::optional<int> digits{};             ///< decimals for users; absent: those of the unit
  std::string nothing{};                   ///< text for users if there is no value
  const QuantityTable& (*of)() = nullptr;  ///< for a record: its contents
  std::string column{};                    ///< in CSV and Parquet; "#" is the gear's number
  bool greater_first = false;              ///< greater values are better
  bool optional_key = false;               ///< the key is absent, rather than null, if the quantity
                                           ///< does not exist
};

/// The possible members of a record, in order.
struct QuantityTable {
  std::string name;  ///< "gear", "pair", "pair.backlash"
  std::vector<const QuantityInfo*> list;
  std::vector<std::string> groups;  ///< headings for users, in their order

  const QuantityInfo* find(std::string_view key) const;
};

template <class S>
struct Quantity {
  QuantityInfo info;
  std::function<Value(const S&)> get;
  std::function<bool(const S&)> exists{};  ///< if false, the key is absent; by default always
                                           ///< present
  std::function<bool(const S&)> worth{};   ///< if false, users see no row; by default always
  std::function<bool(const S&)> asked{};   ///< if true, users see a dash instead of a missing value

  // Refinements of an entry, in the usual order.
  Quantity& always() { return info.always = true, *this; }
  Quantity& digits(int n) { return info.digits = n, *this; }
  Quantity& doors(unsigned d) { return info.doors = d, *this; }
  Quantity& one_of(std::vector<std::string> w) { return info.one_of = std::move(w), *this; }
  Quantity& list(std::vector<int> l) { return info.list = std::move(l), *this; }
  Quantity& per_gear() { return info.list = {2}, info.two = Two::gears, *this; }
  Quantity& ends() { return info.list = {2}, info.two = Two::ends, *this; }
  Quantity& column(std::string name) { return info.column = std::move(name), *this; }
  Quantity& greater_first() { return info.greater_first = true, *this; }
  Quantity& otherwise(std::string text) { return info.nothing = std::move(text), *this; }
  Quantity& when(std::function<bool(const S&)> f) {
    info.optional_key = true;
    return exists = std::move(f), *this;
  }
  Quantity& expected(std::function<bool(const S&)> f) { return asked = std::move(f), *this; }
  Quantity& shown(std::function<bool(const S&)> f) { return worth = std::move(f), *this; }
};

template <class S>
class Quantities {
 public:
  using Get = std::function<Value(const S&)>;

  /// `fill` adds the quantities, in the order of the keys.
  template <class Fill>
  Quantities(std::string name, const Fill& fill) {
    fill(*this);
    table_.name = std::move(name);
    for (const Quantity<S>& q : list_) table_.list.push_back(&q.info);
  }
  Quantities(const Quantities&) = delete;  // the table points into the list
  Quantities& operator=(const Quantities&) = delete;

  /// The headings in the order for users; others are appended in the order of their first use.
  void groups(std::vector<std::string> titles) { table_.groups = std::move(titles); }

  // Adds one quantity. `group` is its heading for users, `symbol` may be empty.
  Quantity<S>& add(Type type, Unit unit, const char* group, const char* key, const char* words,
                   const char* symbol, const char* meaning, Get get) {
    list_.push_back({{key, words, symbol, unit, group, meaning, type}, std::move(get)});
    return list_.back();
  }
  Quantity<S>& mm(const char* group, const char* key, const char* words, const char* symbol,
                  const char* meaning, Get get) {
    return add(Type::number, Unit::mm, group, key, words, symbol, meaning, std::move(get));
  }
  Quantity<S>& deg(const char* group, const char* key, const char* words, const char* symbol,
                   const char* meaning, Get get) {
    return add(Type::number, Unit::deg, group, key, words, symbol, meaning, std::move(get));
  }
  Quantity<S>& pure(const char* group, const char* key, const char* words, const char* symbol,
                    const char* meaning, Get get) {
    return add(Type::number, Unit::none, group, key, words, symbol, meaning, std::move(get));
  }
  Quantity<S>& whole(const char* group, const char* key, const char* words, const char* symbol,
                     const char* meaning, Get get) {
    return add(Type::whole, Unit::none, group, key, words, symbol, meaning, std::move(get));
  }
  Quantity<S>& flag(const char* group, const char* key, const char* words, const char* meaning,
                    Get get) {
    return add(Type::flag, Unit::none, group, key, words, "", meaning, std::move(get)).always();
  }
  Quantity<S>& word(const char* group, const char* key, const char* words, const char* meaning,
                    Get get) {
    return add(Type::word, Unit::none, group, key, words, "", meaning, std::move(get));
  }
  Quantity<S>& text(const char* key, const char* meaning, Get get) {
    return add(Type::text, Unit::none, "", key, key, "", meaning, std::move(get)).doors(kJson);
  }
  /// Adds a record, or a list of records, with the quantities of `of`.
  Quantity<S>& record(const char* group, const char* key, const char* meaning,
                      const QuantityTable& (*of)(), Get get) {
    Quantity<S>& q = add(Type::record, Unit::none, group, key, key, "", meaning, std::move(get));
    q.info.of = of;
    return q;
  }

  const QuantityTable& table() const { return table_; }
  const std::deque<Quantity<S>>& list() const { return list_; }

  /// The record of a subject.
  ValueRecord of(const S& subject) const {
    ValueRecord record;
    record.reserve(list_.size());
    for (const Quantity<S>& q : list_) {
      if (q.exists && !q.exists(subject)) continue;
      Value value = q.get(subject);
      const bool row =
          (!q.worth || q.worth(subject)) && (!all_nothing(value) || (q.asked && q.asked(subject)));
      record.push_back({&q.info, std::move(value), row});
    }
    return record;
  }
  /// The records of several subjects, in their order.
  template <class Range>
  ValueList each(const Range& subjects) const {
    ValueList list;
    for (const auto& s : subjects) list.push_back(of(s));
    return list;
  }

 private:
  std::deque<Quantity<S>> list_;  // the addresses of entries stay valid while more are added
  QuantityTable table_;
};

/// "mm", "°", "µm"; empty for pure numbers.
std::string_view unit_text(Unit unit);
/// The end of a key with this unit: "_mm", "_deg"; empty for pure numbers.
std::string_view unit_suffix(Unit unit);

/// Decimals for users: 4 for mm (0.1 µm, the last digit of a gear drawing), 5 for degrees (0.17 µm
/// on a radius of 1 m) and for pure numbers.
int digits_of(const QuantityInfo& info);

/// A value as text for users, without its unit; `none` if there is no value. Lists become "x, y,
/// z", two ends "lo … hi".
std::string text_of(const QuantityInfo& info, const Value& value, std::string_view none = "–");

/// A row for users: one quantity, a text for each column. A pair's common value has one text.
struct TextRow {
  const QuantityInfo* info;
  std::vector<std::string> texts;
};

/// Rows under a heading.
struct TextGroup {
  std::string title;
  std::vector<TextRow> rows;
};

/// The table for users of records side by side (two gears), or of one record with values per gear
/// (a pair): the quantities of that interface that at least one record shows, under their headings.
/// Inner records are rows too, under their own words. `table` is that of the records.
std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   std::string_view none = "–");

/// "Tip diameter" of "tip diameter".
std::string capitalised(std::string words);

}  // namespace gearwright
