// Law: the clearances of a member are equal to the clearances of a new pair with the same centre
// distance and the same thicknesses. Teeth without a closed form have no clearances.
#include "gearwright/scatter/member_clearances.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/pair/involute_pair.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using Q = ScatterQuantity;

const std::vector<ScatterTolerance>& housing_and_teeth() {
  static const std::vector<ScatterTolerance> list{
      testing::distance(0.05), testing::crossing(0.03),
      testing::tolerance("gear1.thickness_allowance_mm", 1.0, -0.04, 0.04, VaryingThickness{1}),
      testing::tolerance("gear2.thickness_allowance_mm", 1.0, -0.06, 0.06, VaryingThickness{2})};
  return list;
}

Pair pair_of(const testing::DrawnPair& drawn) {
  auto made = mount(*make_gear(drawn.gears[0]), *make_gear_with_default_cutter(drawn.gears[1]),
                    {.center_distance = drawn.center_distance});
  EXPECT_TRUE(made) << made.error().message();
  return std::move(made).take();
}

TEST(MemberClearances, AreThoseOfAPairMadeAnew) {
  auto undercut = testing::spur_pair(false);
  undercut.gears[0].teeth = 12;
  undercut.gears[0].profile_shift = 0.0;
  undercut.center_distance = 52.2;
  for (const auto& drawn : {testing::spur_pair(false), testing::crowned_helical_pair(),
                            testing::plain_helical_pair(), undercut, testing::ring_pair()}) {
    const ContactSetup setup = drawn.setup();
    const bool closed = drawn.gears[0].teeth != 12;
    const bool ring = drawn.gears[1].teeth < 0;
    for (const auto& x :
         {std::vector{0.0, 0.0, 0.0, 0.0}, std::vector{0.03, 0.02, 0.0, 0.0},
          std::vector{-0.04, 0.01, 0.033, -0.05}, std::vector{0.05, -0.03, -0.04, 0.06}}) {
      auto made = drawn;
      made.center_distance += x[0];
      made.gears[0].thickness_allowance += x[2];
      // The cutter of a ring follows from its thickness, so the root of a ring has no closed form.
      if (!ring) made.gears[1].thickness_allowance += x[3];
      const Pair pair = pair_of(made);
      const auto c = clearances_of(setup, deviation_at(setup, housing_and_teeth(), x));
      for (std::size_t i = 0; i < 2; ++i) {
        const bool changed_ring = ring && x[3] != 0.0;
        ASSERT_EQ(c.tip[i].has_value(), !(changed_ring && i == 0));
        if (c.tip[i]) {
          EXPECT_NEAR(*c.tip[i], pair.mounted().tip_clearance[i], 1e-12);
        }
        // For undercut teeth, the closed form applies only to the thickness of the drawing.
        const auto& form = pair.parallel()->form_clearance[i];
        if (!form || (!closed && i == 0 && x[2] != 0.0) || (changed_ring && i == 1)) {
          EXPECT_FALSE(c.form[i]);
        } else {
          EXPECT_NEAR(*c.form[i], *form, 1e-12) << i;
        }
      }
    }
  }
}

TEST(MemberClearances, RoundedTeethVaryWithTheDistanceOnly) {
  auto drawn = testing::spur_pair(false);
  drawn.gears[0].root_fillet = RootFilletSpec{};
  const ContactSetup setup = drawn.setup();
  const auto fixed = clearances_of(
      setup, deviation_at(setup, housing_and_teeth(), std::vector{0.02, 0.0, 0.0, 0.01}));
  auto made = drawn;
  made.center_distance += 0.02;
  made.gears[1].thickness_allowance += 0.01;
  const Pair pair = pair_of(made);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(*fixed.tip[i], pair.mounted().tip_clearance[i], 1e-12);
  const auto thick = clearances_of(
      setup, deviation_at(setup, housing_and_teeth(), std::vector{0.02, 0.0, 0.01, 0.0}));
  EXPECT_FALSE(thick.tip[1]);
  EXPECT_TRUE(thick.tip[0]);
  EXPECT_FALSE(thick.form[0]);
}

// c = c_0 + ΔC + shifts of the roots is a sum of uniform inputs. Tip 1 moves away from root 2 by ΔC
// − ΔE_sn2/(2 tan α_n).
TEST(MemberClearances, HaveTheDistributionOfTheirSum) {
  const ContactSetup setup = testing::spur_pair(false).setup();
  ScatterTask task;
  task.tolerances = {
      testing::distance(0.05),
      testing::tolerance("gear2.thickness_allowance_mm", 1.0, -0.03, 0.03, VaryingThickness{2})};
  task.groups = {{"a", {0}}, {"b", {1}}};
  task.member.positions = 2;
  task.samples = 256;
  task.replicates = 4;
  task.percentiles = {5, 50, 95};
  task.indices = true;
  const auto scatter = scatter_of(setup, task);
  ASSERT_TRUE(scatter);
  const auto at = static_cast<std::size_t>(Q::tip_clearance1);
  const Spread& tip = *scatter->spread[at];
  const double drawn =
      *member_at(setup, deviation_at(setup, {}, {}), task.member)[Q::tip_clearance1];
  const double a = 0.05;
  const double b = 0.03 / (2 * std::tan(20 * kRadPerDeg));
  EXPECT_NEAR(tip.standard_deviation.value, std::sqrt((a * a + b * b) / 3), 1e-4);
  // The tail of the sum of two uniform numbers: P(> a + b − t) = t²/(8ab) for t ≤ 2 min(a, b).
  const double tail = std::sqrt(0.05 * 8 * a * b);
  for (const auto& [i, exact] :
       {std::pair{0, drawn - (a + b - tail)}, {1, drawn}, {2, drawn + (a + b - tail)}}) {
    const Estimate& e = tip.percentiles[static_cast<std::size_t>(i)].estimate;
    EXPECT_NEAR(e.value, exact, 4 * *e.standard_error);
    EXPECT_LT(*e.standard_error, 1e-3);
  }
  ASSERT_TRUE(scatter->indices[at]);
  EXPECT_NEAR(scatter->indices[at]->total[0].value, a * a / (a * a + b * b), 0.02);
  ASSERT_TRUE(scatter->indices[at]->linear_share);
  EXPECT_NEAR(*scatter->indices[at]->linear_share, 1.0, 1e-9);
  // The clearance between the root of gear 1 and the tip of gear 2 depends only on the centre
  // distance.
  const auto& other = scatter->indices[static_cast<std::size_t>(Q::tip_clearance2)];
  ASSERT_TRUE(other);
  EXPECT_EQ(other->total[1].value, 0.0);
}

}  // namespace
}  // namespace gearwright
