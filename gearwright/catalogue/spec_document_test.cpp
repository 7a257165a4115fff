// docs/spec.md and the JSON Schema of specs agree with the key tables.
//
// GW_WRITE_DOCS=1 writes both again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/spec_keys.hpp"
#include "gearwright/catalogue/spec_schema.hpp"
#include "gearwright/catalogue/testing/document_blocks.hpp"

namespace gearwright {
namespace {

constexpr const char* kSpecDocument = "docs/spec.md";

std::string code(std::string_view text) { return fmt::format("`{}`", text); }

// "−100 000", as documents write numbers.
std::string shown(double x) {
  std::string digits = fmt::format("{}", std::abs(x));
  if (digits.find_first_of(".e") == std::string::npos && digits.size() > 4) {
    for (std::size_t at = digits.size() - 3; at > 0 && at < digits.size(); at -= 3)
      digits.insert(at, " ");
  }
  if (digits == "1e+09") digits = "10⁹";
  return (x < 0 ? "−" : "") + digits;
}

std::string shown(const KeyRange& r) {
  std::string text;
  if (std::isfinite(r.lo) && std::isfinite(r.hi) && r.lo_open == r.hi_open) {
    text = shown(r.lo) + " to " + shown(r.hi) + (r.lo_open ? ", ends excluded" : "");
  } else {
    if (std::isfinite(r.lo)) text = (r.lo_open ? "> " : "≥ ") + shown(r.lo);
    if (std::isfinite(r.hi))
      text += (text.empty() ? "" : ", ") + std::string(r.hi_open ? "< " : "≤ ") + shown(r.hi);
  }
  if (!r.zero) text += (text.empty() ? "" : ", ") + std::string("not 0");
  return text;
}

std::string shown_words(const Key& key) {
  std::string text;
  for (const std::string_view word : key.words)
    text += (text.empty() ? "" : ", ") + code(fmt::format("\"{}\"", word));
  return text;
}

std::string allowed(const Key& key) {
  const std::string range = key.range.limited() ? shown(key.range) : "";
  const auto with_range = [&](const std::string& what) {
    return what + (what.empty() || range.empty() ? "" : ", ") + range;
  };
  if (!key.form.empty()) return with_range(key.form);
  if (key.list && key.kind != KeyKind::word) return with_range(form_of(key));
  switch (key.kind) {
    case KeyKind::number: return range;
    case KeyKind::whole: return with_range("whole number");
    case KeyKind::boolean: return "`true`, `false`";
    case KeyKind::text: return "text";
    case KeyKind::word: return shown_words(key) + (key.list ? ", or a list of them" : "");
    case KeyKind::table: return key.words.empty() ? "table" : shown_words(key) + ", or a table";
    case KeyKind::by_name:
    case KeyKind::any: break;
  }
  return "";
}

std::string fallback(const Key& key) {
  if (key.required) return "required";
  const auto value = nlohmann::json::parse(key.fallback, nullptr, false);
  const bool as_in_file = !value.is_discarded() && !value.is_number();
  return as_in_file ? code(key.fallback) : std::string(key.fallback);
}

// Columns without any text are left out.
std::string markdown(const KeyTable& table) {
  std::vector<std::vector<std::string>> rows{{"key", "symbol", "meaning", "allowed", "default"}};
  for (const Key& key : table.keys) {
    if (!key.in_documents) continue;
    rows.push_back({code(key.key), cell(key.symbol), cell(key.meaning), cell(allowed(key)),
                    cell(fallback(key))});
  }
  std::string out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string rule;
    for (std::size_t c = 0; c < rows[i].size(); ++c) {
      const bool filled = std::any_of(rows.begin() + 1, rows.end(),
                                      [&](const auto& row) { return !row[c].empty(); });
      if (!filled) continue;
      out += rows[i][c].empty() ? "| " : "| " + rows[i][c] + " ";
      rule += "|---";
    }
    out += "|\n";
    if (i == 0) out += rule + "|\n";
  }
  return out;
}

TEST(SpecDocument, every_table_stands_there_as_the_catalogue_has_it) {
  const std::vector<std::string> blocks = blocks_of(kSpecDocument, "keys");
  std::size_t tables = 0;
  for (const KeyTable* table : all_key_tables()) {
    const bool any = std::any_of(table->keys.begin(), table->keys.end(),
                                 [](const Key& key) { return key.in_documents; });
    // These tables are not shown: a cutter has the keys of a gear, ranges have the keys of [errors]
    // and of modifications, and the file itself has a heading for each table.
    if (!any || table->name == "spec" || table->name == "cutter" ||
        table->name == "compensate_range" || table->name == "scatter_errors" ||
        table->name == "scatter_modifications")
      continue;
    ++tables;
    expect_block(kSpecDocument, "keys", std::string(table->name), markdown(*table));
  }
  EXPECT_EQ(blocks.size(), tables) << "a block of keys without a table";
}

TEST(SpecDocument, sees_a_key_that_changed) {
  KeyTable table = spec_keys();
  const std::string before = markdown(table);
  table.keys.front().meaning = "another sentence";
  EXPECT_NE(markdown(table), before);
}

TEST(SpecSchema, is_the_one_that_is_shipped) {
  expect_document("docs/schema/spec.schema.json", spec_schema());
}

}  // namespace
}  // namespace gearwright
