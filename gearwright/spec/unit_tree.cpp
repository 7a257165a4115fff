#include "gearwright/spec/parse_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

constexpr const char* kUnitsKey = "units";

// Keys of numbers whose units depend on other keys.
constexpr std::array<std::string_view, 1> kMixed{"scatter.robust.range"};

// The members of a record that are sentences.
constexpr std::array<std::string_view, 9> kSentences{"message", "headline",       "remedy",
                                                     "reason",  "note",           "errors",
                                                     "branch",  "safest_finding", "amounts"};

// Returns the unit of a path if its last part is a key of the catalogue, and null otherwise. A part
// that is not a key is a name that the user chose. Such a name has no unit, even if it ends in
// "_mm" like the key of a length.
const KeyUnit* declared_metric(std::string_view path) {
  return is_spec_key(path) ? metric_unit(path) : nullptr;
}

const KeyUnit* declared_inch(std::string_view path) {
  return is_spec_key(metric_key(path)) ? inch_unit(path) : nullptr;
}

[[noreturn]] void fail_at(const std::string& path, const Json& value, std::string why) {
  throw SpecError{{path, shown(value), std::move(why)}};
}

// Members whose unit is given by another member, such as `value` in { value = 8, unit = "um" }.
struct UnitMember {
  std::string_view member, named_by;
};
constexpr std::array kUnitMembers{
    UnitMember{"points", "unit"},   UnitMember{"amount", "unit"},   UnitMember{"leading", "unit"},
    UnitMember{"trailing", "unit"}, UnitMember{"value", "unit"},    UnitMember{"expected", "unit"},
    UnitMember{"expect", "unit"},   UnitMember{"x_range", "x"},     UnitMember{"x_values", "x"},
    UnitMember{"y_range", "y"},     UnitMember{"y_values", "y"},    UnitMember{"from", "key"},
    UnitMember{"to", "key"},        UnitMember{"tool", "tool_unit"}};

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

  // Converts a table to mm. `path` is its path with the keys of the catalogue, and `written` is its
  // path in the file. `unit` is the unit that the key of the table names, or null.
  Json table(const Json& from, const std::string& path, const std::string& written,
             const KeyUnit* unit) {
    Json::object_t to;
    for (const auto& [key, value] : from.items()) {
      const std::string file = written.empty() ? key : written + "." + key;
      if (declared_metric(key)) refuse_mm(file, key, value);
      if (is_in(file, kMixed))
        fail_at(file, value,
                "is not supported in a spec with units = \"inch\", because it applies to "
                "corrections in different units; leave out this key, or give a spec in mm");
      const KeyUnit* const own = declared_inch(key);
      const KeyUnit* const named = named_unit(from, key, inch_unit);
      const KeyUnit* const inner = own                        ? own
                                   : named                    ? named
                                   : is_in_unit_of_table(key) ? unit
                                                              : nullptr;
      const std::string name = own ? metric_key(key) : key;
      const std::string in_mm = path.empty() ? name : path + "." + name;
      if (inner) given_.written[in_mm] = shown(value);
      to.emplace_back(name, value.is_string() && names_unit(key)
                                ? Json(metric_word(value.get<std::string>(), file))
                                : convert(value, in_mm, file, inner));
    }
    return to;
  }

 private:
  Json convert(const Json& value, const std::string& path, const std::string& written,
               const KeyUnit* unit) {
    if (value.is_object()) return table(value, path, written, unit);
    if (value.is_array()) {
      Json list = Json::array();
      std::size_t number = 0;
      for (const Json& item : value) {
        const std::string index = fmt::format("[{}]", ++number);
        list.push_back(item.is_string()
                           ? Json(metric_word(item.get<std::string>(), written + index))
                           : convert(item, path + index, written + index, unit));
      }
      return list;
    }
    return unit && value.is_number() ? Json(unit->to_metric(value.get<double>())) : value;
  }

  // Converts a word that may be the name of a key.
  static std::string metric_word(const std::string& word, const std::string& written) {
    if (declared_metric(word)) refuse_mm(written, word, word);
    return declared_inch(word) ? metric_key(word) : word;
  }

  [[noreturn]] static void refuse_mm(const std::string& path, const std::string& key,
                                     const Json& value) {
    const std::string in_inch =
        value.is_number() ? fmt::format(" = {}", metric_unit(key)->to_inch(value.get<double>()))
                          : "";
    fail_at(path, value,
            fmt::format("is not allowed in a spec with units = \"inch\"; give {}{}",
                        key_in(UnitSystem::inch, key), in_inch));
  }

  GivenKeys& given_;
};

// True if `value` is a spec inside a result. The key alone does not show this, because other parts
// of a result may also have a key `spec`. Only a spec contains gears or a drive.
bool is_spec(const std::string& key, const Json& value) {
  if (!value.is_object()) return false;
  const bool named = key == "spec" || key == "corrected_spec" || key == "expanded";
  return named && (value.contains("gear1") || value.contains("gear2") || value.contains("drive") ||
                   value.contains("planetary") || value.contains("stage"));
}

Json sentences_in_inch(const Json& value) {
  if (value.is_string()) return sentence_in(UnitSystem::inch, value.get<std::string>());
  Json list = Json::array();
  for (const Json& sentence : value) list.push_back(sentences_in_inch(sentence));
  return list;
}

// The kind of a tree: a part of a result (record), a spec, a table of kByName, or a table of
// kShares. Keys of a spec that are not in the catalogue are names that the user chose.
enum class Tree { record, spec, by_name, shares };

// Tables of a result whose keys are names that the user chose.
constexpr std::array<std::string_view, 2> kByName{"bodies", "meshes"};

// Tables of a result whose keys are quantities and whose numbers have no unit, such as shares of a
// variance.
constexpr std::array<std::string_view, 1> kShares{"indices"};

// Returns the value with its keys and its numbers in inch. `unit` is the unit of the nearest outer
// key that has a unit, or null. If the value of an outer key is a table of values per length, `per`
// is the unit of this length.
Json in_inch(Tree tree, const Json& value, const KeyUnit* unit, const KeyUnit* per) {
  if (value.is_number() && (unit || per)) {
    double x = value.get<double>();
    for (const KeyUnit* u : {unit, per})
      if (u) x = u->to_inch(x);
    return x;
  }
  if (value.is_string() && declared_metric(value.get_ref<const std::string&>()))
    return key_in(UnitSystem::inch, value.get_ref<const std::string&>());
  if (value.is_array()) {
    Json list = Json::array();
    for (const Json& item : value) list.push_back(in_inch(tree, item, unit, per));
    return list;
  }
  if (!value.is_object()) return value;
  Json::object_t to;
  for (const auto& [key, item] : value.items()) {
    const bool chosen = tree == Tree::by_name || (tree == Tree::spec && !is_spec_key(key));
    const Tree inner = tree == Tree::spec                        ? tree
                       : is_in(key, kByName) && item.is_object() ? Tree::by_name
                       : is_in(key, kShares) && item.is_object() ? Tree::shares
                       : tree == Tree::shares                    ? tree
                                                                 : Tree::record;
    const KeyUnit* const own = chosen ? nullptr : metric_unit(key);
    const KeyUnit* const named = named_unit(value, key, metric_unit);
    const bool table_per = own && own->inverse && item.is_object();
    const KeyUnit* const of_table = chosen || is_in_unit_of_table(key) ? unit : nullptr;
    const KeyUnit* const below = table_per || inner == Tree::shares ? nullptr
                                 : own                              ? own
                                 : named                            ? named
                                                                    : of_table;
    Json made;
    if (is_spec(key, item))
      made = spec_in(UnitSystem::inch, item);
    else if (item.is_string() && names_unit(key))
      made = key_in(UnitSystem::inch, "_" + item.get<std::string>()).substr(1);
    else if (is_in(key, kSentences) &&
             (item.is_string() || (item.is_array() && !item.empty() && item[0].is_string())))
      made = sentences_in_inch(item);
    else if (item.is_string() && named)
      made = numbers_in(UnitSystem::inch, item.get<std::string>(), *named);
    else
      made = in_inch(inner, item, below, table_per ? own : per);
    to.emplace_back(own ? key_in(UnitSystem::inch, key) : key, std::move(made));
  }
  return to;
}

}  // namespace

Json in_catalogue_units(const Json& spec, GivenKeys& given) {
  const auto units = spec.find(kUnitsKey);
  if (units == spec.end()) return spec;
  if (*units != "mm" && *units != "inch")
    fail_at(kUnitsKey, *units,
            one_of_rule(units->is_string() ? units->get<std::string>() : "", {"mm", "inch"}));
  Json rest = spec;
  rest.erase(kUnitsKey);
  if (*units == "mm") return rest;
  given.units = UnitSystem::inch;
  return SpecInMm(given).table(rest, "", "", nullptr);
}

Json in_units(UnitSystem units, const Json& record) {
  return units == UnitSystem::mm ? record : in_inch(Tree::record, record, nullptr, nullptr);
}

Json spec_in(UnitSystem units, const Json& spec) {
  if (units == UnitSystem::mm || spec.is_null() || spec.contains(kUnitsKey)) return spec;
  Json::object_t whole{{kUnitsKey, to_string(units)}};
  const Json made = in_inch(Tree::spec, spec, nullptr, nullptr);
  for (const auto& [key, value] : made.items()) whole.emplace_back(key, value);
  return whole;
}

}  // namespace gearwright
