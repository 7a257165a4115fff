// Laws: (1) a search finds the same sets as a separate computation that makes the drives of all
// numbers of teeth; (2) it finds the set with a ratio near 100 in the table of the theory page; (3)
// the ratio of a train is the ratio of its drive; (4) the noise of sets is the spread that a count
// of their tooth pairs in contact gives, and a list by noise is sorted.
#include "gearwright/design/drive_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/drive/drive.hpp"

namespace gearwright {
namespace {

using M = SetMember;
constexpr std::size_t at(M m) { return static_cast<std::size_t>(m); }

DriveSearchProblem problem_of(DriveKind kind, std::array<double, 2> ratio) {
  DriveSearchProblem problem;
  problem.kind = kind;
  problem.ratio = ratio;
  problem.modules = {1.0};
  problem.base.efficiency.all = 0.99;
  problem.base.spacing = Spacing::equal;
  return problem;
}

struct TeethOfPlanet {
  int sun, planet, ring;
};

using Key = std::pair<TeethBand, std::array<int, 3>>;

TEST(DriveSearchTest, FindsWhatTheDrivesSay) {
  DriveSearchProblem problem = problem_of(DriveKind::planetary, {4.0, 4.8});
  problem.teeth[at(M::sun)] = {14, 20};
  problem.teeth[at(M::planet)] = {15, 22};
  problem.teeth[at(M::ring)] = {40, 80};
  problem.planets = {3, 5};
  problem.phasing = {PhasingClass::sequential, PhasingClass::counter};
  problem.size_max = 62.5;
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found) << found.error().message();
  std::set<std::array<int, 4>> expected;
  for (int s = 14; s <= 20; ++s)
    for (int p = 15; p <= 22; ++p)
      for (int r = s + 2 * p - 1; r <= s + 2 * p + 1; ++r)
        for (int n = 3; n <= 5; ++n) {
          if (r > 80) continue;
          // Root diameter of the ring, and diameter of the circle that the planet tips touch.
          if (std::max(r + 2.5, s + 2 * p + 2.0) > problem.size_max) continue;
          PlanetarySpec set = problem.base;
          set.z(M::sun) = s;
          set.z(M::planet) = p;
          set.z(M::ring) = r;
          set.planets = n;
          // Speeds and positions are computed first, because the tooth geometry takes longer.
          set.normal_module.reset();
          const auto numbers = graph_of(set);
          ASSERT_TRUE(numbers);
          const auto motion = make_drive({*numbers, {}});
          if (!motion) continue;  // planets at equal pitch cannot be assembled
          const double i = motion->motion.ratio->value();
          const PhasingClass kind = motion->sets.front().phasing.kind;
          if (i < 4.0 || i > 4.8) continue;
          if (kind != PhasingClass::sequential && kind != PhasingClass::counter) continue;
          set.normal_module = 1.0;
          const auto drive = make_drive({*graph_of(set), {}});
          ASSERT_TRUE(drive);
          if (!(drive->sets.front().neighbours->clearance >= 1.0)) continue;
          expected.insert({s, p, r, n});
        }
  std::set<std::array<int, 4>> got;
  for (const DriveCandidate& c : found->found)
    got.insert({c.teeth[at(M::sun)], c.teeth[at(M::planet)], c.teeth[at(M::ring)], c.planets});
  EXPECT_EQ(got, expected);
  EXPECT_GT(got.size(), 10u);
  std::int64_t counted = static_cast<std::int64_t>(found->found.size());
  for (const auto n : found->rejected) {
    EXPECT_GT(n, 0);
    counted += n;
  }
  EXPECT_EQ(counted, found->tested);
}

// For every candidate, ratio, positions and efficiency are compared with those of the drive that
// has the same numbers of teeth.
void expect_as_drives(const DriveSearchProblem& problem, const DriveSearchResult& result,
                      std::size_t every) {
  for (std::size_t k = 0; k < result.found.size(); k += every) {
    const DriveCandidate& c = result.found[k];
    PlanetarySpec set = set_of(problem, c);
    set.normal_module.reset();
    const auto graph = graph_of(set);
    ASSERT_TRUE(graph);
    const auto drive = make_drive({*graph, {}});
    ASSERT_TRUE(drive) << drive.error().message();
    EXPECT_EQ(c.ratio, drive->motion.ratio->value());
    EXPECT_EQ(c.places, drive->sets.front().assembly.places);
    EXPECT_NEAR(c.efficiency, drive->flow->efficiency, 1e-12);
  }
}

TEST(DriveSearchTest, OtherKindsAreAsTheirDrives) {
  DriveSearchProblem stepped = problem_of(DriveKind::stepped, {9.0, 9.5});
  stepped.teeth[at(M::sun)] = {17, 24};
  stepped.teeth[at(M::planet2)] = {14, 20};
  stepped.coaxial_teeth = 0;
  const auto a = search_drives(stepped, 1);
  ASSERT_TRUE(a) << a.error().message();
  EXPECT_GT(a->found.size(), 5u);
  expect_as_drives(stepped, *a, 1 + a->found.size() / 40);

  DriveSearchProblem wolfrom = problem_of(DriveKind::wolfrom, {-60.0, 60.0});
  wolfrom.teeth[at(M::planet)] = {18, 24};
  complete_ends(wolfrom);
  const auto b = search_drives(wolfrom, 1);
  ASSERT_TRUE(b) << b.error().message();
  EXPECT_GT(b->found.size(), 5u);
  expect_as_drives(wolfrom, *b, 1 + b->found.size() / 40);

  DriveSearchProblem suns = problem_of(DriveKind::two_suns, {-40.0, -10.0});
  suns.planets = {2, 2};
  complete_ends(suns);
  suns.teeth[at(M::planet)] = {36, 44};
  const auto c = search_drives(suns, 1);
  ASSERT_TRUE(c) << c.error().message();
  EXPECT_GT(c->found.size(), 5u);
  expect_as_drives(suns, *c, 1 + c->found.size() / 40);
}

// A row of the table in the theory page: 13/29·26/71/68 has i = 101.13 and η = 0.815.
TEST(DriveSearchTest, ThreeGearsNearHundred) {
  DriveSearchProblem problem = problem_of(DriveKind::wolfrom, {99.0, 103.0});
  problem.teeth[at(M::sun)] = {12, 18};
  problem.teeth[at(M::planet)] = {20, 30};
  problem.teeth[at(M::planet2)] = {18, 30};
  problem.teeth[at(M::ring)] = {50, 75};
  problem.teeth[at(M::ring2)] = {50, 75};
  problem.coaxial_teeth = 0;
  problem.neighbour_clearance = -10.0;
  problem.base.efficiency = {};
  problem.base.efficiency.each = {
      {"sun_planet", 0.985}, {"planet_ring", 0.993}, {"planet_ring2", 0.993}};
  complete_ends(problem);
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found) << found.error().message();
  expect_as_drives(problem, *found, 1);
  bool there = false;
  for (const DriveCandidate& c : found->found)
    there = there || (c.teeth[at(M::sun)] == 13 && c.teeth[at(M::planet)] == 29 &&
                      c.teeth[at(M::planet2)] == 26 && c.teeth[at(M::ring)] == 71 &&
                      c.teeth[at(M::ring2)] == 68 && std::abs(c.ratio - 101.13) < 0.01);
  EXPECT_TRUE(there);
}

TEST(DriveSearchTest, TrainsHaveTheirRatio) {
  DriveSearchProblem problem = problem_of(DriveKind::train, {12.0, 12.05});
  problem.pinion = {17, 20};
  problem.wheel = {50, 80};
  problem.objectives = {DriveObjective::size};
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found) << found.error().message();
  std::size_t expected = 0;
  for (int a = 17; a <= 20; ++a)
    for (int b = 50; b <= 80; ++b)
      for (int c = 17; c <= 20; ++c)
        for (int d = 50; d <= 80; ++d) {
          const double i = static_cast<double>(b * d) / (a * c);
          expected += i >= 12.0 && i <= 12.05 ? 1 : 0;
        }
  EXPECT_EQ(found->found.size(), expected);
  EXPECT_EQ(found->tested, 4 * 31 * 4 * 31);
  for (std::size_t k = 1; k < found->found.size(); ++k)
    EXPECT_LE(found->found[k - 1].size, found->found[k].size);
}

// The number of teeth of the wheel that would give this ratio exceeds the range of int.
TEST(DriveSearchTest, NoTrainHasAnEnormousRatio) {
  for (const int stages : {1, 2}) {
    DriveSearchProblem problem = problem_of(DriveKind::train, {});
    problem.ratio = stages == 1 ? std::array{-1e9, -5e8} : std::array{5e8, 1e9};
    problem.stages = {stages, stages};
    problem.pinion = {17, 18};
    problem.wheel = {50, 52};
    const auto found = search_drives(problem, 1);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_TRUE(found->found.empty());
    EXPECT_EQ(found->tested, stages == 1 ? 2 * 3 : 2 * 3 * 2 * 3);
    EXPECT_EQ(found->rejected[static_cast<std::size_t>(DriveLimit::ratio)], found->tested);
  }
}

// Centre distance of two spur gears of nominal teeth without backlash, by bisection.
double distance_of(int sum_of_teeth, double module, double sum_of_shifts) {
  const double alpha = Angle::degrees(20).rad();
  const double wanted =
      std::tan(alpha) - alpha + 2 * sum_of_shifts * std::tan(alpha) / sum_of_teeth;
  double low = 0.0, high = 1.5;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (std::tan(middle) - middle < wanted ? low : high) = middle;
  }
  return module * sum_of_teeth / 2 * std::cos(alpha) / std::cos(low);
}

// Every train is found once for each choice of modules with which a sum of shifts from −1 to 3
// gives a centre distance within the band.
TEST(DriveSearchTest, TrainsHaveTheModulesOfTheirCentreDistances) {
  DriveSearchProblem problem = problem_of(DriveKind::train, {9.0, 9.1});
  problem.pinion = {17, 22};
  problem.wheel = {50, 75};
  problem.modules = {1.5, 1.75, 2.0, 2.25, 2.5};
  problem.center_distance = {{84.0, 86.5}};
  problem.size_max = 170.0;
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found) << found.error().message();
  using Chosen = std::pair<std::vector<std::array<int, 2>>, std::vector<double>>;
  std::set<Chosen> expected, got;
  std::size_t too_large = 0;
  const auto reaches = [&](int sum, double module) {
    return distance_of(sum, module, -1.0) <= 86.5 && distance_of(sum, module, 3.0) >= 84.0;
  };
  for (int a = 17; a <= 22; ++a)
    for (int b = 50; b <= 75; ++b)
      for (int c = 17; c <= 22; ++c)
        for (int d = 50; d <= 75; ++d) {
          const double i = static_cast<double>(b * d) / (a * c);
          if (i < 9.0 || i > 9.1) continue;
          for (const double m : problem.modules)
            for (const double n : problem.modules) {
              if (!reaches(a + b, m) || !reaches(c + d, n)) continue;
              if ((m * (a + b) + n * (c + d)) / 2 > 170.0) {
                ++too_large;
              } else {
                expected.insert({{{a, b}, {c, d}}, {m, n}});
              }
            }
        }
  for (const DriveCandidate& c : found->found) {
    got.insert({c.stages, c.stage_modules});
    EXPECT_NEAR(c.size,
                (c.stage_modules[0] * (c.stages[0][0] + c.stages[0][1]) +
                 c.stage_modules[1] * (c.stages[1][0] + c.stages[1][1])) /
                    2,
                1e-9);
  }
  EXPECT_EQ(got, expected);
  EXPECT_EQ(got.size(), found->found.size());
  EXPECT_GT(got.size(), 50u);
  EXPECT_TRUE(std::any_of(got.begin(), got.end(),
                          [](const Chosen& c) { return c.second[0] != c.second[1]; }));
  EXPECT_GT(too_large, 10u);
  EXPECT_EQ(found->rejected[static_cast<std::size_t>(DriveLimit::size)],
            static_cast<std::int64_t>(too_large));
  std::int64_t counted = static_cast<std::int64_t>(found->found.size());
  for (const auto n : found->rejected) counted += n;
  EXPECT_EQ(counted, found->tested);
}

TEST(DriveSearchTest, FrontIsWhatNothingBeats) {
  DriveSearchProblem problem = problem_of(DriveKind::planetary, {4.0, 5.0});
  problem.objectives = {DriveObjective::efficiency, DriveObjective::size};
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found);
  const auto& all = found->found;
  const auto front = pareto_front(problem, all);
  ASSERT_GT(front.size(), 1u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool beaten = false;
    for (const DriveCandidate& other : all)
      beaten = beaten || (other.efficiency >= all[i].efficiency && other.size <= all[i].size &&
                          (other.efficiency > all[i].efficiency || other.size < all[i].size));
    EXPECT_EQ(std::find(front.begin(), front.end(), i) == front.end(), beaten);
  }
}

// Efficiencies that differ by less than 0.01 % do not decide the order. Of all drives whose
// efficiency is at most 1e-4 below the best one, the smallest comes first. No drive is more than
// 1e-4 better than an earlier one.
TEST(DriveSearchTest, NearlyEqualEfficienciesAreSortedBySize) {
  DriveSearchProblem problem = problem_of(DriveKind::train, {12.0, 12.05});
  problem.pinion = {17, 20};
  problem.wheel = {50, 80};
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found);
  const auto& all = found->found;
  ASSERT_GT(all.size(), 20u);
  double best = 0.0, smallest = kInfinity, so_far = 1.0;
  for (const DriveCandidate& c : all) best = std::max(best, c.efficiency);
  for (const DriveCandidate& c : all)
    if (c.efficiency >= best - 1e-4) smallest = std::min(smallest, c.size);
  EXPECT_EQ(all.front().size, smallest);
  for (const DriveCandidate& c : all) {
    EXPECT_LE(c.efficiency, so_far + 1e-4);
    so_far = std::min(so_far, c.efficiency);
  }
}

TEST(DriveSearchTest, EndsAreThreeBodies) {
  DriveSearchProblem problem = problem_of(DriveKind::planetary, {4.0, 5.0});
  problem.base.output = "ring";
  EXPECT_EQ(search_drives(problem).error().field, "drive.output");
  problem.base.output = "ring2";
  EXPECT_EQ(search_drives(problem).error().field, "drive.output");
  // The default input is the fixed sun.
  problem = problem_of(DriveKind::planetary, {1.2, 1.5});
  problem.base.fixed = {{"sun"}};
  const Error error = search_drives(problem).error();
  EXPECT_EQ(error.field, "drive.input");
  EXPECT_EQ(error.value, "sun");
  EXPECT_NE(error.rule.find("`input` = \"sun\""), std::string::npos);
  EXPECT_EQ(error.rule.find("`fixed`"), std::string::npos);
}

// Returns the number of spur tooth pairs of one planet in contact at the sun, or at the ring if
// `at_ring`, divided by ε_α. It counts the flanks between the ends of the path. The two flanks of a
// tooth of the planet are half a pitch apart. The contacts at the ring are therefore delayed by
// half the number of teeth of the planet minus half a pitch.
double pairs_in_contact(const TeethOfPlanet& z, bool at_ring, double t) {
  const double alpha = Angle::degrees(20).rad();
  const auto tip = [&](int teeth, double addendum) {
    const double r = teeth / 2.0, r_b = r * std::cos(alpha);
    return std::abs(std::sqrt(std::pow(r + addendum, 2) - r_b * r_b) - r * std::sin(alpha)) /
           (3.14159265358979 * std::cos(alpha));
  };
  const double before = at_ring ? tip(z.ring, -1.0) : tip(z.planet, 1.0);
  const double after = at_ring ? tip(z.planet, 1.0) : tip(z.sun, 1.0);
  const double late = at_ring ? (z.planet - 1) / 2.0 : 0.0;
  int pairs = 0;
  for (int k = -200; k <= 200; ++k)
    if (t - late + k > -before && t - late + k < after) ++pairs;
  return pairs / (before + after);
}

TEST(DriveSearchTest, NoiseIsTheSpreadOfCountedContacts) {  // (4)
  DriveSearchProblem problem = problem_of(DriveKind::planetary, {4.3, 4.5});
  problem.modules.clear();
  problem.teeth[at(M::sun)] = {18, 24};
  problem.teeth[at(M::planet)] = {20, 30};
  problem.planets = {3, 4};
  problem.objectives = {DriveObjective::noise};
  const auto found = search_drives(problem, 1);
  ASSERT_TRUE(found) << found.error().message();
  ASSERT_GT(found->found.size(), 10u);
  double last = 0.0;
  for (const DriveCandidate& c : found->found) {
    const TeethOfPlanet z{c.teeth[at(M::sun)], c.teeth[at(M::planet)], c.teeth[at(M::ring)]};
    double least = 1e300, greatest = 0.0;
    constexpr int kTimes = 4000;
    for (int n = 0; n < kTimes; ++n) {
      double sum = 0.0;
      for (int i = 0; i < c.planets; ++i) {
        // The sun brings a tooth to planet i after its share of a turn.
        const double t = (n + 0.5) / kTimes - std::fmod(double(z.sun) * i / c.planets, 1.0);
        sum += 0.5 / pairs_in_contact(z, false, t) + 0.5 / pairs_in_contact(z, true, t);
      }
      least = std::min(least, sum / c.planets);
      greatest = std::max(greatest, sum / c.planets);
    }
    ASSERT_TRUE(c.noise);
    EXPECT_NEAR(*c.noise, greatest - least, 1e-6) << z.sun << " " << z.planet << " " << z.ring;
    EXPECT_GE(*c.noise, last);
    last = *c.noise;
  }
}

// A planet that meshes with two rings spans both. Its face width is the sum of theirs plus two
// modules.
TEST(DriveSearchTest, APlanetSpansItsTwoRings) {
  DriveCandidate candidate;
  candidate.module = 2.0;
  candidate.teeth[at(M::planet)] = 21;
  candidate.teeth[at(M::ring)] = 57;
  candidate.teeth[at(M::ring2)] = 60;
  candidate.face_widths = {10.0, 11.0};
  const PerMember widths = member_face_widths(candidate);
  EXPECT_EQ(widths.each[at(M::ring)], 10.0);
  EXPECT_EQ(widths.each[at(M::ring2)], 11.0);
  EXPECT_EQ(widths.each[at(M::planet)], 10.0 + 11.0 + 2 * 2.0);
}

}  // namespace
}  // namespace gearwright
