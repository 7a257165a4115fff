#include "gearwright/job/interval.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gearwright {

namespace {

// True if the values differ by more than rounding errors, which also occur in numbers that do not
// depend on the tolerance.
bool differ(double a, double b) {
  constexpr double kRounding = 1e-13;
  return std::abs(a - b) > kRounding * std::max(std::abs(a), std::abs(b));
}

Json interval_of(const Value& lower, const Value& upper) {
  const auto a = lower.number(), b = upper.number();
  if (a && b) return differ(*a, *b) ? Json{*a, *b} : Json();
  if (lower.record() && upper.record()) {
    Json inner = interval_json(*lower.record(), *upper.record());
    return inner.empty() ? Json() : inner;
  }
  const ValueList *list = lower.list(), *other = upper.list();
  if (!list || !other || list->size() != other->size()) return {};
  Json values = Json::array();
  bool any = false;
  for (std::size_t i = 0; i < list->size(); ++i) {
    if ((*list)[i].record()) return {};
    values.push_back(interval_of((*list)[i], (*other)[i]));
    any = any || !values.back().is_null();
  }
  return any ? values : Json();
}

template <class Record>
auto same_quantity(Record& record, const QuantityInfo* info) -> decltype(&record.front()) {
  const auto it =
      std::find_if(record.begin(), record.end(), [&](const Member& m) { return m.info == info; });
  return it == record.end() ? nullptr : &*it;
}

// Hides the values that are equal in both records. Returns true if any other values remain.
bool keep_differing(ValueRecord& lower, ValueRecord& upper) {
  bool any = false;
  for (Member& m : lower) {
    Member* const other = same_quantity(upper, m.info);
    bool kept = false;
    if (other && m.value.record() && other->value.record()) {
      ValueRecord a = *m.value.record(), b = *other->value.record();
      kept = keep_differing(a, b);
      m.value = std::move(a);
      other->value = std::move(b);
    } else if (other) {
      kept = !interval_of(m.value, other->value).is_null();
    }
    m.shown = m.shown && kept;
    if (other) other->shown = other->shown && kept;
    any = any || m.shown;
  }
  for (Member& m : upper) m.shown = m.shown && same_quantity(lower, m.info);
  return any;
}

}  // namespace

Json interval_json(const ValueRecord& lower, const ValueRecord& upper) {
  Json j = Json::object();
  for (const Member& m : lower) {
    const Member* other = same_quantity(upper, m.info);
    if (!other) continue;
    Json value = interval_of(m.value, other->value);
    if (!value.is_null()) j[m.info->key] = std::move(value);
  }
  return j;
}

std::vector<ValueRecord> differing(ValueRecord lower, ValueRecord upper) {
  keep_differing(lower, upper);
  return {std::move(lower), std::move(upper)};
}

}  // namespace gearwright
