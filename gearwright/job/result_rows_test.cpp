// Laws of the rows of the page. Laws (1) and (2) are tested for every example without tolerances
// that is no drive.
//
//   (1) each row of the listings of the gears and the pair is a row of the page: the same words,
//       symbol, values and unit
//   (2) each row has an id of its own
//   (3) the values at both ends of the tolerances are those of the JSON
#include "gearwright/job/result_rows.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

// Returns the words of a line, with one blank between them. The listing writes "-" for an absent
// value.
std::string collapsed(const std::string& line) {
  std::istringstream words(line);
  std::string text;
  for (std::string word; words >> word;)
    text += (text.empty() ? "" : " ") + (word == "–" ? std::string("-") : word);
  return text;
}

std::set<std::string> lines_of(const Json& rows) {
  std::set<std::string> lines;
  for (const Json& row : rows) {
    std::string line = row["words"].get<std::string>() + " " + row["symbol"].get<std::string>();
    for (const Json& text : row["texts"]) line += " " + text.get<std::string>();
    lines.insert(collapsed(line + " " + row["unit"].get<std::string>()));
  }
  return lines;
}

// Returns the lines of a listing with a quantity. Headings are not indented, except those of the
// columns.
std::vector<std::string> rows_in(const std::string& listing) {
  std::vector<std::string> rows;
  std::istringstream text(listing);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("  ") && line[2] != ' ') rows.push_back(collapsed(line));
  return rows;
}

SolvedJob solved_for_rows(const std::string& text) {
  return testing::taken(solve_any(testing::taken(read_spec(text, SpecFormat::toml)), Scope::pair));
}

TEST(ResultRows, contain_the_rows_of_the_listing) {
  int jobs = 0;
  for (const auto& file : std::filesystem::directory_iterator(testing::source_file("examples"))) {
    if (file.path().extension() != ".toml") continue;
    const auto spec = read_spec_file(file.path());
    if (!spec || spec->drive) continue;
    const auto job = solve_any(*spec, Scope::pair);
    if (!job || job->ends) continue;
    ++jobs;
    const Json rows = job_rows(*job, spec->units());
    const std::set<std::string> page = lines_of(rows);
    // The listings of a rack and of its pinion are two tables, each with one column.
    const std::string listing = job->rack
                                    ? listing_of(spec->units(), rack_pair_quantities(), *job->rack)
                                    : gear_listing(*job) + pair_listing(*job);
    for (const std::string& line : rows_in(listing))
      EXPECT_TRUE(page.contains(line)) << file.path() << ": " << line;  // (1)
    std::set<std::string> ids;
    for (const Json& row : rows)
      EXPECT_TRUE(ids.insert(row["id"]).second) << file.path() << ": " << row["id"];  // (2)
  }
  EXPECT_GT(jobs, 12);
}

TEST(ResultRows, have_the_ends_of_the_tolerances) {
  const SolvedJob job = solved_for_rows(
      "[gear1]\nteeth = 17\nnormal_module_mm = 2\nthickness_allowance_mm = [-0.12, -0.06]\n"
      "[gear2]\nteeth = 30\nnormal_module_mm = 2\n");
  const Json record = job_record(job);
  const auto ends = [&](const char* id) {
    for (const Json& row : job_rows(job, UnitSystem::mm))
      if (row["id"] == id) return row["ends"];
    return Json();
  };
  const auto both = [](const Json& interval) {
    const double a = interval[0], b = interval[1];
    return fixed_decimals(std::min(a, b), 4) + " … " + fixed_decimals(std::max(a, b), 4);
  };
  const Json& backlash = record["pair"]["interval"]["backlash"];
  EXPECT_EQ(ends("gears.root_diameter_mm"),  // (3)
            Json::array({both(record["gears"][0]["interval"]["root_diameter_mm"]), ""}));
  EXPECT_EQ(ends("pair.backlash.normal_mm"), Json::array({both(backlash["normal_mm"])}));
  const Json& each = backlash["circumferential_mm"];
  EXPECT_EQ(ends("pair.backlash.circumferential_mm"), Json::array({both(each[0]), both(each[1])}));
  EXPECT_EQ(ends("gears.base_diameter_mm"), Json::array({"", ""}));
}

// A rack has the second column. Quantities that the pinion also has are in one row with it.
TEST(ResultRows, have_a_column_for_the_rack) {
  const SolvedJob job = solved_for_rows(
      "[gear1]\nteeth = 12\nnormal_module_mm = 2\nprofile_shift = 0.4\n"
      "[gear2]\nform = \"rack\"\nteeth = 20\n");
  const Json rack = job_record(job)["gears"][1];
  int shared = 0;
  for (const Json& row : job_rows(job, UnitSystem::mm)) {
    if (row["id"] == "gears.length_mm") {
      EXPECT_EQ(row["texts"], Json::array({"–", fixed_decimals(rack["length_mm"], 4)}));
    }
    if (row["id"] != "gears.teeth") continue;
    EXPECT_EQ(row["texts"], Json::array({"12", "20"}));
    ++shared;
  }
  EXPECT_EQ(shared, 1);
}

// Records that are only in JSON have rows. Their words contain the name of the record.
TEST(ResultRows, have_words_that_are_clear_without_their_record) {
  const SolvedJob job = solved_for_rows(
      "[gear1]\nteeth = 17\nnormal_module_mm = 2\nhelix_angle_deg = 15\n"
      "[gear2]\nteeth = 30\nnormal_module_mm = 2\nhelix_angle_deg = -15\n");
  std::set<std::string> words;
  for (const Json& row : job_rows(job, UnitSystem::mm)) words.insert(row["words"]);
  for (const char* expected : {"distance from A, point B", "specific sliding, gear 1",
                               "sliding velocity, across teeth", "transverse module"})
    EXPECT_TRUE(words.contains(expected)) << expected;
}

}  // namespace
}  // namespace gearwright
