// A value of a result, for all interfaces: null, a flag, a number, a word, a list or a record.
//
// The getters of the catalogue return values in the unit of the key. JSON, tables, CSV, Python and
// the browser convert any value to their own types in the same way, whichever getter returned it.
#pragma once

#include <algorithm>
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
struct QuantityInfo;  // catalogue/quantity_info.hpp
struct Member;

using ValueList = std::vector<Value>;
using ValueRecord = std::vector<Member>;                      ///< in the catalogue's order
using ValueMap = std::vector<std::pair<std::string, Value>>;  ///< the names depend on the job

class Value {
 public:
  using Variant = std::variant<std::monostate, bool, long long, double, std::string, ValueList,
                               ValueRecord, ValueMap>;

  // NOLINTBEGIN(google-explicit-constructor): implicit, so that getters can return these types.
  Value() noexcept;  ///< no value, which is null in JSON
  // These constructors are defined in value.cpp, where Member is complete. clang requires this for
  // functions that may destroy the variant.
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
  template <class T>
  Value(const std::vector<T>& each) : Value(ValueList(each.begin(), each.end())) {}
  Value(const Vec2& p);
  Value(const Vec3& p);
  // NOLINTEND(google-explicit-constructor)
  // These functions are not inline, because inlining them into every getter would double the object
  // code of the catalogue.
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
  /// Returns the value as a double if it is a double or a whole number, and otherwise none.
  std::optional<double> number() const {
    if (const auto* x = std::get_if<double>(&variant_)) return *x;
    if (const auto* n = std::get_if<long long>(&variant_)) return static_cast<double>(*n);
    return std::nullopt;
  }

 private:
  Variant variant_;
};

struct Member {
  const QuantityInfo* info;  ///< points into the catalogue, which exists for the whole run of the
                             ///< program
  Value value;
  bool shown = true;  ///< true if users see a row; if there is no value, the row has a dash
};

/// Returns the member of a record for this quantity, or null if the record lacks it.
template <class Record>
auto member_for(Record& record, const QuantityInfo* info) -> decltype(&record.front()) {
  const auto it =
      std::find_if(record.begin(), record.end(), [&](const Member& m) { return m.info == info; });
  return it == record.end() ? nullptr : &*it;
}

/// True if `value` is null, or if it is a list in which every value is null.
bool all_nothing(const Value& value);

}  // namespace gearwright
