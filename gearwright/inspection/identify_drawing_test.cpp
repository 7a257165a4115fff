// Tests the values of the drawing that identify() finds: profile shift, thickness allowance, rack
// and tip. The readings are computed here from the formulas of spur gears, without the code of the
// library:
//
//   W_k = m cos α (π (k − 1/2) + z inv α) + 2 x_E m sin α      x_E = x + E_sn/(2 m tan α)
//   d_a = m (z + 2 h_aP* + 2 x)                               d_f = m (z − 2 h_fP* + 2 x_E)
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {
namespace {

struct SpurGear {
  int teeth;
  double module, degrees, shift, allowance;  // x, and E_sn in mm
  double addendum = 1.0, dedendum = 1.25;
};

double generating_shift_of(const SpurGear& g) {
  return g.shift + g.allowance / (2 * g.module * std::tan(g.degrees * kRadPerDeg));
}
double tip_of(const SpurGear& g) { return g.module * (g.teeth + 2 * g.addendum + 2 * g.shift); }
double root_of(const SpurGear& g) {
  return g.module * (g.teeth - 2 * g.dedendum + 2 * generating_shift_of(g));
}

IdentifyProblem spans_of(const SpurGear& g) {
  const double alpha = g.degrees * kRadPerDeg;
  const double inv = std::tan(alpha) - alpha;
  IdentifyProblem p;
  p.teeth = g.teeth;
  p.helix_angle = Angle::degrees(0);
  const int k = static_cast<int>(std::lround(g.teeth * g.degrees / 180 + 0.5));
  for (const int teeth : {k, k + 1}) {
    const double span =
        g.module * std::cos(alpha) * (std::numbers::pi * (teeth - 0.5) + g.teeth * inv) +
        2 * generating_shift_of(g) * g.module * std::sin(alpha);
    p.spans.push_back({teeth, span});
  }
  return p;
}

IdentifiedGear first_of(const IdentifyProblem& p) {
  return testing::taken(identify(p)).candidates.at(0);
}

constexpr double kPitch24 = kMmPerInch / 24, kPitch16 = kMmPerInch / 16;

// The pinion of DP 24 that a maker measured, with 0.00165 in of thinning.
SpurGear thinned_pinion() { return {32, kPitch24, 20, 0.0, -0.00165 * kMmPerInch}; }

// The thickness alone does not determine x and E_sn separately. If the allowance is usual, the spec
// has x = 0, with or without a reading of the tip.
TEST(IdentifyDrawing, thinning_is_an_allowance_and_no_profile_shift) {
  const SpurGear gear = thinned_pinion();
  IdentifyProblem p = spans_of(gear);
  for (const bool tip : {false, true}) {
    if (tip) p.tip.value = tip_of(gear) - 0.01;
    const IdentifiedGear found = first_of(p);
    EXPECT_EQ(found.profile_shift, 0.0) << tip;
    EXPECT_NEAR(found.thickness_allowance, gear.allowance, 1e-3) << tip;
    EXPECT_NEAR(found.generating_shift, generating_shift_of(gear), 1e-3) << tip;
    EXPECT_NEAR(found.tip_diameter, tip_of(gear), 1e-9) << tip;
  }
}

// The tip diameter depends on x and not on the allowance. A reading of the tip therefore determines
// x, although the thickness gives another x_E.
TEST(IdentifyDrawing, tip_separates_shift_and_allowance) {
  for (const double x : {-0.2, 0.25, 0.5}) {
    const SpurGear gear{25, 2.0, 20, x, -0.09};
    IdentifyProblem p = spans_of(gear);
    p.tip.value = tip_of(gear);
    const IdentifiedGear found = first_of(p);
    EXPECT_NEAR(found.profile_shift, x, 1e-9);
    EXPECT_NEAR(found.thickness_allowance, gear.allowance, 2e-3) << x;
  }
  // If no tip was measured, such a thickness is interpreted as a profile shift, because an
  // allowance would be positive or unusual.
  for (const double x : {-0.2, 0.25}) {
    const IdentifiedGear found = first_of(spans_of({25, 2.0, 20, x, 0.0}));
    EXPECT_EQ(found.profile_shift, found.generating_shift) << x;
    EXPECT_EQ(found.thickness_allowance, 0.0) << x;
  }
}

TEST(IdentifyDrawing, worn_tip_does_not_reduce_the_shift) {
  const SpurGear gear{25, 2.0, 20, 0.3, 0.0};
  IdentifyProblem p = spans_of(gear);
  p.tip.value = tip_of(gear) - 2 * 0.07 * gear.module;
  const IdentifiedGear worn = first_of(p);
  EXPECT_NEAR(worn.profile_shift, 0.3, 2e-3);
  EXPECT_EQ(worn.tip, TipReading::worn);
  EXPECT_NEAR(worn.tip_diameter, tip_of(gear), 0.01);
  p.tip.value = tip_of(gear) - 2 * 0.15 * gear.module;
  const IdentifiedGear shorter = first_of(p);
  EXPECT_NEAR(shorter.profile_shift, 0.3, 2e-3);
  EXPECT_EQ(shorter.tip, TipReading::shortened);
  EXPECT_EQ(shorter.tip_diameter, *p.tip.value);
}

TEST(IdentifyDrawing, tip_selects_stub_teeth) {
  const SpurGear stub{24, kPitch16, 20, 0.0, -0.05, 0.8, 1.0};
  IdentifyProblem p = spans_of(stub);
  p.tip.value = tip_of(stub) - 0.04;
  const IdentifiedGear found = first_of(p);
  EXPECT_EQ(found.rack, "AGMA-stub");
  EXPECT_EQ(found.profile_shift, 0.0);
  EXPECT_NEAR(found.thickness_allowance, stub.allowance, 2e-3);
  EXPECT_NEAR(found.tip_diameter, tip_of(stub), 1e-9);
  SpurGear full = stub;
  full.addendum = 1.0;
  p.tip.value = tip_of(full) - 0.04;
  EXPECT_EQ(first_of(p).rack, "AGMA-20");
}

TEST(IdentifyDrawing, root_selects_the_rack) {
  SpurGear gear{40, kPitch16, 14.5, 0.0, -0.05, 1.0, 1.157};
  IdentifyProblem p = spans_of(gear);
  p.tip.value = tip_of(gear);
  p.root.value = root_of(gear);
  const Identification old_inch = testing::taken(identify(p));
  EXPECT_EQ(old_inch.candidates.at(0).rack, "AGMA-14.5");
  EXPECT_NEAR(old_inch.candidates.at(0).root_diameter, root_of(gear), 5e-3);
  EXPECT_FALSE(old_inch.contradiction);
  for (const double depth : {1.25, 1.4}) {
    gear = {33, 3.0, 20, 0.2, 0.0, 1.0, depth};
    p = spans_of(gear);
    p.root.value = root_of(gear);
    EXPECT_EQ(first_of(p).rack, depth == 1.4 ? "ISO53-D" : "ISO53-A");
  }
}

TEST(IdentifyDrawing, root_that_no_rack_gives_is_a_contradiction) {
  const SpurGear gear{40, kPitch16, 14.5, 0.0, -0.05, 1.0, 1.157};
  IdentifyProblem p = spans_of(gear);
  p.tip.value = tip_of(gear);
  p.root.value = root_of(gear) - 1.2;
  const Identification found = testing::taken(identify(p));
  ASSERT_TRUE(found.contradiction);
  EXPECT_EQ(found.contradiction->reading, Reading::root_diameter);
  EXPECT_EQ(found.contradiction->value, *p.root.value);
  EXPECT_NEAR(found.contradiction->expected.value(), root_of(gear), 0.01);
  EXPECT_EQ(found.candidates.at(0).rack, "AGMA-14.5");
}

// Gears with neighbouring numbers of teeth have nearly the same spans. Only the tip shows that a
// number of teeth is wrong.
TEST(IdentifyDrawing, wrong_number_of_teeth_is_a_contradiction) {
  const SpurGear gear = thinned_pinion();
  for (const int teeth : {30, 31, 33, 34}) {
    IdentifyProblem p = spans_of(gear);
    p.tip.value = tip_of(gear);
    p.teeth = teeth;
    const Identification found = testing::taken(identify(p));
    ASSERT_TRUE(found.contradiction) << teeth;
    EXPECT_EQ(found.contradiction->reading, Reading::tip_diameter);
    ASSERT_TRUE(found.alternative) << teeth;
    EXPECT_EQ(found.alternative->mistake, Reading::teeth);
    EXPECT_EQ(found.alternative->gear.teeth, 32);
    EXPECT_NEAR(found.alternative->gear.normal_module, kPitch24, 1e-12);
    EXPECT_EQ(found.alternative->gear.profile_shift, 0.0);
  }
}

TEST(IdentifyDrawing, readings_in_the_other_unit_are_found) {
  const SpurGear gear = thinned_pinion();
  IdentifyProblem right = spans_of(gear);
  right.tip.value = tip_of(gear);
  EXPECT_FALSE(testing::taken(identify(right)).alternative);
  const auto expect = [](const IdentifyProblem& p, Reading mistake) {
    const Identification found = testing::taken(identify(p));
    ASSERT_TRUE(found.alternative) << static_cast<int>(mistake);
    EXPECT_EQ(found.alternative->mistake, mistake);
    EXPECT_NEAR(found.alternative->gear.normal_module, kPitch24, 1e-12);
    EXPECT_EQ(found.alternative->gear.profile_shift, 0.0);
  };
  for (const double factor : {25.4, 1 / 25.4}) {
    IdentifyProblem p = right;
    p.other_unit = 1 / factor;
    *p.tip.value *= factor;
    expect(p, Reading::tip_diameter);
    for (SpanReading& s : p.spans) s.value *= factor;
    expect(p, Reading::all);
  }
}

TEST(IdentifyDrawing, known_values_determine_the_others) {
  const SpurGear gear{25, 2.0, 20, 0.25, -0.09};
  IdentifyProblem p = spans_of(gear);
  p.profile_shift = 0.25;
  EXPECT_NEAR(first_of(p).thickness_allowance, -0.09, 2e-3);
  p.profile_shift.reset();
  p.thickness_allowance = -0.09;
  EXPECT_NEAR(first_of(p).profile_shift, 0.25, 2e-3);
  p.rack = StraightRack{.addendum = 0.9, .dedendum = 1.1};
  const IdentifiedGear found = first_of(p);
  EXPECT_EQ(found.rack, "");
  EXPECT_NEAR(found.tip_diameter, 2.0 * (25 + 1.8 + 0.5), 0.01);
}

}  // namespace
}  // namespace gearwright
