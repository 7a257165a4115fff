// A value of a result as every door takes it: nothing, a flag, a number, a word, a list, a record.
//
// What the catalogue's getters give, already in the unit that the key names. JSON, tables, CSV and
// later Python and the browser turn it into their own kind; none of them knows where it came from.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gearwright/base/vector.hpp"

namespace gearwright {

class Value;
struct QuantityInfo;  // catalogue/quantity.hpp
struct Member;

using ValueList = std::vector<Value>;
using ValueRecord = std::vector<Member>;                      ///< in the catalogue's order
using ValueMap = std::vector<std::pair<std::string, Value>>;  ///< by names that a job makes

class Value {
 public:
  using Variant = std::variant<std::monostate, bool, long long, double, std::string, ValueList,
                               ValueRecord, ValueMap>;

  // NOLINTBEGIN(google-explicit-constructor): a getter returns what it has.
  Value() noexcept;  ///< nothing: JSON's null
  // In value.cpp, where a Member is complete: clang wants that of whatever may destroy the variant.
  Value(bool flag);
  Value(int whole);
  Value(long whole);
  Value(long long whole);
  Value(std::size_t whole);
  Value(double number);
  Value(std::string word);
  Value(std::string_view word);
  Value(const char* word);
  Value(ValueList list);
  Value(ValueRecord record);
  Value(ValueMap map);
  template <class T>
  Value(const std::optional<T>& maybe) : Value() {
    if (maybe) *this = Value(*maybe);
  }
  template <class T, std::size_t n>
  Value(const std::array<T, n>& each) : Value(ValueList(each.begin(), each.end())) {}
  Value(const Vec2& p);
  Value(const Vec3& p);
  Value(const std::vector<double>& numbers);
  // NOLINTEND(google-explicit-constructor)
  // Out of line: inlined into every getter they double the catalogue's object code.
  Value(const Value& other);
  Value(Value&& other) noexcept;
  Value& operator=(const Value& other);
  Value& operator=(Value&& other) noexcept;
  ~Value();

  const Variant& variant() const { return variant_; }
  bool nothing() const { return std::holds_alternative<std::monostate>(variant_); }
  const ValueList* list() const { return std::get_if<ValueList>(&variant_); }
  const ValueRecord* record() const { return std::get_if<ValueRecord>(&variant_); }
  const ValueMap* map() const { return std::get_if<ValueMap>(&variant_); }
  /// The number of a double or a whole number; none of anything else.
  std::optional<double> number() const {
    if (const auto* x = std::get_if<double>(&variant_)) return *x;
    if (const auto* n = std::get_if<long long>(&variant_)) return static_cast<double>(*n);
    return std::nullopt;
  }

 private:
  Variant variant_;
};

/// One quantity of a record: what is said of it, and its value.
struct Member {
  const QuantityInfo* info;  ///< of the catalogue, which lives as long as the program
  Value value;
  bool shown = true;  ///< worth a row for people in this very record: it has a value, or is missed
};

/// Nothing anywhere in it: no value, or a list of such.
bool all_nothing(const Value& value);

}  // namespace gearwright
