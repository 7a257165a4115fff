// Every listed design of a search, solved again from the spec that --take writes, has the numbers
// of its row, and its verdict is green if the design is drawn. A wish is a random spec of a search.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/testing/answered.hpp"

namespace gearwright {
namespace {

class Wish {
 public:
  explicit Wish(int number) : draw_(35'000 + static_cast<std::uint64_t>(number)) {
    Json s = Json::object();
    const bool internal = chance(0.1);
    const double ratio = draw_.uniform(internal ? 2.5 : 1.1, 6.0);
    const double side = internal ? -1.0 : 1.0;
    s["ratio"] = {std::min(side * ratio * 0.97, side * ratio * 1.03),
                  std::max(side * ratio * 0.97, side * ratio * 1.03)};
    const double a = chance(0.7) ? pick<double>({50, 63, 80, 100, 112, 125, 160, 200})
                                 : std::round(draw_.uniform(40, 250) * 100) / 100;
    if (internal) {
      s["center_distance_mm"] = {a * 0.5, a * 0.52};
    } else if (chance(0.9)) {
      s["center_distance_mm"] = a;
    } else {
      s["modules_mm"] = {2, 3};
      s["pinion_teeth"] = {17, 24};
    }
    if (chance(0.3)) s["modules_mm"] = pick<Json>({"ISO54-I+II", {2, 2.5, 3}});
    if (chance(0.7)) s["helix_angle_deg"] = pick<Json>({8, 12, 15, 20, {8, 20}, {0, 30}});
    if (s.contains("helix_angle_deg") && s["helix_angle_deg"].is_array())
      s["helix_step_deg"] = pick<int>({2, 4, 6});
    if (chance(0.15)) s["racks"] = {"ISO53-A", "ISO53-C"};
    if (chance(0.1)) s["coprime"] = true;
    if (chance(0.1)) s["sliding_max"] = 2;
    if (chance(0.1)) s["profile_shift"] = {-0.5, 0.8};
    tolerances(s, internal);
    const bool rated = chance(0.7);
    if (rated) load(s, a);
    widths(s, rated);
    objectives(s, rated);
    tree["search"] = std::move(s);
  }

  Json tree;

 private:
  bool chance(double share) { return draw_.uniform(0, 1) < share; }
  template <class T>
  T pick(const std::vector<T>& list) {
    return list[static_cast<std::size_t>(draw_.whole(0, static_cast<int>(list.size()) - 1))];
  }

  void tolerances(Json& s, bool internal) {
    if (!internal && chance(0.1)) {
      s["mounting"] = pick<Json>({"extended", "tight"});
      return;
    }
    if (chance(0.25))
      s["backlash_mm"] = {0.05, 0.2};
    else if (chance(0.5))
      s["thickness_series"] = pick<Json>({"e25", "cd25", "c25", "d27", "bc26", "none"});
    if (chance(0.4)) s["center_distance_tolerance"] = pick<Json>({"JS7", "JS8"});
  }

  void load(Json& s, double a) {
    tree["gear1"]["material"] = pick<Json>({"18CrNiMo7-6", "16MnCr5", "42CrMo4"});
    if (chance(0.2)) tree["gear2"]["material"] = "42CrMo4";
    Json r = Json::object();
    r["speed_rpm"] = pick<int>({100, 500, 1450, 2900});
    r["life_h"] = 20'000;
    r["quality"] = draw_.whole(4, 8);
    const double torque = draw_.uniform(0.02, 0.25) * std::pow(a / 10, 3);
    if (chance(0.5))
      r["torque_Nm"] = torque;
    else
      r["power_kW"] = torque * r["speed_rpm"].get<double>() / 9549.3;
    if (chance(0.7)) r["face_load_factor"] = pick<double>({1.1, 1.3});
    if (chance(0.3)) r["standard"] = "ISO 6336:2019";
    tree["rating"] = std::move(r);
    if (chance(0.9)) s["safety_flank_min"] = pick<double>({1.0, 1.2, 1.3});
    if (chance(0.7)) s["safety_root_min"] = pick<double>({1.2, 1.6});
  }

  void widths(Json& s, bool rated) {
    const int kind = draw_.whole(0, 5);
    const bool helical = s.contains("helix_angle_deg") && s["helix_angle_deg"].is_number();
    if (helical && chance(0.3)) s["overlap_ratio_min"] = 1.0;
    const bool sized = s.contains("safety_flank_min") || s.contains("safety_root_min") ||
                       s.contains("overlap_ratio_min");
    if (kind == 0) s["face_width_mm"] = draw_.whole(15, 50);
    if (kind == 1) s["face_width_modules"] = 12;
    if (kind == 2 && sized) s["face_width_mm"] = {10, 120};
    if (kind == 3 && sized && rated) s["face_width_diameters"] = {0.3, 0.9};
  }

  void objectives(Json& s, bool rated) {
    std::vector<Json> words{"contact_ratio", "ratio", "size", "sliding", "shift"};
    if (rated) words.insert(words.end(), {"mass", "safety"});
    const Json one = pick(words), other = pick(words);
    s["objective"] = chance(0.3) && one != other ? Json{one, other} : one;
  }

  testing::Draw draw_;
};

struct Tally {
  int refused = 0, empty = 0, drawn = 0, nominal = 0;
};

class Compared {
 public:
  Compared(const std::string& what, const Json& row, const Json& taken, bool rated, bool drawn)
      : what_(what), row_(row), pair_(testing::answered(taken, "pair")) {
    if (const Json rating = rated ? testing::answered(taken, "rate") : Json(); !rating.is_null())
      for (const char* key : {"S_H", "S_F"}) lists(key, row_[key], rating["rating"][key]);
    const Json& p = pair_["pair"];
    number("a", row_["center_distance_mm"], p["center_distance_mm"]);
    number("ε_α", row_["contact_ratio"], p["transverse_contact_ratio"]);
    number("ε_β", row_["overlap_ratio"], p["overlap_ratio"]);
    number("j_bn", row_["backlash_normal_mm"], p["backlash"]["normal_base_mm"]);
    number("α_wt", row_["working_transverse_pressure_angle_deg"],
           p["working_transverse_pressure_angle_deg"][0]);
    lists("c", row_["tip_clearance_mm"], p["tip_clearance_mm"]);
    for (const char* gear : {"gear1", "gear2"})
      lists("ζ", row_["specific_sliding"][gear], p["specific_sliding"][gear]);
    for (const std::size_t i : {0u, 1u})
      number("s_an", row_["tip_thickness_mm"][i],
             pair_["gears"][i]["tip_tooth_thickness_normal_mm"]);
    if (row_.contains("backlash_mm")) {
      Json ends = p["interval"]["backlash"]["normal_mm"];
      if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
      lists("j_n", row_["backlash_mm"], ends);
    }
    if (!drawn) return;
    const Json verdict = rated ? testing::answered(taken, "rate")["verdict"] : pair_["verdict"];
    EXPECT_EQ(verdict["level"], "green") << what_ << ": " << verdict["headline"];
  }

 private:
  void number(const char* name, const Json& a, const Json& b) {
    if (!a.is_number() || !b.is_number()) {
      EXPECT_EQ(a, b) << what_ << ": " << name;
      return;
    }
    const double x = a, y = b;
    EXPECT_NEAR(x, y, 1e-9 * std::max(1.0, std::abs(y))) << what_ << ": " << name;
  }
  void lists(const char* name, const Json& a, const Json& b) {
    ASSERT_EQ(a.size(), b.size()) << what_ << ": " << name;
    for (std::size_t i = 0; i < a.size(); ++i) number(name, a[i], b[i]);
  }

  std::string what_;
  const Json& row_;
  Json pair_;
};

void check(const std::string& wish, const JobSpec& spec, const SearchOptions& options,
           Tally& tally) {
  const Search search(*spec.search);
  const auto run = run_search(spec, search, options);
  if (!run) {
    // Few bands have no numbers of teeth at all.
    EXPECT_EQ(run.error().field, "search.ratio") << wish << ": " << run.error().message();
    ++tally.refused;
    return;
  }
  if (run->answer.designs.empty()) ++tally.empty;
  const SearchProblem& problem = search.problem();
  const bool drawn = static_cast<bool>(problem.draw);
  for (const DesignRow& row : run->answer.designs) {
    const std::string what =
        wish + ", " + std::to_string(row.trial.z1) + ":" + std::to_string(row.trial.z2);
    ++(drawn ? tally.drawn : tally.nominal);
    Compared(what, design_row_json(search, row, false), pair_spec(spec, search, row),
             problem.rating.has_value(), drawn);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << what << ": " << spec.tree->tables;
      return;
    }
  }
}

void check(int wish, Tally& tally) {
  const Wish w(wish);
  const auto spec = read_spec_tree(w.tree, {});
  ASSERT_TRUE(spec) << wish << ": " << spec.error().message() << "\n" << w.tree;
  SearchOptions options;
  options.top = 20;
  check(std::to_string(wish), *spec, options, tally);
}

// The searches that are shipped, each with all the designs that the program lists by default.
TEST(SearchWishes, ListedDesignsOfTheExamplesAreThoseOfARun) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(testing::source_file("examples"))) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("search.toml")) continue;
    SCOPED_TRACE(name);
    const auto spec = read_spec_file(entry.path());
    ASSERT_TRUE(spec) << spec.error().message();
    if (!spec->search) continue;  // a search for drives
    ++files;
    Tally tally;
    check(name, *spec, {}, tally);
    EXPECT_GT(tally.drawn, 0);
    EXPECT_EQ(tally.nominal, 0);
  }
  EXPECT_GE(files, 2);
}

TEST(SearchWishes, ListedDesignsAreThoseOfARun) {
  Tally tally;
  for (int n = 0; n < 12; ++n) check(n, tally);
  EXPECT_GT(tally.drawn, 20);
}

class LongSearchWishes : public ::testing::TestWithParam<int> {};

TEST_P(LongSearchWishes, ListedDesignsAreThoseOfARun) {
  Tally tally;
  for (int n = 0; n < 100; ++n) check(100 * GetParam() + n, tally);
  RecordProperty("drawn", tally.drawn);
  RecordProperty("nominal", tally.nominal);
  RecordProperty("empty", tally.empty);
  std::printf("%d drawn designs, %d with nominal teeth, %d wishes without designs, %d refused\n",
              tally.drawn, tally.nominal, tally.empty, tally.refused);
  EXPECT_GT(tally.drawn, 100);
  EXPECT_LT(tally.refused, 10);
}

// Tests a thousand random specs, in groups of a hundred.
INSTANTIATE_TEST_SUITE_P(Hundreds, LongSearchWishes, ::testing::Range(0, 10));

}  // namespace
}  // namespace gearwright
