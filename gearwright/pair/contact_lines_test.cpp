// Contact lines. Laws: (1) λ is the length that a count over thin slices of all teeth gives; (2)
// its least and greatest value are those of a fine sampling; (3) its mean is ε_α; (4) a whole ε_α
// or ε_β leaves no variation; (5) the least length is that of AGMA 908 and, for narrow helical
// gears, the number of tooth pairs of spur gears.
#include "gearwright/pair/contact_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gearwright {
namespace {

// Cuts every tooth into thin spur gears, each of which meshes later than the preceding one, and
// counts the slices in contact.
double counted(double transverse, double overlap, double turn) {
  constexpr int kSlices = 4000;
  int touching = 0;
  for (int tooth = -40; tooth <= 40; ++tooth)
    for (int s = 0; s < kSlices; ++s) {
      const double place = turn + tooth - overlap * (s + 0.5) / kSlices;
      if (place >= 0.0 && place < transverse) ++touching;
    }
  return static_cast<double>(touching) / kSlices;
}

TEST(ContactLines, AreTheSlicesInContact) {  // (1)
  std::mt19937 random(3);
  for (int n = 0; n < 40; ++n) {
    const double transverse = std::uniform_real_distribution(0.3, 3.5)(random);
    const double overlap = n % 4 == 0 ? 0.0 : std::uniform_real_distribution(0.05, 3.5)(random);
    const double turn = std::uniform_real_distribution(-2.0, 2.0)(random);
    const double slice = overlap > 0.0 ? 20.0 / 4000 : 0.0;  // at most 20 ends of lines are cut
    EXPECT_NEAR(contact_lines(transverse, overlap, turn), counted(transverse, overlap, turn), slice)
        << transverse << " " << overlap << " " << turn;
  }
}

TEST(ContactLines, LieBetweenTheirEnds) {  // (2), (3)
  std::mt19937 random(5);
  constexpr int kTurns = 20000;
  for (int n = 0; n < 200; ++n) {
    const double transverse = std::uniform_real_distribution(0.5, 3.5)(random);
    const double overlap = n % 5 == 0 ? 0.0 : std::uniform_real_distribution(0.02, 3.5)(random);
    double least = 1e300, greatest = 0.0, mean = 0.0;
    for (int i = 0; i < kTurns; ++i) {
      const double lines = contact_lines(transverse, overlap, (i + 0.5) / kTurns);
      least = std::min(least, lines);
      greatest = std::max(greatest, lines);
      mean += lines / kTurns;
    }
    // Per pitch of rotation, each moving end of a contact line changes λ by 1/ε_β. At most two ends
    // move at once.
    const double step = overlap > 0.0 ? 2.0 / kTurns / overlap : 1e-12;
    const auto range = contact_line_range(transverse, overlap);
    EXPECT_NEAR(range.least, least, step) << transverse << " " << overlap;
    EXPECT_NEAR(range.greatest, greatest, step) << transverse << " " << overlap;
    EXPECT_NEAR(mean, transverse, overlap > 0.0 ? step : 1.0 / kTurns);
  }
}

TEST(ContactLines, WholeRatiosLeaveNoVariation) {  // (4)
  for (const double whole : {1.0, 2.0, 3.0}) {
    EXPECT_EQ(deflection_variation(whole, 0.0), 0.0);
    for (const double part : {0.2, 0.7, 1.4}) {
      EXPECT_NEAR(*deflection_variation(whole, part), 0.0, 1e-15);
      EXPECT_NEAR(*deflection_variation(1.1 + part, whole), 0.0, 1e-15);
    }
  }
  EXPECT_FALSE(deflection_variation(0.8, 0.0));
  EXPECT_FALSE(deflection_variation(0.5, 0.4));
  EXPECT_TRUE(deflection_variation(0.8, 0.4));
}

TEST(ContactLines, HaveTheClosedFormsOfTheTextbook) {  // (5)
  // AGMA 908-B89: L_min cos β_b/b = ε_α − r_α r_β/ε_β for r_α + r_β ≤ 1,
  // else with 1 − r_α and 1 − r_β.
  EXPECT_NEAR(contact_line_range(1.4, 1.3).least, 1.4 - 0.4 * 0.3 / 1.3, 1e-15);
  EXPECT_NEAR(contact_line_range(1.7, 0.8).least, 1.7 - 0.3 * 0.2 / 0.8, 1e-15);
  const auto narrow = contact_line_range(1.6, 1e-9);
  EXPECT_NEAR(narrow.least, 1.0, 1e-6);
  EXPECT_NEAR(narrow.greatest, 2.0, 1e-6);
  // A spur pair deflects twice as much in single as in double contact.
  EXPECT_DOUBLE_EQ(*deflection_variation(1.6, 0.0), 1.6 / 2);
}

}  // namespace
}  // namespace gearwright
