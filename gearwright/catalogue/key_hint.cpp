#include "gearwright/catalogue/key_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spec_keys.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kLongest = 80;    // number of bytes of a key that are compared
constexpr std::size_t kLeastPart = 3;   // least letters of a part; shorter parts are too frequent
constexpr std::size_t kLettersOff = 4;  // at most a quarter of the letters may differ
constexpr std::size_t kSlipOff = 6;     // at most a sixth may differ in a typing error
constexpr double kLikeWords = 0.7;      // least share of words that two names must have in common
constexpr std::size_t kListed = 24;     // greatest number of keys that a message lists

struct Letter {
  std::string_view greek, latin;
};
constexpr std::array<Letter, 12> kLetters{{{"α", "alpha"},
                                           {"β", "beta"},
                                           {"δ", "delta"},
                                           {"ε", "epsilon"},
                                           {"λ", "lambda"},
                                           {"μ", "mu"},
                                           {"µ", "mu"},
                                           {"ρ", "rho"},
                                           {"Σ", "sigma"},
                                           {"σ", "sigma"},
                                           {"τ", "tau"},
                                           {"ψ", "psi"}}};

// The name of a key in the form for comparison, both with its unit and without its unit.
struct Word {
  std::string whole, bare;
};

Word word_of(std::string_view key) { return {folded(key), folded(without_unit(key))}; }

bool is_table(const Key& key) { return key.kind == KeyKind::table && key.words.empty(); }

// Compares a word with a key. Returns 3 if the word is the name of the key, 2 if it is another name
// of the key (Key::also), 1 if it is the symbol of the key, and 0 otherwise.
int likeness(const Key& key, const Word& word) {
  const std::string bare = folded(without_unit(key.key));
  if (bare == word.bare || bare == word.whole) return 3;
  for (const std::string_view also : key.also) {
    const std::string name = folded(also);
    if (name == word.whole || name == word.bare) return 2;
  }
  const std::string symbol = folded(key.symbol);
  return !symbol.empty() && (symbol == word.whole || symbol == word.bare) ? 1 : 0;
}

// The least likeness() that a call of called() requires.
enum Sure { by_symbol = 1, by_word = 2 };

// Returns the first key with the least cost, or null if no cost is less than `below`.
template <class F>
const Key* cheapest(const KeyTable& table, double below, F cost) {
  const Key* best = nullptr;
  for (const Key& key : table.keys) {
    const double now = cost(key);
    if (now >= below) continue;
    below = now;
    best = &key;
  }
  return best;
}

const Key* called(const KeyTable& table, const Word& word, Sure sure, bool tables) {
  return cheapest(table, 1 - sure, [&](const Key& key) {
    return !tables && is_table(key) ? 0 : -likeness(key, word);
  });
}

std::string joined_path(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

struct Place {
  const KeyTable* table;
  std::string path;
};

// Returns the tables below `top`, ordered by depth.
std::vector<Place> tables_below(const KeyTable& top, std::string_view path) {
  std::vector<Place> list{{&top, std::string(path)}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Place at = list[i];
    for (const Key& key : at.table->keys) {
      for (const auto part : key.tables) {
        const bool known = std::any_of(list.begin(), list.end(),
                                       [&](const Place& p) { return p.table == &part(); });
        if (!known) list.push_back({&part(), joined_path(at.path, key.key)});
      }
    }
  }
  list.erase(list.begin());
  return list;
}

// True if both units are of the same kind, such as length or angle, or if one of them is empty.
bool of_one_kind(std::string_view a, std::string_view b) {
  const auto kind = [](std::string_view unit) {
    if (unit == "mm" || unit == "um" || unit == "in") return std::string_view("length");
    if (unit == "deg" || unit == "rad" || unit == "arcsec") return std::string_view("angle");
    return unit;
  };
  return a.empty() || b.empty() || kind(a) == kind(b);
}

// Searches for a key that is called `word`, first in the tables inside `table` and then in all
// other tables. In the other tables, the unit of the key must be of the same kind as that of `name`,
// which is the key in the spec. An example of the result is "diameter_mm in [gear1.bore]". Returns
// none if there is no such key.
std::optional<std::string> called_elsewhere(const KeyTable& table, std::string_view path,
                                            std::string_view name, const Word& word) {
  const std::string_view unit = key_unit(name);
  // If `table` itself has a key of the same name, the result contains only this name.
  const auto named = [&](const Key& key, const std::string& where) {
    return table.find(key.key) ? std::string(key.key) : fmt::format("{} in [{}]", key.key, where);
  };
  for (const Place& p : tables_below(table, path)) {
    if (p.table == &measured_keys())
      continue;  // skipped, because keys of readings have the names of the measured quantities
    if (const Key* found = called(*p.table, word, by_word, false)) return named(*found, p.path);
  }
  if (path.empty()) return std::nullopt;
  // The top-level table `own`, which contains `table`, is searched first.
  const std::string_view own = path.substr(0, path.find('.'));
  std::vector<Place> all = tables_below(spec_keys(), "");
  // The short forms of drives and the table [search] use the words of the gears and the pair again.
  // They are therefore searched after all other tables, and [search] is the last one.
  for (const std::string_view repeats : {"planetary", "stage", "search"})
    std::stable_partition(all.begin(), all.end(),
                          [&](const Place& p) { return !p.path.starts_with(repeats); });
  std::stable_partition(all.begin(), all.end(), [&](const Place& p) { return p.path == own; });
  for (Place& p : all)
    if (p.table == &gear_keys() && subject_of(own).gear == 2) p.path = own;
  // A key with the same spelling and a unit precedes a key that is similar or has this symbol. A
  // single letter such as x is more often a symbol than a key.
  for (const bool same : {true, false}) {
    if (same && unit.empty()) continue;
    for (const Place& p : all) {
      if (p.path == path) continue;  // a table of another kind at the same path
      const bool outside = p.path.find('.') == std::string::npos;
      const Key* found =
          same ? p.table->find(name) : called(*p.table, word, outside ? by_symbol : by_word, false);
      if (found && of_one_kind(unit, key_unit(found->key))) return named(*found, p.path);
    }
  }
  return std::nullopt;
}

// Returns a key whose name contains the word or is contained in the word. If there are several such
// keys, the function returns the one whose length is nearest to that of the word. Returns null if
// there is no such key.
const Key* with_part(const KeyTable& table, const Word& word) {
  return cheapest(table, kLongest, [&](const Key& key) {
    const std::string name = folded(without_unit(key.key));
    const auto& [part, whole] = std::minmax(
        name, word.bare, [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const bool inside = part.size() >= kLeastPart && whole.find(part) != std::string::npos;
    return inside ? whole.size() - part.size() : kLongest;
  });
}

// Returns the key that has the greatest fraction of words in common with the name. Returns null if
// no fraction exceeds kLikeWords. For example, the key tip_relief_start_mm is returned for the name
// tip_relief_begin_mm.
const Key* of_like_words(const KeyTable& table, std::string_view name) {
  const auto words = split(name, '_');
  return cheapest(table, -kLikeWords, [&](const Key& key) {
    const auto own = split(key.key, '_');
    const auto common =
        std::count_if(own.begin(), own.end(), [&](std::string_view w) { return is_in(w, words); });
    return -static_cast<double>(common) / static_cast<double>(std::max(own.size(), words.size()));
  });
}

const Key* nearly_called(const KeyTable& table, const Word& word, std::size_t letters_off) {
  const auto off = [&](std::string_view name) {
    return edit_distance(word.bare, folded(without_unit(name)));
  };
  return cheapest(table, word.bare.size() / letters_off + 1, [&](const Key& key) {
    std::size_t least = off(key.key);
    for (const std::string_view also : key.also)
      if (folded(also).size() > kLettersOff) least = std::min(least, off(also));
    return least;
  });
}

std::string listed(const KeyTable& table) {
  std::string text;
  std::size_t count = 0;
  for (const Key& key : table.keys) {
    if (!key.in_documents && !is_table(key)) continue;
    if (++count > kListed) return text + ", …";
    text += (text.empty() ? "" : ", ") + std::string(key.key);
  }
  return text;
}

}  // namespace

std::string folded(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size();) {
    const auto it = std::find_if(kLetters.begin(), kLetters.end(), [&](const Letter& l) {
      return name.substr(i).starts_with(l.greek);
    });
    if (it != kLetters.end()) {
      text += it->latin;
      i += it->greek.size();
      continue;
    }
    const char c = name[i++];
    if (c >= 'A' && c <= 'Z') text += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) text += c;
  }
  return text;
}

std::optional<std::string> similar_key(const KeyTable& table, std::string_view path,
                                       std::string_view key) {
  const Word word = word_of(key.substr(0, kLongest));
  if (word.bare.empty()) return std::nullopt;
  if (const Key* here = called(table, word, by_symbol, true)) {
    // If the similar key is a table, a key inside this table may also be similar. In this case, the
    // function suggests the key inside the table.
    for (const auto part : here->tables) {
      if (!is_table(*here)) break;
      if (const Key* inside = called(part(), word, by_word, false))
        return fmt::format("{} in [{}]", inside->key, joined_path(path, here->key));
    }
    return std::string(here->key);
  }
  if (const Key* slip = nearly_called(table, word, kSlipOff)) return std::string(slip->key);
  if (const auto other = called_elsewhere(table, path, key, word)) return other;
  if (const Key* like = of_like_words(table, key.substr(0, kLongest)))
    return std::string(like->key);
  if (const Key* part = with_part(table, word)) return std::string(part->key);
  if (const Key* near = nearly_called(table, word, kLettersOff)) return std::string(near->key);
  return std::nullopt;
}

std::string key_hint(const KeyTable& table, std::string_view path, std::string_view key) {
  // The key may be a table at the top level of the file. Another name of a key of this table
  // precedes it.
  const bool here = called(table, word_of(key.substr(0, kLongest)), by_symbol, true) != nullptr;
  for (const Key& table_key : spec_keys().keys)
    if (!path.empty() && is_table(table_key) && table_key.key == key && !here)
      return fmt::format("[{}] is a separate table and not a part of [{}]", key, path);
  if (const auto similar = similar_key(table, path, key))
    return fmt::format("did you mean {}?", *similar);
  return "the known keys of this table are " + listed(table);
}

}  // namespace gearwright
