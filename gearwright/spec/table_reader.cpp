#include "gearwright/spec/table_reader.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/error.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/key_hint.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

namespace {

Error absent_key(std::string name, const Key& key) {
  const std::string may_be = key.form.empty() ? "" : ". The value may be " + key.form;
  return absent_input(std::move(name), ": " + plain_words(key.meaning) + may_be);
}

}  // namespace

bool has_any(const Json& table, const std::vector<std::string>& keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return table.contains(key); });
}

std::string shown(const Json& value) {
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());  // also nan and inf
  if (value.is_object()) return "(a table)";
  if (value.is_array()) {
    // A short list is shown as written. JSON has no words for nan and inf, so dump() is not used.
    std::string list;
    for (const Json& item : value) {
      list += list.empty() ? "[" : ", ";
      list += item.is_structured() ? (item.is_array() ? "(a list)" : "(a table)") : shown(item);
      if (list.size() > 60) return "(a list)";
    }
    return list.empty() ? "[]" : list + "]";
  }
  return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace), 60);
}

TableReader::TableReader(const KeyTable& keys, const Json& node, std::string path)
    : keys_(keys), node_(node), path_(std::move(path)) {}

void TableReader::fail(const std::string& key, const std::string& why) const {
  const auto it = node_.find(key);
  const std::string value = it == node_.end() ? "" : shown(*it);
  const std::string_view instead =
      value.empty() ? std::string_view() : not_supported(name(key), value);
  throw SpecError{Error{name(key), value, instead.empty() ? why : std::string(instead)}};
}

void TableReader::fail_absent(const std::string& key, std::string_view rest) const {
  const Error error = absent_input(name(key), rest);
  throw SpecError{error, {error}};
}

const Key& TableReader::entry(const std::string& key) const {
  const Key* known = keys_.find(key);
  GW_EXPECTS(known != nullptr);
  return *known;
}

const Json* TableReader::find(const std::string& key) {
  used_.insert(std::string(entry(key).key));
  const auto it = node_.find(key);
  return it == node_.end() ? nullptr : &*it;
}

bool TableReader::has(const std::string& key) { return find(key) != nullptr; }

const Json* TableReader::any(const std::string& key) { return find(key); }

void TableReader::lacks_one_of(const std::string& key, const std::string& what) {
  lacking_.push_back(
      absent_input(name(key), fmt::format("; give the {}, for example {} = 2 (possible keys: {})",
                                          what, key, fmt::join(keys_.ways(key), ", "))));
}

void TableReader::read(KeyTarget input) {
  for (const bool tables : {false, true}) {
    for (const Key& key : keys_.keys)
      if (key.place && (key.kind == KeyKind::table) == tables) read(key, input);
  }
}

void TableReader::read(const Key& key, KeyTarget input) {
  if (key.kind == KeyKind::table && key.list && key.list->numbers) return read_ends(key, input);
  if (key.kind == KeyKind::table) return read_tables(key, input);
  const auto given = value(key);
  if (!given) return;
  const std::string why = key.place.put(input, *given);
  if (!why.empty()) fail(std::string(key.key), why);
}

// Reads two numbers, or a table that contains them.
void TableReader::read_ends(const Key& key, KeyTarget input) {
  const std::string name(key.key);
  const Json* node = find(name);
  if (!node) return;
  if (node->is_array()) {
    key.place.put(input, *numbers(name));
  } else if (node->is_object()) {
    const KeyTable& inner = key.tables.front()();
    TableReader(inner, *node, this->name(name)).read_whole(key.place.part(input));
    for (const Json& end : (*node)[std::string(inner.shorthand)]) check(name, end.get<double>());
  } else {
    const bool tolerance = node->is_number() && node->get<double>() > 0.0;
    fail(name,
         std::string(key.list->must) +
             (tolerance ? fmt::format("; a tolerance of ±{0} is [-{0}, {0}]", shown(*node)) : ""));
  }
}

void TableReader::read_tables(const Key& key, KeyTarget input) {
  const std::string name(key.key);
  const KeyTable& inner = key.tables.front()();
  if (!key.list) {
    if (const Json* node = table(name))
      TableReader(inner, *node, this->name(name)).read_whole(key.place.part(input));
    return;
  }
  for (const auto& [path, node] : tables(name))
    TableReader(inner, *node, path).read_whole(key.place.part(input));
}

std::vector<std::pair<std::string, const Json*>> TableReader::tables(const std::string& key) {
  std::vector<std::pair<std::string, const Json*>> tables;
  const Json* list = find(key);
  if (!list) return tables;
  const Key& known = entry(key);
  if (!list->is_array() || list->empty() || list->size() > known.list->most)
    fail(key, fmt::format(fmt::runtime(known.list->must), known.list->most));
  int number = known.list->first;
  for (const Json& item : *list) {
    const std::string path = fmt::format("{}[{}]", name(key), number++);
    if (!item.is_object()) {
      constexpr std::size_t kNamed = 8;
      const std::vector<std::string> names = known.tables.front()().names();
      throw SpecError{{path, shown(item),
                       names.size() > kNamed
                           ? fmt::format("must be a table, [[{}]]", name(key))
                           : fmt::format("must be a table with {}", fmt::join(names, ", "))}};
    }
    tables.emplace_back(path, &item);
  }
  return tables;
}

void TableReader::read_whole(KeyTarget input) {
  read(input);
  finish();
  const auto fault = keys_.rule.fault(input, [this](std::string_view key) { return given(key); });
  if (fault && fault->missing) fail_absent(fault->key, fault->why);
  if (fault) fail(fault->key, fault->why);
}

const Json* TableReader::table(const std::string& key) {
  const Json* value = find(key);
  if (value && !value->is_object()) fail(key, fmt::format("must be a table, [{}]", name(key)));
  return value;
}

void TableReader::refuse(const std::string& key, const std::string& why) {
  if (find(key)) fail(key, why);
}

bool TableReader::given(std::string_view key) const { return node_.contains(std::string(key)); }

void TableReader::refuse_unknown() const {
  constexpr std::size_t kNamed = 6;  // greatest number of further keys that a message names
  std::optional<Error> error;
  std::vector<std::string> others;
  for (const auto& [key, value] : node_.items()) {
    if (keys_.find(key)) continue;
    const std::string where = path_.empty() ? "the file" : fmt::format("[{}]", path_);
    const std::string_view instead = not_supported(name(key));
    if (!instead.empty()) throw SpecError{{name(key), shown(value), std::string(instead)}};
    const std::string called = key.empty() ? "\"\"" : printable(key, 60);
    if (error) {
      // Comparisons are limited to the keys that the message names.
      const auto similar =
          others.size() < kNamed ? similar_key(keys_, path_, key) : std::optional<std::string>();
      others.push_back(similar ? fmt::format("{} ({}?)", called, *similar) : called);
    } else {
      const KeyUnit* const inch = keys_.find(metric_key(key)) ? inch_unit(key) : nullptr;
      const std::string hint =
          !inch
              ? key_hint(keys_, path_, key)
              : fmt::format(
                    "did you mean {}{}? A length in inch needs units = \"inch\" at the "
                    "top of the spec",
                    metric_key(key),
                    value.is_number()
                        ? fmt::format(" = {}", format_number(inch->to_metric(value.get<double>())))
                        : std::string());
      error = Error{name(called), shown(value), fmt::format("unknown key in {}; {}", where, hint)};
    }
  }
  if (!error) return;
  const bool more = others.size() > kNamed;
  if (more) others.resize(kNamed);
  if (!others.empty())
    error->rule +=
        fmt::format("; also unknown here: {}{}", fmt::join(others, ", "), more ? ", …" : "");
  throw SpecError{*error};
}

void TableReader::fail_missing() const {
  std::vector<Error> all;
  for (const Key& key : keys_.keys) {
    const std::string absent(key.key);
    if (key.required && !given(absent)) all.push_back(absent_key(name(absent), key));
  }
  all.insert(all.end(), lacking_.begin(), lacking_.end());
  throw SpecError{all_missing(all), all};
}

void TableReader::require_all() const {
  for (const Key& key : keys_.keys) {
    if (!key.required || given(key.key)) continue;
    refuse_unknown();
    fail_missing();
  }
}

void TableReader::finish() const {
  refuse_unknown();
  for (const Key& key : keys_.keys) {
    const std::string name(key.key);
    if (!given(name)) {
      if (key.required) fail_missing();
      continue;
    }
    for (const std::string_view other : key.needs) {
      if (given(other)) continue;
      const Key& wanted = *keys_.find(other);
      const auto it = node_.find(name);
      throw SpecError{{this->name(name), shown(*it),
                       fmt::format("also needs {}: {}", other, plain_words(wanted.meaning))},
                      {absent_key(this->name(std::string(other)), wanted)}};
    }
    for (const std::string_view other : key.excludes) {
      if (!given(other)) continue;
      if (!key.excludes_why.empty()) fail(name, std::string(key.excludes_why));
      fail(name, fmt::format("only one of the keys {} and {} can be given; leave out the others",
                             fmt::join(key.excludes, ", "), name));
    }
  }
  if (!lacking_.empty()) fail_missing();
  for (const Key& key : keys_.keys) GW_ENSURES(used_.count(key.key) == 1);
}

}  // namespace gearwright
