#include "gearwright/catalogue/key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/term.hpp"

namespace gearwright {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // rows[i % 3][j] is the distance between the first i letters of a and the first j letters of b.
  std::array<std::vector<std::size_t>, 3> rows;
  rows.fill(std::vector<std::size_t>(b.size() + 1));
  std::iota(rows[0].begin(), rows[0].end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t>& row = rows[i % 3];
    const std::vector<std::size_t>& above = rows[(i - 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], rows[(i - 2) % 3][j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

bool KeyRange::limited() const { return std::isfinite(lo) || std::isfinite(hi) || !zero; }

std::string KeyRange::sentence(double value) const {
  GW_EXPECTS(limited());
  std::string text;
  if (std::isfinite(lo) && std::isfinite(hi)) {
    text = lo_open == hi_open ? fmt::format("must lie between {} and {}", lo, hi)
           : lo_open          ? fmt::format("must be greater than {} and at most {}", lo, hi)
                              : fmt::format("must be at least {} and less than {}", lo, hi);
    if (lo_open && hi_open) text += ", the ends excluded";
  } else if (std::isfinite(lo)) {
    text = lo_open     ? fmt::format("must be greater than {}", lo)
           : lo == 0.0 ? std::string("must not be negative")
                       : fmt::format("must be at least {}", lo);
  } else if (std::isfinite(hi)) {
    text = fmt::format("must be {} {}", hi_open ? "less than" : "at most", hi);
  }
  if (!zero && (text.empty() || value == 0.0)) text = "must not be 0";
  return text + reason;
}

std::string_view key_unit(std::string_view key) {
  const std::string_view suffix = unit_suffix(unit_of(key));
  return suffix.empty() ? suffix : suffix.substr(1);
}

std::string_view without_unit(std::string_view key) {
  return key.substr(0, key.size() - unit_suffix(unit_of(key)).size());
}

namespace {

Key plain(KeyKind kind, std::string_view key, KeyPlace place, std::string_view fallback,
          std::string_view meaning) {
  const bool required = fallback == kRequired;
  return {.key = key,
          .kind = kind,
          .place = std::move(place),
          .required = required,
          .fallback = required ? std::string_view() : fallback,
          .meaning = meaning};
}

}  // namespace

Key Key::number(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
                std::string_view fallback, std::string_view meaning) {
  const KeyKind of_place = place.kind();
  const bool other = of_place == KeyKind::whole || of_place == KeyKind::by_name;
  Key k = plain(other ? of_place : KeyKind::number, key, std::move(place), fallback, meaning);
  k.symbol = symbol;
  k.range = std::move(range);
  return k;
}

Key Key::positive(std::string_view key, std::string_view symbol, KeyPlace place,
                  std::string_view fallback, std::string_view meaning) {
  return number(key, symbol, KeyRange::positive(), std::move(place), fallback, meaning);
}

Key Key::not_negative(std::string_view key, std::string_view symbol, KeyPlace place,
                      std::string_view fallback, std::string_view meaning) {
  return number(key, symbol, KeyRange::not_negative(), std::move(place), fallback, meaning);
}

Key Key::word(std::string_view key, Words words, KeyPlace place, std::string_view fallback,
              std::string_view meaning) {
  Key k = plain(KeyKind::word, key, std::move(place), fallback, meaning);
  k.words = std::move(words);
  return k;
}

Key Key::flag(std::string_view key, KeyPlace place, std::string_view fallback,
              std::string_view meaning) {
  return plain(KeyKind::boolean, key, std::move(place), fallback, meaning);
}

Key Key::text(std::string_view key, KeyPlace place, std::string_view fallback,
              std::string_view meaning) {
  return plain(KeyKind::text, key, std::move(place), fallback, meaning);
}

Key Key::part(std::string_view key, const KeyTable& (*table)(), KeyPlace place,
              std::string_view meaning) {
  return {.key = key,
          .kind = KeyKind::table,
          .place = std::move(place),
          .tables = {table},
          .in_documents = false,
          .meaning = meaning};
}

std::vector<std::string> Key::members() const {
  if (!fields.empty()) return fields;
  const std::string_view name = alias.of.empty() ? key : alias.of;
  return {std::string(without_unit(name))};
}

const Key* KeyTable::find(std::string_view name) const {
  const auto it =
      std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.key == name; });
  return it == keys.end() ? nullptr : &*it;
}

KeyTable KeyTable::only(const std::vector<std::string_view>& kept) const {
  KeyTable part{name, meaning, {}};
  for (const std::string_view key : kept) part.keys.push_back(*find(key));
  return part;
}

KeyTable KeyTable::without(const std::vector<std::string_view>& left_out) const {
  KeyTable rest{name, meaning, {}};
  for (const Key& key : keys)
    if (!is_in(key.key, left_out)) rest.keys.push_back(key);
  return rest;
}

std::vector<std::string> KeyTable::names() const {
  std::vector<std::string> names;
  for (const Key& k : keys) names.emplace_back(k.key);
  return names;
}

std::vector<std::string> KeyTable::ways(std::string_view key) const {
  std::vector<std::string> names{std::string(key)};
  for (const Key& k : keys)
    if (k.alias.of == key) names.emplace_back(k.key);
  return names;
}

std::string form_of(const Key& key) {
  if (!key.form.empty()) return key.form;
  const bool whole = key.kind == KeyKind::whole;
  if (key.list) {
    const char* const what = key.kind == KeyKind::word    ? "words"
                             : key.kind == KeyKind::text  ? "texts"
                             : key.kind == KeyKind::table ? "tables"
                             : whole                      ? "whole numbers"
                                                          : "numbers";
    const std::string list =
        key.list->least == key.list->most
            ? fmt::format("a list of {} {}", key.list->most, what)
            : fmt::format("a list of {} to {} {}", key.list->least, key.list->most, what);
    return key.list->single ? (whole ? "a whole number or " : "a number or ") + list : list;
  }
  switch (key.kind) {
    case KeyKind::number: return "a number";
    case KeyKind::whole: return "a whole number";
    case KeyKind::boolean: return "true or false";
    case KeyKind::text: return "a text in quotes";
    case KeyKind::word: return fmt::format("one of \"{}\"", fmt::join(key.words, "\", \""));
    case KeyKind::table: return "a table";
    case KeyKind::by_name:
    case KeyKind::any: break;
  }
  return "anything";
}

std::string plain_words(std::string_view meaning) {
  std::string text;
  for (std::size_t i = 0; i < meaning.size(); ++i) {
    if (meaning[i] == '`') continue;
    if (meaning.substr(i).starts_with(" [T")) {
      i = meaning.find(']', i);
      continue;
    }
    text += meaning[i];
  }
  return text;
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kLettersOff = 3;  // at most a third of the letters may differ
  constexpr std::size_t kLeastPart = 3;   // least length of a word that may be a part of another
                                          // word
  const auto small = [](std::string_view text) { return lower_case(text.substr(0, 80)); };
  const std::string given = small(word);
  std::string best;
  const auto look = [&](std::size_t below, auto letters_off) {
    if (!best.empty()) return;
    for (const std::string& k : known) {
      const std::optional<std::size_t> off = letters_off(small(k));
      if (!off || *off >= below) continue;
      below = *off;
      best = k;
    }
  };
  look(given.size() / kLettersOff + 1,
       [&](const std::string& k) { return std::optional(edit_distance(given, k)); });
  look(SIZE_MAX, [&](const std::string& k) {
    const auto& [part, whole] =
        std::minmax(given, k, [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const bool inside = part.size() >= kLeastPart && whole.find(part) != std::string::npos;
    return inside ? std::optional(whole.size() - part.size()) : std::nullopt;
  });
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string best = nearest_word(word, known);
  return best.empty() ? best : fmt::format("; did you mean {}?", best);
}

std::string one_of_rule(const std::string& word, const std::vector<std::string>& known) {
  return fmt::format("must be one of \"{}\"{}", fmt::join(known, "\", \""),
                     did_you_mean(word, known));
}

std::string word_hint(const std::string& word, const std::vector<std::string>& known,
                      std::string_view meant) {
  const std::string best = meant.empty() ? nearest_word(word, known) : std::string(meant);
  const std::string list = fmt::format("nown are {}", fmt::join(known, ", "));
  return best.empty() ? "k" + list : fmt::format("did you mean {}? K{}", best, list);
}

}  // namespace gearwright
