#include "gearwright/spec/unit_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

constexpr const char* kUnitsKey = "units";

// The keys of a toleranced number, whose values are in the unit of the key of the table: axial_in = { range = [-1, 1] }.
constexpr std::array<std::string_view, 2> kInUnitOfTable{"range", "offset"};

// Keys of numbers whose units depend on other keys.
constexpr std::array<std::string_view, 1> kMixed{"scatter.robust.range"};

// The members of a record that are sentences.
constexpr std::array<std::string_view, 5> kSentences{"message", "headline", "remedy", "reason",
                                                     "note"};

template <class List>
bool is_one_of(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

[[noreturn]] void fail_at(const std::string& path, const Json& value, std::string why) {
  throw SpecError{{path, shown(value), std::move(why)}};
}

// Members whose unit is that of a key or unit that another member names: { value = 8, unit = "um" }.
struct UnitMember {
  std::string_view member, named_by;
};
constexpr std::array kUnitMembers{UnitMember{"value", "unit"}, UnitMember{"x_range", "x"},
                                  UnitMember{"x_values", "x"}, UnitMember{"y_range", "y"},
                                  UnitMember{"y_values", "y"}};

const KeyUnit* named_unit(const Json& table, std::string_view key,
                          const KeyUnit* (*const unit)(std::string_view)) {
  for (const auto& [member, named_by] : kUnitMembers) {
    const auto name = key == member ? table.find(named_by) : table.end();
    if (name != table.end() && name->is_string()) return unit("_" + name->get<std::string>());
  }
  return nullptr;
}

bool names_unit(std::string_view key) {
  return std::any_of(kUnitMembers.begin(), kUnitMembers.end(),
                     [&](const UnitMember& m) { return m.named_by == key; });
}

class SpecInMm {
 public:
  explicit SpecInMm(GivenKeys& given) : given_(given) {}

  // `path` is the path in the catalogue, and `written` the path in the file.
  Json table(const Json& from, const std::string& path, const std::string& written,
             const KeyUnit* unit) {
    Json::object_t to;
    for (const auto& [key, value] : from.items()) {
      const std::string here = path.empty() ? key : path + "." + key;
      const std::string file = written.empty() ? key : written + "." + key;
      if (metric_unit(key)) refuse_mm(file, key, value);
      if (is_one_of(kMixed, file))
        fail_at(
            file, value,
            "is not supported in a spec with units = \"inch\", because it applies to corrections "
            "in "
            "different units; leave it out, or give a spec in mm");
      const std::string name = metric_key(key);
      const KeyUnit* const own = inch_unit(key);
      const KeyUnit* const inner = own ? own
                                   : unit && is_one_of(kInUnitOfTable, key)
                                       ? unit
                                       : named_unit(from, key, inch_unit);
      const std::string in_mm = own ? metric_key(here) : here;
      if (own && !value.is_object()) given_.written[in_mm] = shown(value);
      if (value.is_string() && names_unit(key)) {
        to.emplace_back(key, metric_key("_" + value.get<std::string>()).substr(1));
        continue;
      }
      to.emplace_back(name, convert(value, in_mm, file, inner, value.is_object() ? own : nullptr));
    }
    return to;
  }

 private:
  Json convert(const Json& value, const std::string& path, const std::string& written,
               const KeyUnit* unit, const KeyUnit* of_table) {
    if (value.is_object()) return table(value, path, written, of_table);
    if (value.is_array()) {
      Json list = Json::array();
      std::size_t number = 0;
      for (const Json& item : value) {
        const std::string index = fmt::format("[{}]", ++number);
        list.push_back(item.is_string()
                           ? Json(metric_key(item.get<std::string>()))
                           : convert(item, path + index, written + index, unit, nullptr));
      }
      return list;
    }
    return unit && value.is_number() ? Json(unit->to_metric(value.get<double>())) : value;
  }

  [[noreturn]] static void refuse_mm(const std::string& path, const std::string& key,
                                     const Json& value) {
    const KeyUnit& unit = *metric_unit(key);
    const std::string in_inch =
        value.is_number() ? fmt::format(" = {}", unit.to_inch(value.get<double>())) : "";
    fail_at(path, value,
            fmt::format("is not allowed in a spec with units = \"inch\"; give {}{}",
                        key_in(UnitSystem::inch, key), in_inch));
  }

  GivenKeys& given_;
};

// A path of keys, which is a word or several words joined by points.
bool is_path(std::string_view text) {
  return metric_unit(text) &&
         text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]") ==
             std::string_view::npos;
}

// A spec with two gears, a pair, a drive or a search. A branch of a result that only names one of these tables has
// other types of values.
bool is_spec(const std::string& key, const Json& value) {
  if (!value.is_object()) return false;
  const bool named = key == "spec" || key == "corrected_spec" || key == "expanded";
  return named && (value.contains("gear1") || value.contains("gear2") || value.contains("drive") ||
                   value.contains("planetary") || value.contains("stage"));
}

// `unit` is that of the nearest key with a unit, and `per` that of a table of values per length.
Json in_inch(const Json& value, const KeyUnit* unit, const KeyUnit* per) {
  if (value.is_number() && (unit || per)) {
    double x = value.get<double>();
    for (const KeyUnit* u : {unit, per})
      if (u) x = u->to_inch(x);
    return x;
  }
  if (value.is_string() && is_path(value.get_ref<const std::string&>()))
    return key_in(UnitSystem::inch, value.get_ref<const std::string&>());
  if (value.is_array()) {
    Json list = Json::array();
    for (const Json& item : value) list.push_back(in_inch(item, unit, per));
    return list;
  }
  if (!value.is_object()) return value;
  Json::object_t to;
  for (const auto& [key, item] : value.items()) {
    const KeyUnit* const own = metric_unit(key);
    const bool table_per = own && own->inverse && item.is_object();
    const KeyUnit* const named = named_unit(value, key, metric_unit);
    const bool other_unit = !own && unit_of(key) != Unit::none;
    Json made = item.is_string() && is_one_of(kSentences, key)
                    ? Json(sentence_in(UnitSystem::inch, item.get<std::string>()))
                    : in_inch(item,
                              table_per || other_unit ? nullptr
                              : own                   ? own
                              : named                 ? named
                                                      : unit,
                              table_per ? own : per);
    if (item.is_string() && names_unit(key))
      made = key_in(UnitSystem::inch, "_" + item.get<std::string>()).substr(1);
    if (is_spec(key, item)) made = spec_in(UnitSystem::inch, item);
    to.emplace_back(key_in(UnitSystem::inch, key), std::move(made));
  }
  return to;
}

}  // namespace

Json in_catalogue_units(const Json& spec, GivenKeys& given) {
  const auto units = spec.find(kUnitsKey);
  if (units == spec.end()) return spec;
  if (*units != "mm" && *units != "inch")
    fail_at(kUnitsKey, *units, "must be one of \"mm\", \"inch\"");
  Json rest = spec;
  rest.erase(kUnitsKey);
  if (*units == "mm") return rest;
  given.units = UnitSystem::inch;
  return SpecInMm(given).table(rest, "", "", nullptr);
}

Json in_units(UnitSystem units, const Json& record) {
  return units == UnitSystem::mm ? record : in_inch(record, nullptr, nullptr);
}

Json spec_in(UnitSystem units, const Json& spec) {
  if (units == UnitSystem::mm || spec.is_null() || spec.contains(kUnitsKey)) return spec;
  Json::object_t whole{{kUnitsKey, to_string(units)}};
  const Json made = in_units(units, spec);
  for (const auto& [key, value] : made.items()) whole.emplace_back(key, value);
  return whole;
}

}  // namespace gearwright
