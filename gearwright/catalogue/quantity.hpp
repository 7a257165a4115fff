// The catalogue of results. Each quantity and its getter are described only here.
//
//   QuantityInfo    key, words (the standard's term), symbol, unit, digits, one sentence
//   Quantity<S>     a quantity with its getter for a subject S: a gear, a pair, a contact
//   Quantities<S>   all quantities of a subject; of(subject) returns the record for all interfaces
//
// JSON, the listings in the terminal, the page's tables, CSV, the schema of results and the tables
// of docs/spec.md are made from the catalogue. A new quantity is one entry in one of the
// *_quantities.cpp files.
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
#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/catalogue/value.hpp"
#include "gearwright/catalogue/value_shape.hpp"

namespace gearwright {

/// The interfaces that show a quantity.
enum Doors : unsigned {
  kJson = 1,     ///< JSON, and interfaces that read it
  kListing = 2,  ///< the tables of the terminal
  kPage = 4,     ///< the tables of the report
  kPeople = kListing | kPage,
  kAllDoors = kJson | kPeople
};

/// The meaning of a list of two values.
enum class Two {
  values,   ///< values without a special meaning
  gears,    ///< gear 1 and gear 2, each with a column
  ends,     ///< the two ends of a range
  fraction  ///< numerator and denominator
};

struct QuantityTable;

struct QuantityInfo {
  std::string key;     ///< key in JSON, with its unit: "tip_diameter_mm"
  std::string words;   ///< the term of ISO 21771 or ISO 1122-1, if one exists
  std::string symbol;  ///< "d_a", with indices after the underscore
  Unit unit = Unit::none;
  std::string group{};    ///< heading for users
  std::string meaning{};  ///< one sentence without full stop; it also states when the value exists
  Type type = Type::number;
  std::vector<int> list{};  ///< lengths of nested lists, 0 for any length; empty if the value is
                            ///< not a list
  Two two = Two::values;
  bool always = false;                ///< true if the value is never null; by default, the type of
                                      ///< the getter determines this (Shape)
  std::vector<std::string> one_of{};  ///< possible values of a word
  unsigned doors = kAllDoors;
  std::optional<int> digits{};             ///< decimals for users; by default, the decimals of the
                                           ///< unit
  std::string nothing{};                   ///< text for users if there is no value
  const QuantityTable& (*of)() = nullptr;  ///< for a record, the table of its quantities
  std::string column{};                    ///< heading in CSV and Parquet; "#" is the gear's number
  bool greater_first = false;              ///< true if greater values are better
  bool only_inch = false;                  ///< true if only results in inch show it
  bool optional_key = false;               ///< true if the key is absent when the quantity does not
                                           ///< exist; if false, the value is then null
};

/// The quantities that a record may contain, in their order.
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
  std::function<bool(const S&)> exists{};  ///< if it returns false, the key is absent; the default
                                           ///< is true
  std::function<bool(const S&)> worth{};   ///< if it returns false, users see no row; the default
                                           ///< is true
  std::function<bool(const S&)> asked{};   ///< if it returns true, a dash shows users that a value
                                           ///< is missing
  std::function<bool(const S&)> there{};   ///< for an entry of a part: true if the subject has this
                                           ///< part

  // The functions below refine an entry, in their usual order. always() states that the value is
  // never null, although the type of the getter is Value.
  Quantity& always() { return info.always = true, *this; }
  // States that the number may be missing (NaN or infinity), although the type of the getter is a
  // plain number.
  Quantity& or_null() { return info.always = false, *this; }
  Quantity& in_inch() { return info.only_inch = true, *this; }
  Quantity& digits(int n) { return info.digits = n, *this; }
  Quantity& doors(unsigned d) { return info.doors = d, *this; }
  Quantity& one_of(std::vector<std::string> w) { return info.one_of = std::move(w), *this; }
  Quantity& list(std::vector<int> l) { return info.list = std::move(l), *this; }
  Quantity& per_gear() { return info.list = {2}, info.two = Two::gears, *this; }
  Quantity& ends() { return info.list = {2}, info.two = Two::ends, *this; }
  Quantity& fraction() { return info.list = {2}, info.two = Two::fraction, *this; }
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
  // States that the value exists only if the subject has the part of this entry.
  Quantity& when() { return when(there); }
  Quantity& expected() { return expected(there); }
  Quantity& shown(std::function<bool(const S&)> f) { return worth = std::move(f), *this; }
};

/// True if T is an angle, an optional angle, or a list of angles.
template <class T>
struct HasAngles : std::is_same<T, Angle> {};
template <class T>
struct HasAngles<std::optional<T>> : HasAngles<T> {};
template <class T, std::size_t n>
struct HasAngles<std::array<T, n>> : HasAngles<T> {};
template <class T>
struct HasAngles<std::vector<T>> : HasAngles<T> {};

/// Returns angles as values in this unit, which is degrees or seconds of arc.
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

/// Returns the record of a subject, or the records of a range of subjects. The argument may also be
/// an optional or a pointer. If the argument is a finished value, it is returned unchanged.
template <class T, class R>
Value record_value(const Quantities<T>& quantities, const R& found) {
  if constexpr (std::is_same_v<R, T>) {
    return quantities.of(found);
  } else if constexpr (requires { found ? *found : *found; }) {
    return found ? record_value(quantities, *found) : Value();
  } else if constexpr (requires { requires std::is_same_v<typename R::value_type, T>; }) {
    return quantities.each(found);
  } else {
    return found;
  }
}

/// This function is used only for its return type. record_value() makes a value from the result R
/// of a getter. The return type has the same Shape (value_shape.hpp) as this value.
template <class T, class R>
auto record_shape() {
  if constexpr (std::is_same_v<R, T>) {
    return ValueRecord();
  } else if constexpr (requires(const R& found) { *found; }) {
    return Value();
  } else if constexpr (requires { requires std::is_same_v<typename R::value_type, T>; }) {
    return ValueList();
  } else {
    return R();
  }
}

/// Makes the getter of an entry. `get` is a member of S or a function of S. Angles are converted to
/// the unit of the key.
template <class S, class G>
std::function<Value(const S&)> getter(Unit unit, G get) {
  using R = std::remove_cvref_t<std::invoke_result_t<G, const S&>>;
  if constexpr (HasAngles<R>::value) {
    return [unit, get](const S& s) { return angles_in(unit, std::invoke(get, s)); };
  } else if constexpr (std::is_empty_v<G> && std::is_default_constructible_v<G>) {
    // All lambdas without captures are converted to one type, so that std::function is compiled
    // only once.
    return +[](const S& s) -> Value { return G()(s); };
  } else {
    return get;
  }
}

/// Returns the description of a quantity without its shape. The ending of the key determines the
/// unit.
QuantityInfo info_of(Type type, const char* key, const char* words, const char* symbol,
                     const char* meaning);

/// The functions that add an entry of S to `Self`. Each function adds one quantity. The ending of
/// the key determines the unit of the quantity. `symbol` may be empty.
template <class Self, class S>
class QuantityForms {
 public:
  template <class G>
  auto& add(Type type, const char* key, const char* words, const char* symbol, const char* meaning,
            G get) {
    QuantityInfo info = info_of(type, key, words, symbol, meaning);
    self().template shape<std::remove_cvref_t<std::invoke_result_t<G, const S&>>>(info);
    auto found = getter<S>(info.unit, std::move(get));
    return self().add(std::move(info), std::move(found));
  }
  template <class G>
  auto& number(const char* key, const char* words, const char* symbol, const char* meaning, G get) {
    return self().add(Type::number, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  auto& whole(const char* key, const char* words, const char* symbol, const char* meaning, G get) {
    return self().add(Type::whole, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  auto& flag(const char* key, const char* words, const char* meaning, G get) {
    return self().add(Type::flag, key, words, "", meaning, std::move(get));
  }
  template <class G>
  auto& word(const char* key, const char* words, const char* meaning, G get) {
    return self().add(Type::word, key, words, "", meaning, std::move(get));
  }
  template <class G>
  auto& text(const char* key, const char* meaning, G get) {
    return self().add(Type::text, key, key, "", meaning, std::move(get)).doors(kJson);
  }
  /// Adds a quantity that occurs in several tables. Its Term defines its words and its symbol.
  template <class G>
  auto& term(const char* key, const char* meaning, G get) {
    const Term& t = term_of(key);
    return self().add(t.type, key, t.words, t.symbol, meaning, std::move(get));
  }
  /// Adds a record of the quantities `of`, or a list of such records. `get` returns a subject, an
  /// optional subject, a pointer to a subject, a range of subjects, or a finished value. An empty
  /// optional or a null pointer is allowed. By default, `get` returns the subject S itself.
  template <const auto& (*of)(), class G = std::identity>
  auto& record(const char* key, const char* meaning, G get = {}) {
    using T = typename std::remove_cvref_t<decltype(of())>::Subject;
    using R = std::remove_cvref_t<std::invoke_result_t<G, const S&>>;
    auto& q = self().add(Type::record, key, key, "", meaning,
                         [get](const S& s) { return record_value(of(), std::invoke(get, s)); });
    self().template shape<decltype(record_shape<T, R>())>(q.info);
    q.info.of = []() -> const QuantityTable& { return of().table(); };
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
  using Subject = S;

  /// Makes the quantities of a subject. `fill` adds them in the order of the keys.
  template <class Fill>
  Quantities(std::string name, const Fill& fill) {
    fill(*this);
    table_.name = std::move(name);
    for (const Quantity<S>& q : list_) table_.list.push_back(&q.info);
  }
  Quantities(const Quantities&) = delete;  // deleted, because table_ points into list_
  Quantities& operator=(const Quantities&) = delete;

  /// Sets the headings in the order for users. Headings that are not in this list follow in the
  /// order of their first use.
  void groups(std::vector<std::string> titles) { table_.groups = std::move(titles); }

  /// Sets the heading of the quantities that follow. Before the first call, there is no heading.
  void under(const char* group) { group_ = group; }

  using QuantityForms<Quantities<S>, S>::add;
  Quantity<S>& add(QuantityInfo info, std::function<Value(const S&)> get) {
    info.group = group_;
    return list_.emplace_back(Quantity<S>{std::move(info), std::move(get)});
  }
  /// Sets the shape of a quantity whose getter returns R.
  template <class R>
  static void shape(QuantityInfo& info) {
    info.always = Shape<R>::kAlways;
    info.list = Shape<R>::list();
  }

  /// Returns an object that adds entries of a part of the subject. `find` returns the part, or null
  /// if the subject has no such part.
  template <class P>
  PartQuantities<S, P> part(const P* (*find)(const S&)) {
    return {*this, find};
  }

  const QuantityTable& table() const { return table_; }
  const std::deque<Quantity<S>>& list() const { return list_; }

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
  template <class Range>
  ValueList each(const Range& subjects) const {
    ValueList list;
    for (const auto& s : subjects) list.push_back(of(s));
    return list;
  }

 private:
  std::deque<Quantity<S>> list_;  // the addresses of entries stay valid while more are added
  QuantityTable table_;
  const char* group_ = "";
};

/// Entries for a part that only some subjects have. Such a part is, for example, one kind of pair,
/// or a result that may be absent. The getters take the part. If a subject does not have the part,
/// the value is null.
template <class S, class P>
class PartQuantities : public QuantityForms<PartQuantities<S, P>, P> {
 public:
  using Find = const P* (*)(const S&);

  PartQuantities(Quantities<S>& all, Find find) : all_(all), find_(find) {}

  using QuantityForms<PartQuantities<S, P>, P>::add;
  Quantity<S>& add(QuantityInfo info, std::function<Value(const P&)> get) {
    Quantity<S>& q =
        all_.add(std::move(info), [find = find_, get = std::move(get)](const S& subject) {
          const P* part = find(subject);
          return part ? get(*part) : Value();
        });
    q.there = [find = find_](const S& subject) { return find(subject) != nullptr; };
    return q;
  }
  /// Works like Quantities::shape(), but the value may be null, because a subject may lack the
  /// part.
  template <class R>
  static void shape(QuantityInfo& info) {
    info.list = Shape<R>::list();
  }

 private:
  Quantities<S>& all_;
  Find find_;
};

template <class S>
S subject_of(void (*fill)(Quantities<S>&));  // only declared, because only its type is used

/// Returns the quantities that the lambda `fill` adds. They are made at the first call. Every
/// lambda has its own type, so each call of define() in the code has its own quantities.
template <class Fill, class S = decltype(subject_of(+std::declval<Fill>()))>
const Quantities<S>& define(const char* name, Fill fill) {
  static_assert(std::is_empty_v<Fill>, "functions of the same type would share their quantities");
  static const Quantities<S> kAll(name, fill);
  return kAll;
}
template <auto fill, class S = decltype(subject_of(fill))>
const Quantities<S>& define(const char* name) {
  return define(name, [](Quantities<S>& q) { fill(q); });
}

/// Returns the number of decimals for users. The default is the number of the unit (unit_digits).
int digits_of(const QuantityInfo& info);

/// Returns the unit system in which an answer in `units` shows the values of this quantity. Modules
/// are in mm in both systems.
UnitSystem system_of(const QuantityInfo& info, UnitSystem units);

/// Returns a value as text for users, without its unit. If there is no value, the text is `none`. A
/// list is written as "x, y, z", two ends as "lo … hi", a fraction as "p/q", and values by name as
/// "a x, b y".
std::string text_of(const QuantityInfo& info, const Value& value, std::string_view none = "–",
                    UnitSystem units = UnitSystem::mm);

/// A row for users. It shows a quantity with one text per column, or with a single text if both
/// gears share the value.
struct TextRow {
  const QuantityInfo* info;
  std::vector<std::string> texts;
  std::string_view unit;  ///< the unit of the texts, "mm" or "in"
};

struct TextGroup {
  std::string title;
  std::vector<TextRow> rows;
};

/// Returns the table for users. The table shows several records side by side (two gears), or one
/// record with values for each gear (a pair). It contains a quantity if the interface `door` has it
/// and at least one record shows it. The quantities of inner records are also rows.
std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   UnitSystem units, std::string_view none = "–");

/// Returns the text with a capital first letter, for example "Tip diameter" for "tip diameter".
std::string capitalised(std::string words);

}  // namespace gearwright
