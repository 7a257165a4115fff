#include "gearwright/spec/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace gearwright {

namespace {

constexpr double kGreatestNumber = 1e9;  // of any quantity of a spec, in its unit

// A value as a person wrote it, cut to a length that fits a sentence.
std::string show(const Json& value) {
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());  // nan and inf too
  if (value.is_object()) return "(a table)";
  if (value.is_array()) {
    // As it was written, if it is short enough for a sentence; JSON has no word for nan and inf.
    std::string list;
    for (const Json& item : value) {
      list += list.empty() ? "[" : ", ";
      list += item.is_structured() ? (item.is_array() ? "(a list)" : "(a table)") : show(item);
      if (list.size() > 60) return "(a list)";
    }
    return list.empty() ? "[]" : list + "]";
  }
  return printable(json_text(value), 60);
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::string printable(const std::string& text, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < text.size() && out.size() < most; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x20 || byte == 0x7F) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    // A whole character or nothing: its length stands in the first byte (UTF-8).
    const std::size_t length = byte < 0x80   ? 1
                               : byte < 0xC0 ? 0
                               : byte < 0xE0 ? 2
                               : byte < 0xF0 ? 3
                                             : 4;
    if (length == 0 || i + length > text.size()) {
      out += fmt::format("\\x{:02x}", byte);
      continue;
    }
    bool whole = true;
    for (std::size_t k = 1; k < length; ++k)
      whole = whole && (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    if (whole) {
      out += text.substr(i, length);
      i += length - 1;
    } else {
      out += fmt::format("\\x{:02x}", byte);
    }
  }
  return out.size() < most ? out : out + "...";
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  const std::string cut = word.substr(0, 80);
  for (const std::string& k : known) {
    const std::size_t d = edit_distance(cut, k);
    if (d < least) {
      least = d;
      best = k;
    }
  }
  return best;
}

TableReader::TableReader(const Json& node, std::string path)
    : node_(node), path_(std::move(path)) {}

void TableReader::fail(const std::string& key, const std::string& why) const {
  const auto it = node_.find(key);
  const std::string value = it == node_.end() ? "" : show(*it);
  const std::string message = value.empty() ? fmt::format("{}: {}", name(key), why)
                                            : fmt::format("{} = {}: {}", name(key), value, why);
  throw SpecError{{name(key), value, message}};
}

const Json* TableReader::find(const std::string& key) {
  known_.push_back(key);
  const auto it = node_.find(key);
  return it == node_.end() ? nullptr : &*it;
}

bool TableReader::has(const std::string& key) { return find(key) != nullptr; }

const Json* TableReader::any(const std::string& key) { return find(key); }

std::optional<double> TableReader::number(const std::string& key) {
  const Json* value = find(key);
  if (!value) return std::nullopt;
  if (!value->is_number()) fail(key, "must be a number");
  const double x = value->get<double>();
  if (!std::isfinite(x)) fail(key, "must be a finite number");
  if (std::abs(x) > kGreatestNumber)
    fail(key, fmt::format("must lie between -{0} and {0}", kGreatestNumber));
  return x;
}

std::optional<double> TableReader::positive(const std::string& key) {
  const std::optional<double> x = number(key);
  if (x && !(*x > 0.0)) fail(key, "must be greater than 0");
  return x;
}

std::optional<int> TableReader::integer(const std::string& key) {
  const std::optional<double> x = number(key);
  if (!x) return std::nullopt;
  if (*x != std::floor(*x)) fail(key, "must be a whole number");
  if (std::abs(*x) > 1e6) fail(key, "must lie between -1000000 and 1000000");
  return static_cast<int>(*x);
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

std::optional<std::string> TableReader::one_of(const std::string& key,
                                               const std::vector<std::string>& allowed) {
  const std::optional<std::string> word = text(key);
  if (word && std::find(allowed.begin(), allowed.end(), *word) == allowed.end()) {
    fail(key, fmt::format("must be one of \"{}\"", fmt::join(allowed, "\", \"")));
  }
  return word;
}

const Json* TableReader::table(const std::string& key) {
  const Json* value = find(key);
  if (value && !value->is_object()) fail(key, fmt::format("must be a table, [{}]", name(key)));
  return value;
}

void TableReader::refuse(const std::string& key, const std::string& why) {
  if (find(key)) fail(key, why);
}

void TableReader::finish() const {
  for (const auto& [key, value] : node_.items()) {
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const std::string where = path_.empty() ? "the file" : fmt::format("[{}]", path_);
    const std::string shown = printable(key, 60);
    throw SpecError{{name(shown), show(value),
                     fmt::format("{} = {}: unknown key in {}; the nearest known one is {}",
                                 name(shown), show(value), where, nearest_word(key, known_))}};
  }
}

}  // namespace gearwright
