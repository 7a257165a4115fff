// Law: if the verdict is green, the outlines of sun, planets and ring overlap nowhere while the sun
// turns. If the verdict is red because of an overlap, they overlap somewhere. The sun turns in 120
// steps, or in 360 steps in the long test. The oracle uses only points of the outlines: two gears
// overlap if a point of one gear lies inside a tooth of the other gear.
#include "gearwright/arrange/judge.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearwright/arrange/testing/tooth_points.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/drive/drive_layout.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using testing::Tooth;

using M = SetMember;

// The greatest overlap of any two gears of the set, and the rotation of the sun at which it occurs.
struct Overlap {
  double depth;  ///< modules
  double turn;   ///< rotation of the sun, in turns
};

Overlap overlap_at(const Drive& drive, const std::vector<double>& turns, int points_per_arc) {
  const auto layout = drive_layout(drive);
  EXPECT_TRUE(layout) << layout.error().message();
  std::vector<Tooth> teeth;
  for (const auto& gear : drive.geometry.gears) teeth.emplace_back(*gear, points_per_arc);
  Overlap worst{-1e9, 0.0};
  for (const double turn : turns) {
    const DriveLayout now = turned(drive, *layout, turn);
    for (const PlacedGear& a : now.gears)
      for (const PlacedGear& b : now.gears) {
        if (a.gear == b.gear && a.copy == b.copy) continue;
        const double depth = depth_in(teeth[a.gear], a, teeth[b.gear], b, worst.depth);
        if (depth > worst.depth) worst = {depth, turn};
      }
  }
  worst.depth /= drive.geometry.gears.front()->spec.normal_module;
  return worst;
}

// With 60 points per arc, the chords of an outline are within 1e-4 modules of the curve. This error
// falls with the square of the number of points. If 60 points do not decide a case, the worst step
// is repeated with 600 points per arc. The thinnest overlap in the 100 red sets of LongJudgeDrive
// is 3.1e-5 modules (21:16:52, backlash −0.0001 mm).
constexpr double kChords = 1e-4;

double overlap(const Drive& drive, int steps) {
  std::vector<double> turns;
  for (int step = 0; step < steps; ++step) turns.push_back(static_cast<double>(step) / steps);
  const Overlap coarse = overlap_at(drive, turns, 60);
  if (std::abs(coarse.depth) > kChords) return coarse.depth;
  return overlap_at(drive, {coarse.turn}, 600).depth;
}
constexpr double kFineChords = kChords / 100;

bool bodies_overlap(WarningCode code) {
  return code == WarningCode::overlap || code == WarningCode::negative_backlash ||
         code == WarningCode::tip_to_fillet || code == WarningCode::root ||
         code == WarningCode::trochoid;
}

struct Counts {
  int green = 0, red = 0;
};

struct TriedSet {
  Drive drive;
  bool is_green;
  std::string what;
};

// Draws random sets until it has `green` green sets and `red` sets that are red because of an
// overlap, and searches all of them for overlaps.
Counts try_sets(unsigned seed, int green, int red, int steps) {
  std::mt19937 random(seed);
  const auto pick = [&](int lo, int hi) { return std::uniform_int_distribution(lo, hi)(random); };
  const auto real = [&](double lo, double hi) {
    return std::uniform_real_distribution(lo, hi)(random);
  };
  Counts counts;
  std::vector<TriedSet> sets;
  for (int k = 0; k < 40 * (green + red) && (counts.green < green || counts.red < red); ++k) {
    PlanetarySpec set;
    const int sun = pick(15, 30), planet = pick(14, 34), off = pick(-1, 1);
    set.z(M::sun) = sun;
    set.z(M::planet) = planet;
    set.z(M::ring) = sun + 2 * planet + off;
    set.planets = pick(1, 4);
    set.normal_module = 2.0;
    set.profile_shift.each[0] = real(0.0, 0.6);
    set.profile_shift.each[3] = real(-0.2, 0.5);
    const bool want_red = k % 2 == 1 && counts.red < red;
    set.allowance.all = want_red ? real(0.0, 0.08) : real(-0.1, -0.03);
    if (pick(0, 1) == 1) set.center_distance.all = 2.0 * (sun + planet) / 2 + real(-0.2, 1.6);
    const auto graph = graph_of(set);
    const DriveInput input{*graph, {}};
    const auto drive = make_drive(input);
    if (!drive || !drive_layout(*drive)) continue;
    bool toothed = true;
    for (const auto& gear : drive->geometry.gears) toothed = toothed && gear && gear->tooth;
    if (!toothed) continue;
    const Verdict verdict = judge_drive(*drive, input);
    const bool reds = std::any_of(
        verdict.findings.begin(), verdict.findings.end(),
        [](const Finding& f) { return f.level == Level::red && bodies_overlap(f.code); });
    const std::string what = fmt::format(
        "{} {} {}, x {} {}, E {}, N {}", sun, planet, *set.z(M::ring), *set.profile_shift.each[0],
        *set.profile_shift.each[3], *set.allowance.all, set.planets);
    if (verdict.level == Level::green && counts.green < green) {
      ++counts.green;
      sets.push_back({*drive, true, what});
    } else if (reds && counts.red < red) {
      ++counts.red;
      sets.push_back({*drive, false, what + verdict.headline});
    }
  }
  std::vector<double> overlaps(sets.size());
  parallel_for(sets.size(), [&](std::size_t i) { overlaps[i] = overlap(sets[i].drive, steps); });
  for (std::size_t i = 0; i < sets.size(); ++i)
    EXPECT_EQ(overlaps[i] < kFineChords, sets[i].is_green) << overlaps[i] << ' ' << sets[i].what;
  return counts;
}

TEST(JudgeDrive, GreenSetsDoNotOverlapAndRedOnesDo) {
  const Counts counts = try_sets(1, 2, 2, 120);
  EXPECT_EQ(counts.green, 2);
  EXPECT_EQ(counts.red, 2);
}

TEST(LongJudgeDrive, ThreeHundredSets) {
  const Counts counts = try_sets(2, 300, 100, 360);
  EXPECT_EQ(counts.green, 300);
  EXPECT_EQ(counts.red, 100);
}

PlanetarySpec example() {
  PlanetarySpec set;
  set.z(M::sun) = 20;
  set.z(M::planet) = 25;
  set.z(M::ring) = 70;
  set.planets = 3;
  set.normal_module = 2.0;
  return set;
}

TEST(JudgeDrive, ASetWithoutTipDiametersRuns) {
  for (const double x : {0.0, 0.2, 0.4}) {
    PlanetarySpec set = example();
    set.profile_shift.each[0] = x;
    set.profile_shift.each[3] = 0.5 * x;
    const DriveInput input{*graph_of(set), {}};
    const auto drive = make_drive(input);
    ASSERT_TRUE(drive);
    const Verdict verdict = judge_drive(*drive, input);
    EXPECT_EQ(verdict.level, Level::green) << x << verdict.headline;
    EXPECT_NE(verdict.headline.find("There is no backlash"), std::string::npos);
    for (const Finding& f : verdict.findings)
      if (f.code == WarningCode::no_backlash) {
        EXPECT_EQ(f.level, Level::green);
        EXPECT_NE(f.message.find("planet"), std::string::npos) << f.message;
      }
  }
}

// The headline gives a thickness allowance and the backlash that a drive with this allowance has.
// With the allowance, the finding disappears. This law also holds for teeth that already have an
// allowance. Their centre distance is less than that of nominal teeth.
TEST(JudgeDrive, TheAllowanceInTheHeadlineGivesItsBacklash) {
  for (const double given : {0.0, -0.05}) {
    PlanetarySpec set = example();
    set.profile_shift.each[0] = set.profile_shift.each[3] = 0.0;
    set.allowance.all = given;
    const auto made = [&] { return *make_drive({*graph_of(set), {}}); };
    set.center_distance.all = made().geometry.pairs[0]->involute()->backlash_free_center_distance;
    const auto headline = [&] {
      const Verdict verdict = judge_drive(made(), {*graph_of(set), {}});
      const auto is_none = [](const Finding& f) { return f.code == WarningCode::no_backlash; };
      EXPECT_EQ(std::any_of(verdict.findings.begin(), verdict.findings.end(), is_none),
                set.allowance.all == given);
      return verdict.headline;
    };
    const std::string tight = headline();
    const auto number_after = [&](const std::string& words) {
      const auto at = tight.find(words);
      return at == std::string::npos ? 0.0 : std::stod(tight.substr(at + words.size()));
    };
    set.allowance.all = number_after("A thickness allowance of ");
    const double promised = number_after("on all gears gives a backlash of ");
    EXPECT_LT(*set.allowance.all, given) << tight;
    EXPECT_GE(promised, number_after("recommends at least "));
    EXPECT_NEAR(made().geometry.pairs[0]->stated_backlash().normal, promised, 0.5e-3 + 1e-9)
        << tight;
    EXPECT_NE(headline().find("The least backlash is "), std::string::npos) << headline();
  }
}

// If the backlash is greater than 0, the message does not print it as 0.
TEST(JudgeDrive, TheLeastBacklashIsPrintedWithItsDigits) {
  PlanetarySpec set = example();
  set.allowance.all = -0.00011;
  const DriveInput input{*graph_of(set), {}};
  const auto drive = make_drive(input);
  ASSERT_TRUE(drive);
  const double j = drive->geometry.pairs[0]->stated_backlash().normal;
  EXPECT_NEAR(j, 0.00022, 1e-6);
  const std::string headline = judge_drive(*drive, input).headline;
  EXPECT_NE(headline.find(fmt::format("The least backlash is {:.4f} mm.", j)), std::string::npos)
      << headline;
}

// The spec of this set has only eight lines. With large profile shifts, the tips have no clearance
// unless they are shortened.
TEST(JudgeDrive, EightLinesAreEnough) {
  PlanetarySpec set;
  set.z(M::sun) = 19;
  set.z(M::planet) = 17;
  set.z(M::ring) = 56;
  set.planets = 3;
  set.normal_module = 45.0;
  set.face_width.all = 491.0;
  set.center_distance.all = 863.0;
  const DriveInput input{*graph_of(set), {}};
  const auto drive = make_drive(input);
  ASSERT_TRUE(drive);
  const Verdict verdict = judge_drive(*drive, input);
  EXPECT_EQ(verdict.level, Level::green) << verdict.headline;
  // The clearance is 0.25 m_n, as for the racks.
  const auto& mesh = drive->geometry.pairs[0]->mounted();
  EXPECT_NEAR(mesh.tip_clearance[0], 0.25 * 45, 1e-9);
  EXPECT_NEAR(mesh.tip_clearance[1], 0.25 * 45, 1e-9);
}

TEST(JudgeDrive, ARemedyIsTriedOnTheWholeDrive) {
  PlanetarySpec set = example();
  set.profile_shift.each[0] = 0.2;
  set.profile_shift.each[3] = 0.1;
  set.tip_diameter.each[5] = 137.6;  // tip diameter of the ring, deeper than the flanks of the
                                     // planets
  DriveInput input{*graph_of(set), {}};
  const auto drive = make_drive(input);
  ASSERT_TRUE(drive);
  std::optional<DriveChange> named;
  const Verdict verdict = judge_drive(*drive, input, [&](const DriveChange& change) {
    named = change;
    return std::string("the.key");
  });
  EXPECT_EQ(verdict.level, Level::red);
  const Finding& worst = verdict.findings.front();
  EXPECT_NE(worst.message.find("planet_ring: The tip of ring"), std::string::npos) << worst.message;
  ASSERT_TRUE(named) << worst.whole();
  ASSERT_TRUE(worst.change);
  EXPECT_EQ(worst.change->path, "the.key");
  EXPECT_NE(worst.remedy.find("(the.key = "), std::string::npos) << worst.remedy;
  const auto again = changed(input, *named);
  ASSERT_TRUE(again);
  EXPECT_NE(judge_drive(*make_drive(*again), *again).level, Level::red);
}

}  // namespace
}  // namespace gearwright
