// The catalogue of results: what is said of each quantity, once, and how it is got.
//
//   QuantityInfo            key, words (the standard's term), symbol, unit, digits, one sentence
//   Quantity<S>     the same with the way to get it from a subject S: a gear, a pair, a contact
//   Quantities<S>   all quantities of a subject; of(subject) is the record that every door takes
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
  modules,          ///< normal modules; no unit for people
  modules_squared,  ///< of a region of two shifts
  percent           ///< a share of 1; people read 100 times it
};

enum class Type {
  number,
  whole,
  index,  ///< a whole number that may pass 2³¹
  flag,
  word,
  text,
  record,
  map
};

/// Where a quantity is given.
enum Doors : unsigned {
  kJson = 1,     ///< JSON, and what reads it
  kListing = 2,  ///< the tables of the terminal
  kPage = 4,     ///< the tables of the report
  kPeople = kListing | kPage,
  kAllDoors = kJson | kPeople
};

/// What two values of a list are.
enum class Two {
  values,  ///< two of a list
  gears,   ///< gear 1, gear 2: a column each
  ends     ///< from, to
};

struct QuantityTable;

/// What is said of a quantity.
struct QuantityInfo {
  std::string key;     ///< in JSON, with its unit: "tip_diameter_mm"
  std::string words;   ///< the term of ISO 21771 or ISO 1122-1 where there is one
  std::string symbol;  ///< "d_a", indices after the underscore
  Unit unit = Unit::none;
  std::string group{};    ///< heading for people
  std::string meaning{};  ///< one sentence, and when it exists; without the full stop
  Type type = Type::number;
  std::vector<int> list{};            ///< lengths of nested lists, 0: any; empty: one value
  Two two = Two::values;              ///< of a list of two
  bool always = false;                ///< never null
  std::vector<std::string> one_of{};  ///< of a word
  unsigned doors = kAllDoors;
  std::optional<int> digits{};             ///< decimals for people; absent: those of the unit
  std::string nothing{};                   ///< what people read where there is no value
  const QuantityTable& (*of)() = nullptr;  ///< of a record: what it holds
  std::string column{};                    ///< in CSV and Parquet; "#" is the gear's number
  bool greater_first = false;              ///< the better are the greater
  bool optional_key = false;               ///< absent, not null, where it does not exist
};

/// What may stand in a record, in order.
struct QuantityTable {
  std::string name;  ///< "gear", "pair", "pair.backlash"
  std::vector<const QuantityInfo*> list;
  std::vector<std::string> groups;  ///< headings for people, in their order

  const QuantityInfo* find(std::string_view key) const;
};

template <class S>
struct Quantity {
  QuantityInfo info;
  std::function<Value(const S&)> get;
  std::function<bool(const S&)> exists{};  ///< else the key is absent; none: always there
  std::function<bool(const S&)> worth{};   ///< else no row for people; none: always
  std::function<bool(const S&)> asked{};   ///< people see a dash where it has no value

  // Refinements of an entry, in the order in which one says them.
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

/// The forms of an entry of S. `Self` adds it.
template <class Self, class S>
class QuantityForms {
 public:
  using Get = std::function<Value(const S&)>;

  // One quantity each. `group` heads it for people, `symbol` may be empty.
  auto& mm(const char* group, const char* key, const char* words, const char* symbol,
           const char* meaning, Get get) {
    return number(Unit::mm, group, key, words, symbol, meaning, std::move(get));
  }
  auto& deg(const char* group, const char* key, const char* words, const char* symbol,
            const char* meaning, Get get) {
    return number(Unit::deg, group, key, words, symbol, meaning, std::move(get));
  }
  auto& pure(const char* group, const char* key, const char* words, const char* symbol,
             const char* meaning, Get get) {
    return number(Unit::none, group, key, words, symbol, meaning, std::move(get));
  }
  auto& number(Unit unit, const char* group, const char* key, const char* words, const char* symbol,
               const char* meaning, Get get) {
    return self().add(Type::number, unit, group, key, words, symbol, meaning, std::move(get));
  }
  auto& whole(const char* group, const char* key, const char* words, const char* symbol,
              const char* meaning, Get get) {
    return self().add(Type::whole, Unit::none, group, key, words, symbol, meaning, std::move(get));
  }
  auto& flag(const char* group, const char* key, const char* words, const char* meaning, Get get) {
    return self()
        .add(Type::flag, Unit::none, group, key, words, "", meaning, std::move(get))
        .always();
  }
  auto& word(const char* group, const char* key, const char* words, const char* meaning, Get get) {
    return self().add(Type::word, Unit::none, group, key, words, "", meaning, std::move(get));
  }
  auto& text(const char* key, const char* meaning, Get get) {
    return self()
        .add(Type::text, Unit::none, "", key, key, "", meaning, std::move(get))
        .doors(kJson);
  }
  /// A record, or a list of them, of what `of` says.
  auto& record(const char* group, const char* key, const char* meaning,
               const QuantityTable& (*of)(), Get get) {
    auto& q = self().add(Type::record, Unit::none, group, key, key, "", meaning, std::move(get));
    q.info.of = of;
    return q;
  }

 private:
  Self& self() { return static_cast<Self&>(*this); }
};

template <class S, class P>
class PartQuantities;

template <class S>
class Quantities : public QuantityForms<Quantities<S>, S> {
 public:
  using Get = std::function<Value(const S&)>;

  /// `fill` says the quantities, in the order of the keys.
  template <class Fill>
  Quantities(std::string name, const Fill& fill) {
    fill(*this);
    table_.name = std::move(name);
    for (const Quantity<S>& q : list_) table_.list.push_back(&q.info);
  }
  Quantities(const Quantities&) = delete;  // the table points into the list
  Quantities& operator=(const Quantities&) = delete;

  /// The headings in the order in which people meet them; others follow as they come.
  void groups(std::vector<std::string> titles) { table_.groups = std::move(titles); }

  Quantity<S>& add(Type type, Unit unit, const char* group, const char* key, const char* words,
                   const char* symbol, const char* meaning, Get get) {
    list_.push_back({{key, words, symbol, unit, group, meaning, type}, std::move(get)});
    return list_.back();
  }
  /// Entries of a part of the subject, which `find` finds or not.
  template <class P>
  PartQuantities<S, P> part(const P* (*find)(const S&)) {
    return {*this, find};
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
  /// The records of many, in their order.
  template <class Range>
  ValueList each(const Range& subjects) const {
    ValueList list;
    for (const auto& s : subjects) list.push_back(of(s));
    return list;
  }

 private:
  std::deque<Quantity<S>> list_;  // entries stay where they are while more are added
  QuantityTable table_;
};

/// Entries of what only some subjects have: one kind of pair, a result that may be absent. Their
/// getters take it as it is; without it the value is null.
template <class S, class P>
class PartQuantities : public QuantityForms<PartQuantities<S, P>, P> {
 public:
  using Find = const P* (*)(const S&);

  PartQuantities(Quantities<S>& all, Find find) : all_(all), find_(find) {}

  Quantity<S>& add(Type type, Unit unit, const char* group, const char* key, const char* words,
                   const char* symbol, const char* meaning, std::function<Value(const P&)> get) {
    return all_.add(type, unit, group, key, words, symbol, meaning,
                    [find = find_, get = std::move(get)](const S& subject) {
                      const P* part = find(subject);
                      return part ? get(*part) : Value();
                    });
  }

 private:
  Quantities<S>& all_;
  Find find_;
};

/// "mm", "°", "µm"; empty for pure numbers.
std::string_view unit_text(Unit unit);
/// How a key ends that has this unit: "_mm", "_deg"; empty for pure numbers.
std::string_view unit_suffix(Unit unit);

/// Decimals that people read: 4 of mm (0.1 µm, the last digit of a gear drawing), 5 of degrees
/// (0.17 µm on a radius of 1 m) and of pure numbers.
int digits_of(const QuantityInfo& info);

/// A value as people read it, without its unit; `none` where there is no value. Lists become
/// "x, y, z", two ends "lo … hi".
std::string text_of(const QuantityInfo& info, const Value& value, std::string_view none = "–");

/// A row for people: one quantity, a text for each column. A pair's common value has one text.
struct TextRow {
  const QuantityInfo* info;
  std::vector<std::string> texts;
};

/// Rows under a heading.
struct TextGroup {
  std::string title;
  std::vector<TextRow> rows;
};

/// What people see of records side by side (two gears), or of one with values per gear (a pair):
/// the quantities of that door which any of the records shows, under their headings.
/// Records inside are rows too, under their own words. `table` is that of the records.
std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   std::string_view none = "–");

/// "Tip diameter" of "tip diameter".
std::string capitalised(std::string words);

}  // namespace gearwright
