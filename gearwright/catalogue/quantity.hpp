// The catalogue of results: what is said of each quantity, once, and how it is got.
//
//   QuantityInfo    key, words (the standard's term), symbol, unit, digits, one sentence
//   Quantity<S>     the same with the way to get it from a subject S: a gear, a pair, a contact
//   Quantities<S>   all quantities of a subject; of(subject) is the record that every door takes
//
// JSON, the terminal's listing, the page's tables, CSV, the schema of results and the tables of
// docs/spec.md are made from it. A new quantity is one entry of one of the *_quantities.cpp files.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/term.hpp"
#include "gearwright/catalogue/value.hpp"

namespace gearwright {

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
  Quantity& unit(Unit u) { return info.unit = u, *this; }
  Quantity& words(std::string w) { return info.words = std::move(w), *this; }
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

/// Whether T is an angle, or angles that may be absent, two or many.
template <class T>
struct HasAngles : std::is_same<T, Angle> {};
template <class T>
struct HasAngles<std::optional<T>> : HasAngles<T> {};
template <class T, std::size_t n>
struct HasAngles<std::array<T, n>> : HasAngles<T> {};
template <class T>
struct HasAngles<std::vector<T>> : HasAngles<T> {};

/// Angles as values, in degrees or seconds of arc.
Value angles_in(Unit unit, Angle angle);
template <class T>
Value angles_in(Unit unit, const std::optional<T>& maybe) {
  return maybe ? angles_in(unit, *maybe) : Value();
}
template <class Range>
Value angles_in(Unit unit, const Range& angles) {
  ValueList list;
  for (const auto& a : angles) list.push_back(angles_in(unit, a));
  return list;
}

template <class S>
class Quantities;

/// The record of a subject, of one that may be absent, of each of a range; or the finished value.
template <class T, class R>
Value record_value(const Quantities<T>& quantities, const R& found) {
  if constexpr (std::is_same_v<R, T>) {
    return quantities.of(found);
  } else if constexpr (std::is_same_v<R, std::optional<T>> || std::is_same_v<R, const T*>) {
    return found ? Value(quantities.of(*found)) : Value();
  } else if constexpr (std::is_convertible_v<R, Value> && !std::is_same_v<R, std::vector<T>>) {
    return found;
  } else {
    return quantities.each(found);
  }
}

template <class S>
class Quantities {
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

  /// Heads the quantities that follow for people; none at first.
  void under(const char* group) { group_ = group; }

  /// One quantity, in the unit that its key ends with. `get` is a member of S or a function of it: a
  /// value, or angles, which take the unit of the key. `symbol` may be empty.
  template <class G>
  Quantity<S>& add(Type type, const char* key, const char* words, const char* symbol,
                   const char* meaning, G get) {
    const Unit unit = type == Type::record || type == Type::text ? Unit::none : unit_of(key);
    list_.push_back({{key, words, symbol, unit, group_, meaning, type}, getter(unit, get)});
    return list_.back();
  }
  template <class G>
  Quantity<S>& number(const char* key, const char* words, const char* symbol, const char* meaning,
                      G get) {
    return add(Type::number, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  Quantity<S>& whole(const char* key, const char* words, const char* symbol, const char* meaning,
                     G get) {
    return add(Type::whole, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  Quantity<S>& flag(const char* key, const char* words, const char* meaning, G get) {
    return add(Type::flag, key, words, "", meaning, std::move(get)).always();
  }
  template <class G>
  Quantity<S>& word(const char* key, const char* words, const char* meaning, G get) {
    return add(Type::word, key, words, "", meaning, std::move(get));
  }
  template <class G>
  Quantity<S>& text(const char* key, const char* meaning, G get) {
    return add(Type::text, key, key, "", meaning, std::move(get)).doors(kJson);
  }
  /// A quantity of several tables, whose words and symbol are those of its term.
  template <class G>
  Quantity<S>& term(const char* key, const char* meaning, G get) {
    const Term& t = term_of(key);
    Quantity<S>& q = add(t.type, key, t.words, t.symbol, meaning, std::move(get));
    q.info.always = t.type == Type::flag;
    return q;
  }
  /// A record of the quantities `of`, or a list of them: `get` gives the subject, an optional or a
  /// pointer that may be empty, a range of subjects, or the finished value.
  template <const auto& (*of)(), class G>
  Quantity<S>& record(const char* key, const char* meaning, G get) {
    Quantity<S>& q = add(Type::record, key, key, "", meaning,
                         [get](const S& s) { return record_value(of(), std::invoke(get, s)); });
    q.info.of = []() -> const QuantityTable& { return of().table(); };
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
  /// The records of many, in their order.
  template <class Range>
  ValueList each(const Range& subjects) const {
    ValueList list;
    for (const auto& s : subjects) list.push_back(of(s));
    return list;
  }

 private:
  template <class G>
  static Get getter(Unit unit, G get) {
    using R = std::remove_cvref_t<std::invoke_result_t<G, const S&>>;
    if constexpr (HasAngles<R>::value) {
      return [unit, get](const S& s) { return angles_in(unit, std::invoke(get, s)); };
    } else {
      return get;
    }
  }

  std::deque<Quantity<S>> list_;  // entries stay where they are while more are added
  QuantityTable table_;
  const char* group_ = "";
};

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
