#include "gearwright/catalogue/quantity_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gearwright {

namespace {

// The values of one quantity in several records. The pointer of a record without the quantity is
// null.
struct Across {
  const QuantityInfo* info;
  std::vector<const Member*> members;
};

// Returns the quantities of all records in their common order. All records follow the order of one
// table. If one record lacks a quantity, the other records therefore give its position.
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

// Returns a key as words, without the endings "_mm" and "_per_rad". For example, returns "sliding
// velocity" for "sliding_velocity_mm_per_rad".
std::string key_words(std::string key) {
  for (const std::string_view ending : {"_per_rad", "_mm"})
    if (key.ends_with(ending)) key.erase(key.size() - ending.size());
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

// Returns the words of a quantity in the inner record `outer`. If they are not clear alone, the
// name of the record is added. They are not clear if the record is a point such as "A", if the
// quantity is a gear, or if the catalogue has only the key of the quantity and no words.
std::string words_in(const QuantityInfo* outer, const QuantityInfo& info) {
  if (!outer) return info.words;
  if (outer->key.size() == 1) return fmt::format("{}, point {}", info.words, outer->key);
  const bool gear = info.words == "gear 1" || info.words == "gear 2";
  if (info.words != info.key && !gear) return info.words;
  return key_words(outer->words) + ", " + key_words(info.words);
}

// The place of a record: an inner record, or the whole record if `info` is null.
struct Within {
  const QuantityInfo* info = nullptr;
  std::string heading, path;
};

class Rows {
 public:
  Rows(Doors door, UnitSystem units, RowRange range) : door_(door), units_(units), range_(range) {}

  void add(const std::vector<const ValueRecord*>& records, const Within& place) {
    for (const Across& a : across(records)) {
      if (!contains(a)) continue;
      const QuantityInfo& info = *a.info;
      const Within inner{&info, info.group.empty() ? place.heading : info.group,
                         place.path + (place.path.empty() ? "" : ".") + info.key};
      if (info.type == Type::record) {
        nest(a, inner);
      } else {
        group(inner.heading)
            .push_back({&info, inner.heading, inner.path, words_in(place.info, info), values(a)});
      }
    }
  }
  /// Returns the rows, sorted by their headings in the order of `titles`. Other headings follow.
  std::vector<QuantityRow> sorted(const std::vector<std::string>& titles) {
    const auto rank = [&](const std::vector<QuantityRow>& rows) {
      return std::find(titles.begin(), titles.end(), rows.front().group) - titles.begin();
    };
    std::stable_sort(groups_.begin(), groups_.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    std::vector<QuantityRow> all;
    for (auto& rows : groups_) std::move(rows.begin(), rows.end(), std::back_inserter(all));
    return all;
  }

 private:
  bool contains(const Across& a) const {
    const QuantityInfo& info = *a.info;
    const auto any = [&](const auto& test) {
      return std::any_of(a.members.begin(), a.members.end(),
                         [&](const Member* m) { return m && test(*m); });
    };
    if (info.only_inch && units_ == UnitSystem::mm) return false;
    const bool at_door = (info.doors & door_) != 0;
    if (at_door && any([](const Member& m) { return m.shown; })) return true;
    return range_ == RowRange::all &&
           (at_door || (info.type == Type::record && info.list.empty())) &&
           any([](const Member& m) { return !m.value.nothing(); });
  }
  // Adds the quantities of an inner record. The records of a list are added one after the other. If
  // there are several, each heading contains the number of its record.
  void nest(const Across& a, const Within& place) {
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
      if (longest == 1) {
        add(inner, place);
      } else {
        add(inner, {place.info, fmt::format("{} {}", place.heading, i + 1),
                    fmt::format("{}.{}", place.path, i + 1)});
      }
    }
  }
  static std::vector<Value> values(const Across& a) {
    std::vector<Value> values;
    for (const Member* m : a.members) {
      const ValueList* list = m && a.info->two == Two::gears ? m->value.list() : nullptr;
      if (list) {
        values.insert(values.end(), list->begin(), list->end());
      } else {
        values.push_back(m ? m->value : Value());
      }
    }
    return values;
  }
  std::vector<QuantityRow>& group(const std::string& title) {
    const auto it = std::find_if(groups_.begin(), groups_.end(),
                                 [&](const auto& rows) { return rows.front().group == title; });
    return it != groups_.end() ? *it : groups_.emplace_back();
  }

  Doors door_;
  UnitSystem units_;
  RowRange range_;
  std::vector<std::vector<QuantityRow>> groups_;
};

}  // namespace

std::vector<QuantityRow> quantity_rows(const QuantityTable& table,
                                       const std::vector<ValueRecord>& records, Doors door,
                                       UnitSystem units, RowRange range) {
  std::vector<const ValueRecord*> all;
  for (const ValueRecord& r : records) all.push_back(&r);
  Rows rows(door, units, range);
  rows.add(all, {});
  return rows.sorted(table.groups);
}

}  // namespace gearwright
