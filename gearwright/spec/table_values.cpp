// Reads the values of a table, which are numbers, words, texts, lists, numbers by name and series.
// Each value is checked against the range and the form that its key declares.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "gearwright/base/lists.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// Returns the rule for a value that must be a number but is not. If the value is a number in
// quotes, the rule states that quotes are not allowed.
std::string number_rule(const Json& value) {
  const std::string text = value.is_string() ? value.get<std::string>() : std::string();
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  const bool quoted = !text.empty() && end == text.c_str() + text.size();
  return quoted ? "must be a number; write it without quotes" : "must be a number";
}

}  // namespace

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

std::vector<double> TableReader::listed_numbers(const Key& key, const Json& node) const {
  const std::string name(key.key);
  const KeyList& list = *key.list;
  const std::string form = plain_words(form_of(key));
  std::vector<double> values;
  if (node.is_string() && list.series) {
    values = list.series(node.get<std::string>());
    if (values.empty()) fail(name, "must be " + form);
    return values;
  }
  const auto take = [&](const Json& item) {
    if (!item.is_number() || !std::isfinite(item.get<double>()))
      fail(name, "must be " + form + "; " + shown(item) + " is not a number");
    values.push_back(item.get<double>());
  };
  const std::string must(list.must);
  if (!node.is_array()) {
    take(node);
    if (!list.single) fail(name, must.empty() ? "must be " + form : must);
    return values;
  }
  if (node.empty()) fail(name, "is an empty list, but must be " + form);
  if (node.size() < list.least || node.size() > list.most)
    fail(name, fmt::format("has {} value{}, but {}", node.size(), node.size() == 1 ? "" : "s",
                           must.empty() ? "must be " + form : must));
  for (const Json& item : node) take(item);
  return values;
}

std::optional<std::vector<double>> TableReader::numbers(const std::string& key) {
  const Key& known = entry(key);
  GW_EXPECTS(known.list.has_value());
  const Json* node = find(key);
  if (!node) return std::nullopt;
  const std::vector<double> values = listed_numbers(known, *node);
  const ListOrder& order = known.list->order;
  const bool out_of_order =
      order.strict
          ? std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) != values.end()
          : !std::is_sorted(values.begin(), values.end());
  if (out_of_order && !order.sentence.empty())
    fail(key, fmt::format(fmt::runtime(order.sentence), values.front(), values.back()));
  const bool whole = known.kind == KeyKind::whole;
  for (const double v : values) {
    if (whole && v != std::floor(v)) fail(key, "must contain only whole numbers");
    if (values.size() > 1 && !known.range.contains(v))
      fail(key, fmt::format("contains {}, but every value {}", v, known.range.sentence(v)));
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
  if (word && !is_in(*word, words)) fail(key, one_of_rule(*word, {words.begin(), words.end()}));
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
    if (is_in(index, words)) fail(name, fmt::format("contains {} twice", word));
    words.push_back(index);
  }
  return words;
}

std::optional<std::vector<std::string>> TableReader::texts(const Key& key) {
  const std::string name(key.key);
  const Json* node = find(name);
  if (!node) return std::nullopt;
  const std::string must(key.list->must), rule = must.empty() ? "must be " + form_of(key) : must;
  if (!node->is_array() && !key.list->single) fail(name, rule);
  std::vector<std::string> texts;
  for (const Json& item : node->is_array() ? *node : Json::array({*node})) {
    if (!item.is_string()) fail(name, rule);
    const std::string text = item.get<std::string>();
    // If a key requires two names, its own rule applies to equal names.
    if (key.list->single && is_in(text, texts))
      fail(name, fmt::format("contains {} twice", printable(text, 60)));
    texts.push_back(text);
  }
  if (texts.size() < key.list->least || texts.size() > key.list->most) fail(name, rule);
  return texts;
}

std::optional<KeyValue> TableReader::by_name(const Key& key) {
  const std::string name(key.key);
  const Json* node = find(name);
  if (!node) return std::nullopt;
  if (node->is_number()) return checked(name, *node);
  if (node->is_array() && key.list) return *numbers(name);
  if (!node->is_object()) fail(name, "must be " + key.form);
  const std::vector<std::string>& known = key.place.names();
  NamedNumbers named;
  for (const auto& [part, number] : node->items()) {
    if (!is_in(part, known)) {
      throw SpecError{{this->name(name) + "." + printable(part, 40), shown(number),
                       fmt::format("unknown name; the names are {}", fmt::join(known, ", "))}};
    }
    named.emplace_back(part, checked(name, number, part));
  }
  return named;
}

std::optional<KeyValue> TableReader::value(const Key& key) {
  const std::string name(key.key);
  const auto value = [](const auto& read) {
    return read ? std::optional<KeyValue>(*read) : std::nullopt;
  };
  if (key.kind == KeyKind::by_name) return by_name(key);
  if (key.list && key.kind == KeyKind::word) return value(words(key));
  if (key.list && key.kind == KeyKind::text) return value(texts(key));
  if (key.list) return value(numbers(name));
  switch (key.kind) {
    case KeyKind::number: {
      const Json* const given = key.words.empty() ? nullptr : find(name);
      if (!given || given->is_number()) return value(number_in_any_way(key));
      const std::string word = given->is_string() ? given->get<std::string>() : std::string();
      const auto at = std::find(key.words.begin(), key.words.end(), word);
      if (at == key.words.end()) fail(name, "must be " + plain_words(form_of(key)));
      return static_cast<int>(at - key.words.begin());
    }
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

std::optional<double> TableReader::number_in_any_way(const Key& key) {
  std::optional<double> value;
  std::string first, quantity = key.members().front();
  std::replace(quantity.begin(), quantity.end(), '_', ' ');
  for (const std::string& way : keys_.ways(key.key)) {
    const auto given = number(way);
    if (!given) continue;
    const KeyAlias& alias = entry(way).alias;
    const double here = alias.value ? alias.value(*given, cos_beta_) : *given;
    if (value && std::abs(here - *value) > kSameInput * std::abs(*value))
      fail(way,
           fmt::format("contradicts {}, because both keys give the {}; leave out one of the two",
                       first, quantity));
    if (value) continue;
    value = here;
    first = way;
  }
  return value;
}

}  // namespace gearwright
