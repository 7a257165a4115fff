#include "gearwright/catalogue/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/quantity_rows.hpp"

namespace gearwright {

const QuantityInfo* QuantityTable::find(std::string_view key) const {
  const auto it =
      std::find_if(list.begin(), list.end(), [&](const QuantityInfo* s) { return s->key == key; });
  return it == list.end() ? nullptr : *it;
}

Quantity& QuantityList::append(Type type, const char* key, const char* words, const char* symbol,
                               const char* meaning) {
  QuantityInfo& info = list_.emplace_back().info;
  info.key = key;
  info.words = words;
  info.symbol = symbol;
  info.unit = type == Type::record || type == Type::text ? Unit::none : unit_of(key);
  info.group = group_;
  info.meaning = meaning;
  info.type = type;
  return list_.back();
}

void QuantityList::finish(std::string name) {
  table_.name = std::move(name);
  for (const Quantity& q : list_) table_.list.push_back(&q.info);
}

ValueRecord QuantityList::record_of(const void* subject) const {
  ValueRecord record;
  record.reserve(list_.size());
  for (const Quantity& q : list_) {
    if (q.exists && !q.exists(subject)) continue;
    Value value = q.get(subject);
    const bool row =
        (!q.worth || q.worth(subject)) && (!all_nothing(value) || (q.asked && q.asked(subject)));
    record.push_back({&q.info, std::move(value), row});
  }
  return record;
}

void get_from_part(Quantity& q, const FindPart& find) {
  q.get = [find, get = std::move(q.get)](const void* subject) {
    const void* part = find(subject);
    return part ? get(part) : Value();
  };
  q.there = [find](const void* subject) { return find(subject) != nullptr; };
}

int digits_of(const QuantityInfo& info) { return info.digits.value_or(unit_digits(info.unit)); }

UnitSystem system_of(const QuantityInfo& info, UnitSystem units) {
  // Users of an inch spec see masses in lb, although the keys of masses end in "_kg".
  const bool in_both =
      unit_of(info.key) != Unit::none && info.unit != Unit::kg && !metric_unit(info.key);
  return in_both ? UnitSystem::mm : units;
}

Value angles_in(Unit unit, Angle angle) {
  return unit == Unit::arcsec ? angle.arcsec() : angle.deg();
}

namespace {

// True if x is not zero, but `digits` decimals would show it as zero. An example is a small damage.
// If the magnitude of x is at most 1e-9, x is a rounding error, and the result is false.
bool rounds_to_zero(double x, int digits) {
  return std::abs(x) > 1e-9 && std::abs(x) < 0.5 * std::pow(10.0, -digits);
}

}  // namespace

std::string text_of(const QuantityInfo& info, const Value& value, std::string_view none,
                    UnitSystem units) {
  const std::string absent(info.nothing.empty() ? none : std::string_view(info.nothing));
  if (all_nothing(value)) return absent;
  if (const ValueList* list = value.list()) {
    if (info.two == Two::fraction && list->back().number() == 1.0)
      return text_of(info, list->front(), none, units);
    std::string text;
    for (const Value& v : *list)
      text += (text.empty()                ? ""
               : info.two == Two::ends     ? " … "
               : info.two == Two::fraction ? "/"
                                           : ", ") +
              text_of(info, v, none, units);
    return text;
  }
  if (const ValueMap* map = value.map()) {
    std::string text;
    for (const auto& [name, v] : *map)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, text_of(info, v, none, units));
    return text.empty() ? absent : text;
  }
  if (const auto* flag = std::get_if<bool>(&value.variant())) return *flag ? "yes" : "no";
  if (const auto* whole = std::get_if<long long>(&value.variant()))
    return fmt::format("{}", *whole);
  if (const auto* word = std::get_if<std::string>(&value.variant())) {
    std::string text = *word;
    // An identifier such as "beyond_tip" is printed as two words.
    if (!info.one_of.empty()) std::replace(text.begin(), text.end(), '_', ' ');
    return text;
  }
  if (const auto* x = std::get_if<double>(&value.variant())) {
    if (!std::isfinite(*x)) return absent;
    if (info.unit == Unit::percent) return fixed_decimals(100 * *x, digits_of(info));
    if (info.unit == Unit::none && rounds_to_zero(*x, digits_of(info)))
      return fmt::format("{:.1e}", *x);
    return text_in(system_of(info, units), info.unit, *x, digits_of(info));
  }
  return absent;
}

std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   UnitSystem units, std::string_view none) {
  std::vector<TextGroup> groups;
  for (const QuantityRow& row : quantity_rows(table, records, door, units)) {
    if (groups.empty() || groups.back().title != row.group) groups.push_back({row.group, {}});
    const QuantityInfo& info = *row.info;
    TextRow& made = groups.back().rows.emplace_back(
        TextRow{&info, {}, unit_text(system_of(info, units), info.unit)});
    for (const Value& v : row.values) made.texts.push_back(text_of(info, v, none, units));
  }
  return groups;
}

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] += 'A' - 'a';
  return words;
}

}  // namespace gearwright
