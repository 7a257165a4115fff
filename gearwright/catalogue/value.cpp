#include "gearwright/catalogue/value.hpp"

#include <algorithm>

namespace gearwright {

Value::Value() noexcept = default;
Value::Value(bool flag) : variant_(flag) {}
Value::Value(int whole) : variant_(static_cast<long long>(whole)) {}
Value::Value(long whole) : variant_(static_cast<long long>(whole)) {}
Value::Value(long long whole) : variant_(whole) {}
Value::Value(std::size_t whole) : variant_(static_cast<long long>(whole)) {}
Value::Value(double number) : variant_(number) {}
Value::Value(std::string word) : variant_(std::move(word)) {}
Value::Value(std::string_view word) : variant_(std::string(word)) {}
Value::Value(const char* word) : variant_(std::string(word)) {}
Value::Value(const Vec2& p) : variant_(ValueList{p.x(), p.y()}) {}
Value::Value(const Vec3& p) : variant_(ValueList{p.x(), p.y(), p.z()}) {}
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
