#include "gearwright/catalogue/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/number_text.hpp"

namespace gearwright {

const QuantityInfo* QuantityTable::find(std::string_view key) const {
  const auto it =
      std::find_if(list.begin(), list.end(), [&](const QuantityInfo* s) { return s->key == key; });
  return it == list.end() ? nullptr : *it;
}

QuantityInfo info_of(Type type, const char* key, const char* words, const char* symbol,
                     const char* meaning) {
  const Unit unit = type == Type::record || type == Type::text ? Unit::none : unit_of(key);
  return {key, words, symbol, unit, {}, meaning, type};
}

int digits_of(const QuantityInfo& info) { return info.digits.value_or(unit_digits(info.unit)); }

UnitSystem system_of(const QuantityInfo& info, UnitSystem units) {
  const bool in_both = unit_of(info.key) != Unit::none && !metric_unit(info.key);
  return in_both ? UnitSystem::mm : units;
}

Value angles_in(Unit unit, Angle angle) {
  return unit == Unit::arcsec ? angle.arcsec() : angle.deg();
}

namespace {

// True for a small number, for example a damage, that `digits` decimals would show as zero although
// it is not zero. False for a number below 1e-9, which is a rounding error and is shown as zero.
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

namespace {

// The values of one quantity in several records. A value is null if the record lacks it.
struct Across {
  const QuantityInfo* info;
  std::vector<const Member*> members;
};

// The quantities of all records in their common order. All records have the order of one table, so
// the position of a quantity that one record lacks is known from the other records.
std::vector<Across> across(const std::vector<const ValueRecord*>& records) {
  std::vector<Across> all;
  for (std::size_t k = 0; k < records.size(); ++k) {
    std::size_t place = 0;
    if (!records[k]) continue;
    for (const Member& m : *records[k]) {
      const auto it =
          std::find_if(all.begin(), all.end(), [&](const Across& a) { return a.info == m.info; });
      if (it != all.end()) {
        it->members[k] = &m;
        place = static_cast<std::size_t>(it - all.begin()) + 1;
      } else {
        Across a{m.info, std::vector<const Member*>(records.size(), nullptr)};
        a.members[k] = &m;
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), std::move(a));
        ++place;
      }
    }
  }
  return all;
}

class Groups {
 public:
  Groups(Doors door, UnitSystem units, std::string_view none)
      : door_(door), units_(units), none_(none) {}

  void add(const std::vector<const ValueRecord*>& records, const std::string& heading) {
    for (const Across& a : across(records)) {
      const QuantityInfo& info = *a.info;
      const bool shown = std::any_of(a.members.begin(), a.members.end(),
                                     [](const Member* m) { return m && m->shown; });
      if (!(info.doors & door_) || !shown || (info.only_inch && units_ == UnitSystem::mm)) continue;
      const std::string& title = info.group.empty() ? heading : info.group;
      if (info.type == Type::record) {
        nest(a, title);
      } else {
        group(title).rows.push_back(
            {&info, texts(a), unit_text(system_of(info, units_), info.unit)});
      }
    }
  }
  std::vector<TextGroup> take() { return std::move(groups_); }

 private:
  // Adds the quantities of an inner record under the heading `title`. The records of a list are
  // added one after the other, with their numbers in the headings.
  void nest(const Across& a, const std::string& title) {
    std::size_t longest = 1;
    for (const Member* m : a.members)
      if (m && m->value.list()) longest = std::max(longest, m->value.list()->size());
    for (std::size_t i = 0; i < longest; ++i) {
      std::vector<const ValueRecord*> inner;
      for (const Member* m : a.members) {
        const ValueList* list = m ? m->value.list() : nullptr;
        const Value* v = !m                 ? nullptr
                         : !list            ? &m->value
                         : i < list->size() ? &(*list)[i]
                                            : nullptr;
        inner.push_back(v ? v->record() : nullptr);
      }
      add(inner, longest == 1 ? title : fmt::format("{} {}", title, i + 1));
    }
  }
  std::vector<std::string> texts(const Across& a) const {
    std::vector<std::string> texts;
    for (const Member* m : a.members) {
      const ValueList* list = m && a.info->two == Two::gears ? m->value.list() : nullptr;
      if (list) {
        for (const Value& v : *list) texts.push_back(text_of(*a.info, v, none_, units_));
      } else {
        texts.push_back(text_of(*a.info, m ? m->value : Value(), none_, units_));
      }
    }
    return texts;
  }
  TextGroup& group(const std::string& title) {
    const auto it = std::find_if(groups_.begin(), groups_.end(),
                                 [&](const TextGroup& g) { return g.title == title; });
    if (it != groups_.end()) return *it;
    groups_.push_back({title, {}});
    return groups_.back();
  }

  Doors door_;
  UnitSystem units_;
  std::string_view none_;
  std::vector<TextGroup> groups_;
};

}  // namespace

std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   UnitSystem units, std::string_view none) {
  std::vector<const ValueRecord*> all;
  for (const ValueRecord& r : records) all.push_back(&r);
  Groups groups(door, units, none);
  groups.add(all, "");
  std::vector<TextGroup> found = groups.take();
  const auto place = [&](const TextGroup& g) {
    return std::find(table.groups.begin(), table.groups.end(), g.title) - table.groups.begin();
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const TextGroup& a, const TextGroup& b) { return place(a) < place(b); });
  return found;
}

std::string capitalised(std::string words) {
  if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') words[0] += 'A' - 'a';
  return words;
}

}  // namespace gearwright
