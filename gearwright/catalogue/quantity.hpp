// The catalogue of results. Each quantity and its getter are described only here.
//
//   QuantityInfo    key, words (the standard's term), symbol, unit, digits, one sentence
//   Quantity        a quantity with its getter for a subject: a gear, a pair, a contact
//   Quantities<S>   all quantities of a subject; of(subject) is the record for all interfaces
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
#include <type_traits>
#include <utility>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/quantity_info.hpp"
#include "gearwright/catalogue/term.hpp"
#include "gearwright/catalogue/value.hpp"
#include "gearwright/catalogue/value_shape.hpp"

namespace gearwright {

/// A quantity with its getter and its conditions. All of these functions take the address of the
/// subject, so that they have the same types for all subjects and are compiled once. Only
/// Quantities<S> creates them and calls them, so the address is always that of an S.
struct Quantity {
  QuantityInfo info;
  std::function<Value(const void*)> get{};
  std::function<bool(const void*)> exists{};  ///< if it returns false, the key is absent; the
                                              ///< default is true
  std::function<bool(const void*)> worth{};  ///< if it returns false, users see no row; the default
                                             ///< is true
  std::function<bool(const void*)> asked{};  ///< if it returns true, a dash shows users that a
                                             ///< value is missing
  std::function<bool(const void*)> there{};  ///< for an entry of a part: true if the subject has
                                             ///< this part
};

/// Returns a function that takes the address of an S and calls `f` with this S.
template <class S, class R, class F>
std::function<R(const void*)> on_address(F f) {
  if constexpr (std::is_empty_v<F> && std::is_default_constructible_v<F>) {
    // All lambdas without captures become the same type, for which std::function is compiled once.
    return +[](const void* s) -> R { return F()(*static_cast<const S*>(s)); };
  } else {
    return [f = std::move(f)](const void* s) -> R {
      return std::invoke(f, *static_cast<const S*>(s));
    };
  }
}

/// Refines a quantity that was just added for the subject S. The functions are listed in the order
/// in which they are usually called.
template <class S>
class QuantityEntry {
 public:
  explicit QuantityEntry(Quantity& q) : q_(&q) {}

  // States that the value is never null, although its getter returns a Value.
  QuantityEntry always() { return q_->info.always = true, *this; }
  // States that the number may be missing (NaN or ∞), although its getter returns a plain number.
  QuantityEntry or_null() { return q_->info.always = false, *this; }
  QuantityEntry in_inch() { return q_->info.only_inch = true, *this; }
  QuantityEntry digits(int n) { return q_->info.digits = n, *this; }
  QuantityEntry doors(unsigned d) { return q_->info.doors = d, *this; }
  QuantityEntry one_of(std::vector<std::string> w) { return q_->info.one_of = std::move(w), *this; }
  QuantityEntry list(std::vector<int> l) { return q_->info.list = std::move(l), *this; }
  QuantityEntry per_gear() { return two_values(Two::gears); }
  QuantityEntry ends() { return two_values(Two::ends); }
  QuantityEntry fraction() { return two_values(Two::fraction); }
  QuantityEntry unit(Unit u) { return q_->info.unit = u, *this; }
  QuantityEntry words(std::string w) { return q_->info.words = std::move(w), *this; }
  QuantityEntry column(std::string name) { return q_->info.column = std::move(name), *this; }
  QuantityEntry greater_first() { return q_->info.greater_first = true, *this; }
  QuantityEntry otherwise(std::string text) { return q_->info.nothing = std::move(text), *this; }
  template <class F>
  QuantityEntry when(F f) {
    q_->info.optional_key = true;
    return q_->exists = on_address<S, bool>(std::move(f)), *this;
  }
  template <class F>
  QuantityEntry expected(F f) {
    return q_->asked = on_address<S, bool>(std::move(f)), *this;
  }
  // States that the value exists only if the subject has the part to which the entry belongs.
  QuantityEntry when() {
    q_->info.optional_key = true;
    return q_->exists = q_->there, *this;
  }
  QuantityEntry expected() { return q_->asked = q_->there, *this; }
  template <class F>
  QuantityEntry shown(F f) {
    return q_->worth = on_address<S, bool>(std::move(f)), *this;
  }

 private:
  QuantityEntry two_values(Two two) { return q_->info.list = {2}, q_->info.two = two, *this; }

  Quantity* q_;
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

/// Angles as values in this unit, which is degrees or seconds of arc.
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

/// The record of a subject, or the records of a range of subjects. The subject or the range may be
/// optional or given by a pointer. A finished value is returned unchanged.
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

/// This function is never called, because only its return type is used. If a getter returns R, this
/// type has the same Shape (value_shape.hpp) as the value that record_value() makes from R.
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

/// The getter of an entry. `get` is a member of S or a function of S. Angles are converted to the
/// unit of the key.
template <class S, class G>
std::function<Value(const void*)> getter(Unit unit, G get) {
  if constexpr (HasAngles<std::remove_cvref_t<std::invoke_result_t<G, const S&>>>::value) {
    return [unit, get](const void* s) {
      return angles_in(unit, std::invoke(get, *static_cast<const S*>(s)));
    };
  } else {
    return on_address<S, Value>(std::move(get));
  }
}

/// The quantities of a subject of any type, in the order in which they were added.
class QuantityList {
 public:
  QuantityList() = default;
  QuantityList(const QuantityList&) = delete;  // not copied, because table_ points into list_
  QuantityList& operator=(const QuantityList&) = delete;

  /// Sets the headings in the order for users. Other headings follow in the order of first use.
  void groups(std::vector<std::string> titles) { table_.groups = std::move(titles); }

  /// Sets the heading of the quantities that follow. At first there is no heading.
  void under(const char* group) { group_ = group; }

  const QuantityTable& table() const { return table_; }

 protected:
  /// Adds a quantity without getter and shape. The ending of the key gives the unit.
  Quantity& append(Type type, const char* key, const char* words, const char* symbol,
                   const char* meaning);
  /// Sets the name of the table. No quantity may be added afterwards.
  void finish(std::string name);
  ValueRecord record_of(const void* subject) const;

  std::deque<Quantity> list_;  // the addresses of entries stay valid while more are added

 private:
  QuantityTable table_;
  const char* group_ = "";
};

/// Returns the part of a subject, or null if the subject has no such part.
using FindPart = std::function<const void*(const void*)>;

/// Replaces the getter of `q`, which takes a part, by a getter that takes the whole subject. If the
/// subject does not have the part, the value is null. Also sets Quantity::there.
void get_from_part(Quantity& q, const FindPart& find);

/// The functions that add quantities to those of S. Each function adds one quantity. Its getter
/// takes a P, which is S itself or a part of S. The ending of the key gives the unit of the
/// quantity. `symbol` may be empty.
template <class Self, class S, class P>
class QuantityForms {
 public:
  template <class G>
  QuantityEntry<S> add(Type type, const char* key, const char* words, const char* symbol,
                       const char* meaning, G get) {
    Quantity& q = self().append(type, key, words, symbol, meaning);
    q.get = getter<P>(q.info.unit, std::move(get));
    return complete<std::remove_cvref_t<std::invoke_result_t<G, const P&>>>(q);
  }
  template <class G>
  QuantityEntry<S> number(const char* key, const char* words, const char* symbol,
                          const char* meaning, G get) {
    return self().add(Type::number, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  QuantityEntry<S> whole(const char* key, const char* words, const char* symbol,
                         const char* meaning, G get) {
    return self().add(Type::whole, key, words, symbol, meaning, std::move(get));
  }
  template <class G>
  QuantityEntry<S> flag(const char* key, const char* words, const char* meaning, G get) {
    return self().add(Type::flag, key, words, "", meaning, std::move(get));
  }
  template <class G>
  QuantityEntry<S> word(const char* key, const char* words, const char* meaning, G get) {
    return self().add(Type::word, key, words, "", meaning, std::move(get));
  }
  template <class G>
  QuantityEntry<S> text(const char* key, const char* meaning, G get) {
    return self().add(Type::text, key, key, "", meaning, std::move(get)).doors(kJson);
  }
  /// Adds a quantity that occurs in several tables. The Term of its key gives its type, words and
  /// symbol.
  template <class G>
  QuantityEntry<S> term(const char* key, const char* meaning, G get) {
    const Term& t = term_of(key);
    return self().add(t.type, key, t.words, t.symbol, meaning, std::move(get));
  }
  /// Adds a record of the quantities `of`, or a list of such records. `get` returns a subject,
  /// an optional subject, a pointer to a subject, a range of subjects, or a finished value. If the
  /// optional is empty or the pointer is null, the value is null. By default, `get` returns the P
  /// itself.
  template <const auto& (*of)(), class G = std::identity>
  QuantityEntry<S> record(const char* key, const char* meaning, G get = {}) {
    using T = typename std::remove_cvref_t<decltype(of())>::Subject;
    using R = std::remove_cvref_t<std::invoke_result_t<G, const P&>>;
    Quantity& q = self().append(Type::record, key, key, "", meaning);
    q.get = [get](const void* s) {
      return record_value(of(), std::invoke(get, *static_cast<const P*>(s)));
    };
    q.info.of = []() -> const QuantityTable& { return of().table(); };
    return complete<decltype(record_shape<T, R>())>(q);
  }

 private:
  Self& self() { return static_cast<Self&>(*this); }
  /// Describes the values of a getter that returns R. A value of a part may be null, because a
  /// subject may lack the part.
  template <class R>
  QuantityEntry<S> complete(Quantity& q) {
    q.info.list = Shape<R>::list();
    if constexpr (Self::kOfPart)
      get_from_part(q, self().find());
    else
      q.info.always = Shape<R>::kAlways;
    return QuantityEntry<S>(q);
  }
};

template <class S, class P>
class PartQuantities;

template <class S>
class Quantities : public QuantityList, public QuantityForms<Quantities<S>, S, S> {
 public:
  using Subject = S;
  static constexpr bool kOfPart = false;

  /// `fill` adds the quantities in the order of the keys.
  template <class Fill>
  Quantities(std::string name, const Fill& fill) {
    fill(*this);
    finish(std::move(name));
  }

  /// Adds entries of a part of the subject. `find` returns the part, or null if there is none.
  template <class P>
  PartQuantities<S, P> part(const P* (*find)(const S&)) {
    return {*this, find};
  }

  ValueRecord of(const S& subject) const { return record_of(&subject); }
  template <class Range>
  ValueList each(const Range& subjects) const {
    ValueList list;
    for (const S& s : subjects) list.push_back(of(s));
    return list;
  }

  const std::deque<Quantity>& list() const { return list_; }
  static bool exists(const Quantity& q, const S& subject) {
    return !q.exists || q.exists(&subject);
  }
  static Value value(const Quantity& q, const S& subject) { return q.get(&subject); }

 private:
  friend class QuantityForms<Quantities<S>, S, S>;
  template <class, class>
  friend class PartQuantities;
};

/// Entries for a part that only some subjects have, for example one kind of pair, or a result that
/// may be absent. Their getters take the part. If the subject does not have the part, the value is
/// null.
template <class S, class P>
class PartQuantities : public QuantityForms<PartQuantities<S, P>, S, P> {
 public:
  static constexpr bool kOfPart = true;  // a part may have the type of the whole subject

  PartQuantities(Quantities<S>& all, const P* (*find)(const S&))
      : all_(all),
        find_([find](const void* s) -> const void* { return find(*static_cast<const S*>(s)); }) {}

 private:
  friend class QuantityForms<PartQuantities<S, P>, S, P>;
  Quantity& append(Type type, const char* key, const char* words, const char* symbol,
                   const char* meaning) {
    return all_.append(type, key, words, symbol, meaning);
  }
  const FindPart& find() const { return find_; }

  Quantities<S>& all_;
  FindPart find_;
};

template <class S>
S subject_of(void (*fill)(Quantities<S>&));  // only declared, because only its type is used

/// The quantities that the lambda `fill` adds. They are made at the first call. Every lambda has
/// its own type, so each place in the code that calls define() has its own quantities.
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

}  // namespace gearwright
