#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "gearwright/base/testing/source_file.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

std::string markdown(const std::vector<Row>& rows) {
  std::string out =
      "# Accuracy ledger\n\n"
      "Each row compares a closed form, as the program computes it in double, with the same "
      "formula in 50 digits. The\n"
      "accuracy tests make this file and fail if an error exceeds the claimed one. Units: "
      "*relative* is |error|/|value|.\n"
      "*modules* is |error|/m_n, for differences that cancel (a backlash near zero, a "
      "curvature radius near the base tangent\n"
      "point) and for shifts. *of a* is |error|/a, for such differences on crossed axes. *of "
      "D* and *of r_g* are relative to\n"
      "the centre distance of a fillet and to the centrode of a gear, *of r* to the base radius of "
      "an involute or the pitch\n"
      "radius of a trochoid. *%* is for teeth under load, which have no closed form; the row names "
      "the reference. Inputs are\n"
      "seeded and the same on every machine. The last column is the worst input.\n\n"
      "| quantity | unit | claimed | measured | where | worst input |\n|---|---|---|---|---|---|\n";
  for (const Row& r : rows) {
    out += fmt::format("| `{}` | {} | {:.0e} | {:.1e} | {} | {} |\n", r.name, r.unit, r.claimed,
                       r.measured, r.where, r.worst_input);
  }
  return out;
}

namespace {

std::vector<Row> all_rows() {
  std::vector<Row> rows = involute_rows();
  for (Row& r : gear_rows()) rows.push_back(std::move(r));
  for (Row& r : mesh_rows()) rows.push_back(std::move(r));
  for (Row& r : crossed_rows()) rows.push_back(std::move(r));
  for (Row& r : chord_rows()) rows.push_back(std::move(r));
  for (Row& r : curve_rows()) rows.push_back(std::move(r));
  for (Row& r : trochoid_rows()) rows.push_back(std::move(r));
  for (Row& r : few_teeth_rows()) rows.push_back(std::move(r));
  for (Row& r : pinion_envelope_rows()) rows.push_back(std::move(r));
  for (Row& r : contact_rows()) rows.push_back(std::move(r));
  for (Row& r : load_rows()) rows.push_back(std::move(r));
  return rows;
}

std::vector<std::string> claims(const std::string& table) {
  std::vector<std::string> list;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    // Quantity, unit and claimed accuracy must agree exactly. The last digit of the measured column
    // may depend on the math library.
    std::size_t at = 0;
    for (int bar = 0; bar < 4; ++bar) at = line.find('|', at) + 1;
    list.push_back(line.substr(0, at));
  }
  return list;
}

std::string ledger_text() {
  std::ifstream file(testing::source_file("docs/accuracy.md"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Ledger, ErrorsAreWithinTheirClaims) {
  const std::vector<Row> rows = all_rows();
  for (const Row& r : rows) {
    EXPECT_LE(r.measured, r.claimed) << r.name << ": " << r.worst_input;
    EXPECT_GT(r.measured, 0.0) << r.name << ": nothing was measured";
  }
  if (const char* path = std::getenv("GW_WRITE_LEDGER")) {
    // The sections after the ledger are written by hand and are kept.
    const std::string old = ledger_text();
    const std::size_t section = old.find("\n## ");
    std::ofstream(path) << markdown(rows)
                        << (section == std::string::npos ? "" : old.substr(section));
  }
  EXPECT_EQ(claims(ledger_text()), claims(markdown(rows)))
      << "docs/accuracy.md does not match these rows; regenerate it with "
         "GW_WRITE_LEDGER=docs/accuracy.md";
}

TEST(Ledger, SeesAnErrorOfOneInTenToTheTwelve) {
  Row row{"probe", "", "relative", 1e-12, 0.0, ""};
  row.see(relative_error(1.0 + 1.1e-12, Exact(1)), "1");
  EXPECT_GT(row.measured, row.claimed);
}

}  // namespace
}  // namespace gearwright::ledger
