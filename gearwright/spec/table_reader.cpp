#include "gearwright/spec/table_reader.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/base/error.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/catalogue/key_hint.hpp"
#include "gearwright/catalogue/unit_system.hpp"

namespace gearwright {

namespace {

// The rule of a value that must be a number. A number in quotes is a text.
std::string number_rule(const Json& value) {
  const std::string text = value.is_string() ? value.get<std::string>() : std::string();
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const bool quoted = !text.empty() && end == text.c_str() + text.size();
  return quoted ? "must be a number; write it without quotes" : "must be a number";
}

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
    // A short list is shown as it was written. JSON has no words for nan and inf, so dump() is not
    // used.
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

void TableReader::check(const std::string& key, double value) const {
  const KeyRange& range = entry(key).range;
  if (!range.contains(value)) fail(key, range.sentence(value));
}

double TableReader::checked(const std::string& key, const Json& value,
                            const std::string& part) const {
  const auto reject = [&](const std::string& why) {
    if (part.empty()) fail(key, why);
    throw SpecError{{name(key) + "." + part, shown(value), why}};
  };
  const KeyRange& range = entry(key).range;
  if (!value.is_number()) reject(number_rule(value));
  const double x = value.get<double>();
  if (!std::isfinite(x)) reject("must be a finite number");
  if (!range.contains(x)) reject(range.sentence(x));
  if (std::abs(x) > kMaxInput) reject(fmt::format("must lie between -{0} and {0}", kMaxInput));
  return x;
}

std::optional<double> TableReader::number(const std::string& key) {
  const Json* value = find(key);
  return value ? std::optional(checked(key, *value)) : std::nullopt;
}

std::optional<int> TableReader::whole(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_number()) fail(key, number_rule(*value));
  const double x = value->get<double>();
  if (x != std::floor(x)) fail(key, "must be a whole number");
  check(key, x);
  if (!(std::abs(x) <= kMaxWholeInput))
    fail(key, fmt::format("must lie between -{0} and {0}", kMaxWholeInput));
  return static_cast<int>(x);
}

std::optional<std::vector<double>> TableReader::raw_numbers(const std::string& key) {
  const Key& known = entry(key);
  GW_EXPECTS(known.list.has_value());
  const Json* node = find(key);
  if (!node) return std::nullopt;
  std::vector<double> values;
  const auto take = [&](const Json& item) {
    if (!item.is_number() || !std::isfinite(item.get<double>()))
      fail(key, "must be " + form_of(known) + "; " + shown(item) + " is not a number");
    values.push_back(item.get<double>());
  };
  if (!node->is_array()) {
    take(*node);
    const std::string_view must = known.list->must;
    if (!known.list->single)
      fail(key, must.empty() ? "must be " + form_of(known) : std::string(must));
    return values;
  }
  if (node->empty()) fail(key, "is an empty list, but must be " + form_of(known));
  if (node->size() < known.list->least || node->size() > known.list->most)
    fail(key, fmt::format("has {} values, but must be {}", node->size(), form_of(known)));
  for (const Json& item : *node) take(item);
  return values;
}

std::optional<std::vector<double>> TableReader::numbers(const std::string& key) {
  const auto values = raw_numbers(key);
  if (!values) return std::nullopt;
  const Key& known = entry(key);
  const ListOrder& order = known.list->order;
  const bool out_of_order = order.strict
                                ? std::adjacent_find(values->begin(), values->end(),
                                                     std::greater_equal<>()) != values->end()
                                : !std::is_sorted(values->begin(), values->end());
  if (out_of_order && !order.sentence.empty())
    fail(key, fmt::format(fmt::runtime(order.sentence), values->front(), values->back()));
  const bool whole = known.kind == KeyKind::whole;
  for (const double v : *values) {
    if (whole && v != std::floor(v)) fail(key, "must contain only whole numbers");
    check(key, v);
    if (std::abs(v) > kMaxInput) fail(key, fmt::format("must lie between -{0} and {0}", kMaxInput));
  }
  return values;
}

std::optional<bool> TableReader::boolean(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_boolean()) fail(key, "must be true or false");
  return value->get<bool>();
}

std::optional<std::string> TableReader::text(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_string()) fail(key, "must be a text in quotes");
  return value->get<std::string>();
}

std::optional<std::string> TableReader::word(const std::string& key) {
  const std::optional<std::string> word = text(key);
  const auto& words = entry(key).words;
  if (word && std::find(words.begin(), words.end(), *word) == words.end())
    fail(key, one_of_rule(*word, {words.begin(), words.end()}));
  return word;
}

std::optional<std::vector<int>> TableReader::words(const Key& key) {
  const std::string name(key.key);
  const Json* node = find(name);
  if (!node) return std::nullopt;
  const bool list = node->is_array();
  if (!list && !key.list->single) fail(name, "must be " + form_of(key));
  if (list && node->empty())
    fail(name, key.form.empty() ? "is an empty list" : "must be " + form_of(key));
  const std::vector<std::string> known(key.words.begin(), key.words.end());
  std::vector<int> words;
  for (const Json& item : list ? *node : Json::array({*node})) {
    const std::string word = item.is_string() ? item.get<std::string>() : shown(item);
    const auto it = std::find(known.begin(), known.end(), word);
    if (it == known.end()) {
      const std::string_view meant = key.list->meant ? key.list->meant(word) : "";
      fail(name, fmt::format("unknown {}{}; {}", key.list->noun,
                             list ? " " + printable(word, 60) : "", word_hint(word, known, meant)));
    }
    const int index = static_cast<int>(it - known.begin());
    if (std::find(words.begin(), words.end(), index) != words.end())
      fail(name, fmt::format("contains {} twice", word));
    words.push_back(index);
  }
  return words;
}

std::optional<KeyValue> TableReader::value(const Key& key) {
  const std::string name(key.key);
  const auto value = [](const auto& read) {
    return read ? std::optional<KeyValue>(*read) : std::nullopt;
  };
  if (key.list) return key.kind == KeyKind::word ? value(words(key)) : value(numbers(name));
  switch (key.kind) {
    case KeyKind::number: return value(number(name));
    case KeyKind::whole: return value(whole(name));
    case KeyKind::boolean: return value(boolean(name));
    case KeyKind::text: return value(text(name));
    case KeyKind::word: {
      const auto read = word(name);
      if (!read) return std::nullopt;
      return static_cast<int>(std::find(key.words.begin(), key.words.end(), *read) -
                              key.words.begin());
    }
    case KeyKind::any: {  // a number, unless the caller reads another form of the value
      const Json* const given = find(name);
      return given && given->is_number() ? value(number(name)) : std::nullopt;
    }
    default: break;
  }
  GW_EXPECTS(false);  // not reached, because a table has no value
  return std::nullopt;
}

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
  if (key.kind == KeyKind::table) return read_tables(key, input);
  const auto given = value(key);
  if (!given) return;
  const std::string why = key.place.put(input, *given);
  if (!why.empty()) fail(std::string(key.key), why);
}

void TableReader::read_tables(const Key& key, KeyTarget input) {
  const std::string name(key.key);
  const KeyTable& inner = key.tables.front()();
  if (!key.list) {
    if (const Json* node = table(name))
      TableReader(inner, *node, this->name(name)).read_whole(key.place.part(input));
    return;
  }
  const Json* list = find(name);
  if (!list) return;
  if (!list->is_array() || list->empty() || list->size() > key.list->most)
    fail(name, fmt::format(fmt::runtime(key.list->must), key.list->most));
  int number = key.list->first;
  for (const Json& item : *list) {
    const std::string path = fmt::format("{}[{}]", this->name(name), number++);
    if (!item.is_object()) {
      throw SpecError{
          {path, "", fmt::format("must be a table with {}", fmt::join(inner.names(), ", "))}};
    }
    TableReader(inner, item, path).read_whole(key.place.part(input));
  }
}

void TableReader::read_whole(KeyTarget input) {
  read(input);
  finish();
  const auto fault = keys_.rule.fault(input, [this](std::string_view key) { return given(key); });
  if (fault) fail(std::string(fault->key), fault->why);
}

std::optional<double> TableReader::one_of(const std::string& key, const std::string& what,
                                          double cos_beta) {
  std::optional<double> value;
  std::string first;
  for (const std::string& way : keys_.ways(key)) {
    const auto given = number(way);
    if (!given) continue;
    const KeyAlias& alias = entry(way).alias;
    const double here = alias.value ? alias.value(*given, cos_beta) : *given;
    if (value && std::abs(here - *value) > kSameInput * std::abs(*value))
      fail(way, fmt::format("contradicts {}, because both keys give the {}; leave one of them out",
                            first, what));
    if (value) continue;
    value = here;
    first = way;
  }
  return value;
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
  std::optional<Error> error;
  std::vector<std::string> others;
  for (const auto& [key, value] : node_.items()) {
    if (keys_.find(key)) continue;
    const std::string where = path_.empty() ? "the file" : fmt::format("[{}]", path_);
    const std::string_view instead = not_supported(name(key));
    if (!instead.empty()) throw SpecError{{name(key), shown(value), std::string(instead)}};
    const std::string called = printable(key, 60);
    if (error) {
      others.push_back(called);
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
  constexpr std::size_t kNamed = 6;
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
      fail(name, fmt::format("only one of the keys {} and {} can be given; leave out the others",
                             fmt::join(key.excludes, ", "), name));
    }
  }
  if (!lacking_.empty()) fail_missing();
  for (const Key& key : keys_.keys) GW_ENSURES(used_.count(key.key) == 1);
}

}  // namespace gearwright
