// The tables of results in docs/spec.md agree with the catalogue. GW_WRITE_DOCS=1 writes them
// again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/file_quantities.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/propose_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/catalogue/scattered_design_quantities.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/catalogue/testing/document_blocks.hpp"
#include "gearwright/pair/collision.hpp"

namespace gearwright {
namespace {

constexpr const char* kDocument = "docs/spec.md";

// Returns the words and the meaning of a quantity, for example "tip diameter; of the blank". If the
// value is a word, its possible values follow.
std::string meaning_of(const QuantityInfo& s) {
  std::string text = s.words == s.key ? "" : s.words;
  if (!s.meaning.empty()) text += (text.empty() ? "" : "; ") + s.meaning;
  std::string words;
  for (const std::string& w : s.one_of)
    words += fmt::format("{}`{}`", words.empty() ? "" : ", ", w);
  if (!words.empty()) text += ": " + words;
  if (s.two == Two::gears) text += s.meaning.find("per gear") == s.meaning.npos ? "; per gear" : "";
  return text;
}

// Tables with a heading of their own. Other records are described in the row that contains them.
const std::map<std::string, const QuantityTable*>& blocks() {
  static const std::map<std::string, const QuantityTable*> kBlocks{
      {"gear", &gear_quantities().table()},
      {"measure", &measure_quantities().table()},
      {"as_rack", &as_rack_quantities().table()},
      {"outline.arc", &outline_quantities().table()},
      {"pair", &pair_quantities().table()},
      {"double_helical", &double_helical_quantities().table()},
      {"rack", &rack_quantities().table()},
      {"rack_pair", &rack_pair_quantities().table()},
      {"drive", &drive_quantities().table()},
      {"drive.bodies", &drive_body_quantities().table()},
      {"drive.meshes", &drive_mesh_quantities().table()},
      {"contact", &contact_quantities().table()},
      {"contact.positions", &position_quantities().table()},
      {"compensate", &compensate_quantities().table()},
      {"propose", &propose_quantities().table()},
      {"scatter", &scatter_quantities().table()},
      {"scatter_designs", &scatter_study_quantities().table()},
      {"load", &load_quantities().table()},
      {"load.torques", &load_torque_quantities().table()},
      {"load.positions", &load_position_quantities().table()},
      {"load.points", &load_point_quantities().table()},
      {"rating", &rating_quantities().table()},
      {"fit", &fit_quantities().table()},
      {"identify", &identify_quantities().table()},
      {"search", &search_quantities().table()},
      {"search.designs", &design_quantities().table()},
      {"search.drives", &drive_search_quantities().table()},
      {"search.drives.designs", &found_drive_quantities().table()},
      {"file", &file_quantities().table()},
      {"warning", &warning_quantities().table()},
      {"drawing", &drawing_quantities().table()},
      {"verdict", &verdict_quantities().table()}};
  return kBlocks;
}

// A table describes the contents of a record only at its first occurrence.
void add_rows(std::string& text, const QuantityTable& table, const std::string& before,
              std::set<const QuantityTable*>& written) {
  for (const QuantityInfo* s : table.list) {
    if (!(s->doors & kJson)) continue;
    const std::string key = before + s->key;
    text += fmt::format("| `{}` | {} | {} | {} |\n", key, cell(s->symbol),
                        s->unit == Unit::percent ? "" : unit_text(s->unit), cell(meaning_of(*s)));
    if (s->type != Type::record) continue;
    const QuantityTable& inner = s->of();
    const bool own = std::any_of(blocks().begin(), blocks().end(),
                                 [&](const auto& b) { return b.second == &inner; });
    if (!own && written.insert(&inner).second)
      add_rows(text, inner, key + (s->list.empty() ? "." : "[]."), written);
  }
}

TEST(ResultDocument, TablesAreTheCatalogues) {
  const auto named = blocks_of(kDocument, "quantities");
  EXPECT_EQ(named.size(), blocks().size());
  for (const std::string& name : named) {
    const auto it = blocks().find(name);
    ASSERT_NE(it, blocks().end()) << name;
    std::string text = "| key | symbol | unit | meaning |\n|---|---|---|---|\n";
    std::set<const QuantityTable*> written;
    add_rows(text, *it->second, "", written);
    expect_block(kDocument, "quantities", name, text);
  }
}

// A result contains only the text of a code, so no two codes have the same text.
TEST(ResultDocument, CodesAreTheWarnings) {
  std::string text = "| code | level | meaning |\n|---|---|---|\n";
  std::set<std::string> codes;
  for (const WarningMeaning& m : warning_meanings()) {
    EXPECT_TRUE(codes.insert(m.text).second) << m.text;
    EXPECT_FALSE(std::string(m.text).empty() || std::string(m.sentence).empty());
    EXPECT_EQ(std::string(m.reason).empty(), m.severity == Severity::note) << m.text;
    const char* const level = m.severity == Severity::problem   ? "red"
                              : m.severity == Severity::caution ? "amber"
                                                                : "green";
    text += fmt::format("| `{}` | {} | {} |\n", m.text, level, cell(m.sentence));
  }
  expect_block(kDocument, "codes", "warning", text);
}

TEST(ResultDocument, CodesAreTheKindsOfErrors) {
  std::string text = "| kind | meaning |\n|---|---|\n";
  for (const FailureMeaning& m : failure_meanings())
    text += fmt::format("| `{}` | {} |\n", m.text, cell(m.sentence));
  expect_block(kDocument, "codes", "error", text);
}

TEST(ResultDocument, CausesAreTheCollisions) {
  std::string text = "| cause | meaning |\n|---|---|\n";
  for (const CauseMeaning& m : collision_causes()) {
    EXPECT_STREQ(to_string(m.cause), m.text);
    text += fmt::format("| `{}` | {} |\n", m.text, cell(m.sentence));
  }
  expect_block(kDocument, "causes", "collision", text);
}

}  // namespace
}  // namespace gearwright
