// The numbering of trials. Laws: (1) every number belongs to exactly one trial; (2) the ends of a
// ratio band belong to the band.
#include "gearwright/design/search_space.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace gearwright {
namespace {

SearchProblem space_problem() {
  SearchProblem p;
  p.ratio = {1.8, 2.4};
  p.modules = {1.5, 2.0, 2.5};
  p.pinion_teeth = {12, 24};
  p.helix = {Angle(), Angle::radians(0.2), Angle::radians(-0.3)};
  p.racks = {SearchRacks{}, SearchRacks{}};
  return p;
}

TEST(SearchSpace, EveryNumberIsATrialOnce) {  // (1)
  for (const bool internal : {false, true}) {
    SearchProblem p = space_problem();
    if (internal) p.ratio = {-3.2, -2.7};
    const SearchSpace space(p);
    std::set<std::tuple<int, double, double, int, int>> seen;
    std::int64_t next = 0;
    space.each(0, *space.size(), [&](const Trial& t) {
      EXPECT_EQ(t.index, next++);
      const Trial again = space.trial(t.index);
      EXPECT_EQ(std::tie(again.rack, again.helix, again.module, again.z1, again.z2),
                std::tie(t.rack, t.helix, t.module, t.z1, t.z2));
      const double ratio = static_cast<double>(t.z2) / t.z1;
      EXPECT_GE(ratio, p.ratio[0] - 1e-12);
      EXPECT_LE(ratio, p.ratio[1] + 1e-12);
      EXPECT_EQ(t.helix[1], internal ? t.helix[0] : -t.helix[0]);
      seen.insert({t.rack, t.helix[0].rad(), t.module, t.z1, t.z2});
      return true;
    });
    EXPECT_EQ(next, *space.size());
    EXPECT_EQ(static_cast<std::int64_t>(seen.size()), next);
    std::int64_t pairs = 0;
    for (int z1 = 12; z1 <= 24; ++z1)
      for (int z2 = -200; z2 <= 200; ++z2)
        if (z2 >= p.ratio[0] * z1 - 1e-9 && z2 <= p.ratio[1] * z1 + 1e-9) ++pairs;
    EXPECT_EQ(next, pairs * 3 * 3 * 2);
    EXPECT_EQ(space.approximate_size(), static_cast<double>(next));
  }
}

// If the range of numbers is divided anywhere, each() gives the same sequence of trials. It stops
// when its function returns false.
TEST(SearchSpace, PartsOfTheLineAreTheLine) {
  SearchProblem p = space_problem();
  p.coprime = true;
  const SearchSpace space(p);
  const std::int64_t size = *space.size();
  std::vector<std::int64_t> all;
  space.each(0, size, [&](const Trial& t) {
    EXPECT_EQ(std::gcd(t.z1, t.z2), 1);
    all.push_back(t.index);
    return true;
  });
  for (const std::int64_t pieces : {2, 13, 500}) {
    std::vector<std::int64_t> parts;
    for (std::int64_t i = 0; i < pieces; ++i) {
      space.each(size * i / pieces, size * (i + 1) / pieces, [&](const Trial& t) {
        parts.push_back(t.index);
        return true;
      });
    }
    EXPECT_EQ(parts, all) << pieces;
  }
  int calls = 0;
  space.each(0, size, [&](const Trial&) { return ++calls < 5; });
  EXPECT_EQ(calls, 5);
}

TEST(SearchSpace, SpacesBeyondCountingHaveNoSize) {
  SearchProblem p = space_problem();
  p.ratio = {1.0, 900.0};
  p.pinion_teeth = {5, 20};
  EXPECT_TRUE(SearchSpace(p).size());
  p.modules.assign(100'000, 1.0);
  p.helix.assign(100'000, Angle::radians(0.1));
  p.racks.assign(10'000, SearchRacks{});
  const SearchSpace space(p);
  EXPECT_FALSE(space.size());
  EXPECT_GT(space.approximate_size(), 9e18);
}

// In spite of rounding, 1.9 · 30 and 2.1 · 10 count as 57 and 21. Wheels are not smaller than
// pinions.
TEST(SearchSpace, BandsAreClosed) {  // (2)
  SearchProblem p;
  const auto wheels = [&](double from, double to, int z1) {
    p.ratio = {from, to};
    return wheels_of(p, z1);
  };
  EXPECT_EQ(wheels(1.9, 2.1, 30), (std::array{57, 63}));
  EXPECT_EQ(wheels(1.9, 2.1, 10), (std::array{19, 21}));
  EXPECT_EQ(wheels(0.5, 1.1, 20), (std::array{20, 22}));
  EXPECT_EQ(wheels(2.0, 2.0, 31), (std::array{62, 62}));
  EXPECT_GT(wheels(1.51, 1.52, 20)[0], wheels(1.51, 1.52, 20)[1]);
  EXPECT_EQ(wheels(-2.1, -1.9, 30), (std::array{-63, -57}));
  EXPECT_EQ(wheels(-1.2, -0.5, 10), (std::array{-12, -11}));
}

}  // namespace
}  // namespace gearwright
