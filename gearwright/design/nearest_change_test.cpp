// Laws of a nearest change: (1) with the change as printed, a design exists; (2) with a slightly
// smaller change, no design exists; (3) the changes are sorted, smallest first, and a change that
// does not help is not listed.
#include "gearwright/design/nearest_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/design/testing/search_reference.hpp"
#include "gearwright/design/whole_overlap.hpp"

namespace gearwright {
namespace {

using testing::search::problem_of_search;
using testing::search::reference;

bool feasible(const SearchProblem& p) {
  const Search search(p);
  return search.exists(0, *search.space().size());
}

// Reads both ends of "1.2" or "[99, 101]".
std::array<double, 2> band(const std::string& text) {
  double a = 0.0;
  double b = 0.0;
  if (std::sscanf(text.c_str(), "[%lf, %lf]", &a, &b) == 2) return {a, b};
  a = std::stod(text);
  return {a, a};
}

// The member that a change affects. Both limits of the shifts count as one band.
std::string member(const NearestChange& c) {
  return c.field.ends_with("_shift") ? "limits.shift" : c.field;
}

// Sets a member to a band, or to a number if the member is not a band.
void set(SearchProblem& p, const std::string& key, const std::array<double, 2>& v) {
  SearchLimits& l = p.limits;
  if (key == "limits.contact_ratio") {
    l.contact_ratio = v[0];
  } else if (key == "limits.tip_thickness") {
    l.tip_thickness = v[0];
  } else if (key == "center_distance") {
    p.center_distance = v;
  } else if (key == "ratio") {
    p.ratio = v;
  } else if (key == "pinion_teeth") {
    p.pinion_teeth = {static_cast<int>(v[0]), static_cast<int>(v[1])};
  } else if (key == "limits.shift") {
    l.min_shift = v[0];
    l.max_shift = v[1];
  } else if (key == "limits.undercut_margin") {
    l.undercut_margin = v[0];
  } else if (key == "limits.overlap_ratio") {
    l.overlap_ratio = v[0];
  } else if (key == "limits.sliding") {
    l.sliding = v[0];
  } else if (key == "limits.form_clearance") {
    l.form_clearance = v[0];
  } else if (key == "limits.tip_clearance") {
    l.tip_clearance = v[0];
  } else {
    FAIL() << key;
  }
}

struct Empty {
  const char* name;
  SearchProblem problem;
  std::vector<std::string> named;    // members that must be among the changes
  std::vector<std::string> useless;  // members that must not
};

// 20 … 24 teeth, module 2 and ratios of about 2 at 66 mm. This search has designs, and each case
// changes it so that none is left.
SearchProblem small() {
  SearchProblem p;
  p.ratio = {1.9, 2.1};
  p.center_distance = {{65.0, 67.0}};
  p.modules = {2.0};
  p.pinion_teeth = {20, 24};
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  p.target_ratio = 2.0;
  return p;
}

template <class F>
SearchProblem with(const F& change, SearchProblem p = small()) {
  change(p);
  return p;
}

std::vector<Empty> empty_searches() {
  using P = SearchProblem;
  const SearchProblem first = problem_of_search(reference().at("searches")[0].at("input"));
  return {
      {"contact_ratio",
       with([](P& p) { p.limits.contact_ratio = 1.9; }),
       {"limits.contact_ratio"},
       {"limits.tip_thickness"}},
      {"contact_ratio_of_the_reference",
       with([](P& p) { p.limits.contact_ratio = 1.95; }, first),
       {"limits.contact_ratio"},
       {}},
      {"center_distance",
       with([](P& p) {
         p.center_distance = {{80.0, 81.5}};
       }),
       {"center_distance", "pinion_teeth", "ratio"},
       {"limits.contact_ratio", "limits.tip_thickness"}},
      {"exact_center_distance",
       with([](P& p) {
         p.center_distance = {{81.25, 81.25}};
       }),
       {"center_distance"},
       {}},
      {"tip_thickness",
       with([](P& p) { p.limits.tip_thickness = 0.95; }),
       {"limits.tip_thickness"},
       {"center_distance", "limits.contact_ratio"}},
      {"shift",
       with([](P& p) {
         p.limits.min_shift = 0.9;
         p.limits.max_shift = 0.95;
         p.pinion_teeth = {24, 24};
       }),
       {"limits.shift"},
       {"coprime"}},
      {"undercut_margin",
       with([](P& p) { p.limits.undercut_margin = 1.6; }),
       {"limits.undercut_margin"},
       {}},
      {"sliding",
       with([](P& p) {
         p.mounting = Mounting::tight;
         p.limits.sliding = 0.4;
       }),
       {"limits.sliding"},
       {"limits.tip_thickness"}},
      {"tip_clearance",
       with([](P& p) { p.limits.tip_clearance = 0.3; }),
       {"limits.tip_clearance"},
       {"center_distance", "limits.contact_ratio", "limits.shift"}},
      {"overlap",
       with([](P& p) {
         p.helix = {Angle::radians(0.3)};
         p.limits.overlap_ratio = 1.25;
       }),
       {"limits.overlap_ratio"},
       {"limits.contact_ratio"}},
      {"coprime",
       with([](P& p) {
         p.ratio = {2.0, 2.0};
         p.coprime = true;
       }),
       {"coprime", "ratio"},
       {"limits.contact_ratio"}},
      {"interference",
       with([](P& p) {
         p.ratio = {4.1, 4.15};
         p.pinion_teeth = {16, 16};
         p.modules = {1.0};
         p.center_distance = {{40.5, 40.5}};
         p.limits.max_shift = 0.1;
         p.limits.avoid_interference = true;
       }),
       {"limits.avoid_interference"},
       // Changing a single end does not help, because Σ is given and the other end rejects all
       // designs.
       {"limits.shift"}},

      {"ring",
       with([](P& p) {
         p.ratio = {-3.05, -2.95};
         p.center_distance = {{45.0, 46.0}};
         p.limits.contact_ratio = 2.9;
       }),
       {"limits.contact_ratio"},
       {}},
  };
}

class NearestChangeOf : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Searches, NearestChangeOf,
                         ::testing::Range(std::size_t{0}, std::size_t{13}));

TEST_P(NearestChangeOf, ItHelpsAndLessDoesNot) {
  const auto searches = empty_searches();
  ASSERT_EQ(searches.size(), 13u);
  const Empty& e = searches[GetParam()];
  ASSERT_FALSE(feasible(e.problem)) << e.name;
  const auto changes = nearest_changes(e.problem).changes;
  EXPECT_TRUE(std::is_sorted(changes.begin(), changes.end(), [](const auto& a, const auto& b) {
    return a.effort < b.effort;
  })) << e.name;
  const auto is_named = [&](const std::string& key) {
    return std::any_of(changes.begin(), changes.end(),
                       [&](const NearestChange& c) { return member(c) == key; });
  };
  for (const std::string& key : e.named) EXPECT_TRUE(is_named(key)) << e.name << " " << key;
  for (const std::string& key : e.useless) EXPECT_FALSE(is_named(key)) << e.name << " " << key;

  for (const NearestChange& c : changes) {
    const std::string what = std::string(e.name) + ": " + c.field + " " + c.from + " -> " + c.to;
    EXPECT_GT(c.effort, 0.0) << what;
    SearchProblem p = e.problem;
    if (c.field == "coprime" || c.field == "limits.avoid_interference") {
      EXPECT_EQ(c.from + c.to, c.field == "coprime" ? "truefalse" : "excludeflag") << what;
      (c.field == "coprime" ? p.coprime : p.limits.avoid_interference) = false;
      EXPECT_EQ(c.effort, c.field == "coprime" ? 0.5 : 100.0) << what;
      EXPECT_TRUE(feasible(p)) << what;
      continue;
    }
    const auto from = band(c.from);
    const auto to = band(c.to);
    set(p, member(c), from);
    EXPECT_FALSE(feasible(p)) << what;  // `from` is the given value
    set(p, member(c), to);
    EXPECT_TRUE(feasible(p)) << what;  // (1)
    // The text contains the change with four digits, rounded outwards. The required change is
    // smaller by at most 1.1e-3 of itself.
    auto less = to;
    for (const std::size_t i : {0, 1}) {
      const double move = to[i] - from[i];
      if (c.field == "pinion_teeth") {
        less[i] = move == 0.0 ? to[i] : to[i] - std::copysign(1.0, move);
      } else {
        less[i] = from[i] + move * (1.0 - 2e-3);
      }
    }
    set(p, member(c), less);
    EXPECT_FALSE(feasible(p)) << what;  // (2)
  }
}

// A search at tight centres with shortened tips, whose clearance is at most that of the racks. For
// each quantity that may change, all trials (432 and more) must be checked, and only a change of
// the clearance helps. A bisection of the whole search would need about 30 times as many checks
// with the graph. Each of these checks costs two thousand times as much as a check with the filter.
SearchProblem slow() {
  SearchProblem p;
  p.ratio = {4.0, 5.0};
  p.center_distance = {{100.0, 140.0}};
  for (int i = 4; i <= 40; ++i) p.modules.push_back(i / 4.0);
  p.pinion_teeth = {15, 15};
  p.helix = {Angle(), Angle::degrees(5), Angle::degrees(10)};
  p.mounting = Mounting::tight;
  p.shorten_tips = true;
  p.limits.tip_clearance = 0.2504944389591222;
  return p;
}

TEST(NearestChange, EveryTrialIsAskedOnceOrTwice) {
  const SearchProblem p = slow();
  ASSERT_FALSE(feasible(p));
  const NearestChanges found = nearest_changes(p);
  ASSERT_EQ(found.changes.size(), 1u);
  EXPECT_EQ(found.changes[0].field, "limits.tip_clearance");
  EXPECT_NEAR(std::stod(found.changes[0].to), 0.25, 1e-6);
  EXPECT_TRUE(found.bounded.empty());
  EXPECT_FALSE(found.stopped);
  // These limits and bands are tried, whether they help or not, and each is named once.
  for (const char* field :
       {"limits.tip_clearance", "limits.contact_ratio", "ratio", "pinion_teeth"})
    EXPECT_EQ(std::count(found.tried.begin(), found.tried.end(), field), 1) << field;
  // Five quantities may change. For each of them, the trials that pass the filter are at most as
  // many as those with 5 to 40 pinion teeth. The bisections add fewer than 500 checks.
  std::int64_t passed = 0;
  for (SearchProblem far : {p, p, p, p, p}) {
    far.pinion_teeth = {5, 40};
    Search(far).candidates([&](const Trial&) {
      ++passed;
      return true;
    });
  }
  EXPECT_LT(found.asked, passed + 500);
}

TEST(NearestChange, IsTheOneThatBisectionOfTheWholeSearchFinds) {
  for (const double least : {1.85, 1.95, 2.05}) {
    SearchProblem p = small();
    p.modules = {1.0, 1.5, 2.0, 2.5};
    p.pinion_teeth = {12, 30};
    p.limits.contact_ratio = least;
    if (feasible(p)) continue;
    const auto changes = nearest_changes(p).changes;
    const auto at = std::find_if(changes.begin(), changes.end(), [](const NearestChange& c) {
      return c.field == "limits.contact_ratio";
    });
    ASSERT_NE(at, changes.end());
    SearchProblem other = p;
    double& limit = other.limits.contact_ratio;
    double no = least;
    double yes = 1.0;
    while (std::abs(yes - no) > 1e-10) {
      const double middle = (no + yes) / 2.0;
      limit = middle;
      (feasible(other) ? yes : no) = middle;
    }
    EXPECT_LE(std::stod(at->to), yes + 1e-9);
    EXPECT_NEAR(std::stod(at->to), yes, 1e-3 * (least - yes) + 1e-9);
  }
}

// Helix angles and face widths follow from the overlap ratio and a band of b/d_1. With 40 to 44
// teeth, the narrowest face is 16 mm (0.2 · 80 mm). At 62 to 66 mm, pinions have about 20 teeth, and
// their faces are 9 to 14 mm wide, so the change must also change the widths.
TEST(NearestChange, OfThePinionTeethHasTheFaceWidthsOfTheNewPinions) {
  SearchProblem p = small();
  p.center_distance = {{62.0, 66.0}};
  p.pinion_teeth = {40, 44};
  p.face_diameters = {{0.2, 0.3}};
  p.overlap_ratios = {1.0};
  p.overlap_helix_deg = {5.0, 30.0};
  set_overlap_choices(p);
  ASSERT_FALSE(p.choices.empty());
  ASSERT_GE(*p.choices.back().face_width, 16.0);
  ASSERT_FALSE(feasible(p));
  const auto changes = nearest_changes(p).changes;
  const auto at = std::find_if(changes.begin(), changes.end(),
                               [](const NearestChange& c) { return c.field == "pinion_teeth"; });
  ASSERT_NE(at, changes.end());
  const auto teeth = band(at->to);
  const auto with_teeth = [&](double least) {
    SearchProblem q = p;
    q.pinion_teeth = {static_cast<int>(least), static_cast<int>(teeth[1])};
    set_overlap_choices(q);
    return q;
  };
  EXPECT_TRUE(feasible(with_teeth(teeth[0])));
  EXPECT_FALSE(feasible(with_teeth(teeth[0] + 1.0)));
}

TEST(NearestChange, EndsWhenItIsToldToAndSaysWhatItDidNotAsk) {
  const SearchProblem p = slow();
  std::int64_t calls = 0;
  const NearestChanges ended = nearest_changes(p, [&](std::int64_t) { return ++calls < 100; });
  EXPECT_TRUE(ended.stopped);
  EXPECT_LE(calls, 102);
  const NearestChanges few = nearest_changes(p, {}, 10);
  EXPECT_FALSE(few.stopped);
  EXPECT_LE(few.asked, 10 * 14);
  EXPECT_FALSE(few.bounded.empty());
  EXPECT_TRUE(std::is_sorted(few.changes.begin(), few.changes.end(),
                             [](const auto& a, const auto& b) { return a.effort < b.effort; }));
}

}  // namespace
}  // namespace gearwright
