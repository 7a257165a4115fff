// Laws of the verdict, over seeded specs such as a user writes.
//
// (1) The change in a remedy, applied to the spec, removes its finding and makes no other one
//     worse.
// (2) No combination of tolerance ends has a worse level than the verdict. A negative backlash at
//     tolerance ends has the least value of all combinations.
// (3) `pair` and `contact` judge the gears in the same way. The level of `contact` is not better.
// (4) Ordinary pairs are green.
// (5) An amber headline about one gear names this gear.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "gearwright/job/verbs.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

// Null means that these gears cannot be mounted.
Json verdict_of(std::string_view verb, const Json& spec) {
  const auto read = read_spec(json_text(spec), SpecFormat::json);
  if (!read) return {};
  const auto answer = answer_json(verb, *read);
  return answer ? (*answer)["verdict"] : Json();
}

int rank(const Json& level) { return level == "red" ? 2 : level == "amber" ? 1 : 0; }

// The worst level of each code and gear.
std::map<std::string, int> levels_of(const Json& verdict) {
  std::map<std::string, int> levels;
  for (const Json& f : verdict["findings"]) {
    int& level = levels[f["code"].get<std::string>() + " " + f["gear"].dump()];
    level = std::max(level, rank(f["level"]));
  }
  return levels;
}

// Sets a path such as "gear1.modifications.lead_crowning_um" in a spec.
void set(Json& spec, std::string path, const Json& value) {
  std::replace(path.begin(), path.end(), '.', '/');
  spec[Json::json_pointer("/" + path)] = value;
}

double rounded(double x, double step) { return std::round(x / step) * step; }

// Input that a user might write: small gears, large shifts, unsuitable distances, long tips.
Json random_job(Random& random) {
  const double m = random.pick({0.8, 1.0, 2.0, 2.5, 5.0, 12.0});
  const bool ring = random.chance(0.15);
  const double beta = random.chance(0.4) ? rounded(random.uniform(5, 30), 0.5) : 0.0;
  const int z1 = random.integer(6, 45);
  const int z2 = ring ? -(z1 + random.integer(8, 60)) : random.integer(12, 90);
  Json g1{{"teeth", z1},
          {"normal_module_mm", m},
          {"face_width_mm", rounded(m * random.uniform(2, 14), 0.1)}};
  Json g2{{"teeth", z2}, {"face_width_mm", g1["face_width_mm"]}};
  if (beta != 0.0) {
    g1["helix_angle_deg"] = beta;
    g2["helix_angle_deg"] = ring ? beta : -beta;
  }
  for (Json* g : {&g1, &g2}) {
    if (random.chance(0.5)) (*g)["profile_shift"] = rounded(random.uniform(-0.5, 0.9), 0.01);
    if (random.chance(0.3))
      (*g)["thickness_allowance_mm"] = -rounded(0.05 * m * random.unit(), 0.001);
    if (random.chance(0.15)) {
      const double d =
          m / std::cos(beta * std::numbers::pi / 180) * std::abs((*g)["teeth"].get<int>());
      (*g)["tip_diameter_mm"] =
          rounded(d + (g == &g2 && ring ? -2 : 2) * m * random.uniform(0.8, 1.4), 0.01);
    }
  }
  if (random.chance(0.15))
    g1["bore"] = {{"diameter_mm", rounded(m * z1 * random.uniform(0.3, 0.95), 0.1)}};
  Json spec{{"gear1", g1}, {"gear2", g2}};
  if (random.chance(0.5)) {
    const double a_d =
        m / std::cos(beta * std::numbers::pi / 180) * std::abs(ring ? -z2 - z1 : z1 + z2) / 2;
    spec["pair"]["center_distance_mm"] = rounded(a_d + m * random.uniform(-0.4, 0.9), 0.05);
  }
  return spec;
}

struct RemedyCount {
  int judged = 0, findings = 0, remedies = 0, of_a_gear = 0;
};

// (5): the first finding is the one in the headline.
bool names_its_gear(const Json& verdict, RemedyCount& count) {
  const Json& first = verdict["findings"][0];
  if (verdict["level"] != "amber" || !first["gear"].is_number() || !first["at"].is_null())
    return true;
  ++count.of_a_gear;
  const std::string headline = verdict["headline"];
  const std::string number = std::to_string(first["gear"].get<int>());
  return headline.find("ear " + number) != std::string::npos ||
         headline.find("gear" + number) != std::string::npos;
}

RemedyCount remedies_hold(std::uint64_t seed, int wanted) {
  Random random(seed);
  RemedyCount count;
  while (count.judged < wanted && !::testing::Test::HasFailure()) {
    const Json spec = random_job(random);
    const Json before = verdict_of("pair", spec);
    if (before.is_null() || before["level"] == "green") continue;
    ++count.judged;
    EXPECT_TRUE(names_its_gear(before, count)) << spec.dump() << "\n" << before.dump();
    const auto had = levels_of(before);
    for (const Json& f : before["findings"]) {
      if (f["level"] == "green") continue;
      ++count.findings;
      if (f["change"].empty()) continue;
      ++count.remedies;
      Json changed = spec;
      for (const auto& [key, value] : f["change"].items()) set(changed, key, value);
      const Json after = verdict_of("pair", changed);
      const std::string what = spec.dump() + "\n" + f.dump() + "\n" + after.dump();
      if (after.is_null()) {
        ADD_FAILURE() << what;
        break;
      }
      for (const auto& [key, level] : levels_of(after)) {
        const auto old = had.find(key);
        EXPECT_LE(level, old == had.end() ? 0 : old->second) << key << "\n" << what;
        if (key == f["code"].get<std::string>() + " " + f["gear"].dump()) {
          EXPECT_EQ(level, 0) << what;
        }
      }
    }
  }
  return count;
}

TEST(VerdictLaws, what_a_remedy_states_helps) {
  const RemedyCount count = remedies_hold(30, 120);
  EXPECT_GT(2 * count.remedies, count.findings);  // most findings have one
  EXPECT_GT(count.of_a_gear, 10);                 // (5) was tested
}

TEST(LongVerdictLaws, what_a_remedy_states_helps) {
  const RemedyCount count = remedies_hold(3000, 1500);
  EXPECT_GT(2 * count.remedies, count.findings);
  RecordProperty("remedies", count.remedies);
  RecordProperty("findings", count.findings);
}

// (2)
void worst_ends_are_judged(std::uint64_t seed, int wanted) {
  Random random(seed);
  int red = 0, judged = 0;
  while (judged < wanted && !::testing::Test::HasFailure()) {
    Json spec = random_job(random);
    if (!spec.contains("pair")) continue;
    const double m = spec["gear1"]["normal_module_mm"];
    const double half = rounded(0.02 * m, 0.001) + 0.001;
    spec["gear1"]["thickness_allowance_mm"] = {-rounded(0.06 * m, 0.001),
                                               -rounded(0.02 * m, 0.001)};
    spec["pair"]["center_distance_deviations_mm"] = {-half, half};
    spec["gear1"]["profile_shift"] = 0.2;  // with shifts that follow from the distance, the
                                           // distance would change them
    spec["gear2"]["profile_shift"] = 0.0;
    const Json verdict = verdict_of("pair", spec);
    if (verdict.is_null()) continue;
    ++judged;
    int worst = 0;
    double least_backlash = 0.0;
    for (const int e : {0, 1}) {
      for (const int d : {0, 1}) {
        Json at = spec;
        at["gear1"]["thickness_allowance_mm"] = spec["gear1"]["thickness_allowance_mm"][e];
        const double a = spec["pair"]["center_distance_mm"];
        at["pair"] = {{"center_distance_mm", a + (d == 0 ? -half : half)}};
        const Json there = verdict_of("pair", at);
        if (there.is_null()) continue;
        worst = std::max(worst, rank(there["level"]));
        for (const Json& f : there["findings"])
          if (f["code"] == "negative_backlash")
            least_backlash = std::min(least_backlash, f["values"]["backlash_mm"].get<double>());
      }
    }
    EXPECT_GE(rank(verdict["level"]), worst) << spec.dump();
    red += worst == 2;
    for (const Json& f : verdict["findings"]) {
      if (f["code"] != "negative_backlash" || f["at"].is_null()) continue;
      EXPECT_NEAR(f["values"]["backlash_mm"].get<double>(), least_backlash, 1e-9) << spec.dump();
    }
  }
  EXPECT_GT(red, wanted / 10);
}

TEST(VerdictLaws, is_that_of_the_worst_ends_of_tolerances) { worst_ends_are_judged(31, 8); }
TEST(LongVerdictLaws, is_that_of_the_worst_ends_of_tolerances) { worst_ends_are_judged(3100, 300); }

void verbs_agree(std::uint64_t seed, int wanted) {
  Random random(seed);
  for (int judged = 0; judged < wanted && !::testing::Test::HasFailure();) {
    Json spec = random_job(random);
    spec["contact"] = {{"positions", 8}};
    const Json pair = verdict_of("pair", spec), contact = verdict_of("contact", spec);
    if (pair.is_null() || contact.is_null()) continue;
    ++judged;
    const std::string what = spec.dump() + "\n" + pair.dump() + "\n" + contact.dump();
    EXPECT_EQ(pair["not_judged"], Json({"contact"})) << what;
    EXPECT_TRUE(contact["not_judged"].empty()) << what;
    const auto all = levels_of(contact);
    for (const auto& [key, level] : levels_of(pair)) {
      const auto same = all.find(key);
      EXPECT_TRUE(same != all.end() && same->second == level) << key << "\n" << what;
    }
    EXPECT_GE(rank(contact["level"]), rank(pair["level"])) << what;
  }
}

TEST(VerdictLaws, is_the_same_in_pair_and_contact) { verbs_agree(32, 60); }
TEST(LongVerdictLaws, is_the_same_in_pair_and_contact) { verbs_agree(3200, 1000); }

// (4) Gears from catalogues and textbooks, with allowances of DIN 3967 and a housing tolerance of
//     JS7.
TEST(VerdictLaws, ordinary_pairs_are_green) {
  int pairs = 0;
  for (const double m : {1.0, 2.0, 3.0, 5.0}) {
    for (const auto& [z1, x1] : {std::pair{17, 0.3}, {19, 0.25}, {20, 0.2}, {25, 0.1}, {30, 0.0}}) {
      for (const int z2 : {31, 43, 60, 85, 101}) {
        for (const double beta : {0.0, 15.0}) {
          const double face = 10 * m;
          Json spec{{"gear1",
                     {{"teeth", z1},
                      {"normal_module_mm", m},
                      {"face_width_mm", face},
                      {"profile_shift", x1},
                      {"helix_angle_deg", beta},
                      {"tolerance", {{"thickness_series", "cd25"}}}}},
                    {"gear2",
                     {{"teeth", z2},
                      {"face_width_mm", face},
                      {"profile_shift", 0.0},
                      {"helix_angle_deg", -beta},
                      {"tolerance", {{"thickness_series", "cd25"}}}}},
                    {"pair", {{"center_distance_tolerance", "JS7"}}}};
          const Json verdict = verdict_of("pair", spec);
          if (verdict.is_null()) {  // outside the table of the series
            continue;
          }
          ++pairs;
          EXPECT_EQ(verdict["level"], "green") << spec.dump() << "\n" << verdict["headline"];
        }
      }
    }
  }
  EXPECT_GE(pairs, 200);
}

}  // namespace
}  // namespace gearwright::property
