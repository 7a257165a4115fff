#include "gearwright/catalogue/value.hpp"

#include <algorithm>

namespace gearwright {

Value::Value() noexcept = default;
Value::Value(std::string word) : variant_(std::move(word)) {}
Value::Value(ValueList list) : variant_(std::move(list)) {}
Value::Value(ValueRecord record) : variant_(std::move(record)) {}
Value::Value(ValueMap map) : variant_(std::move(map)) {}
Value::Value(const Value& other) = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(const Value& other) = default;
Value& Value::operator=(Value&& other) noexcept = default;
Value::~Value() = default;

bool all_nothing(const Value& value) {
  const ValueList* list = value.list();
  return value.nothing() || (list && std::all_of(list->begin(), list->end(), all_nothing));
}

}  // namespace gearwright
