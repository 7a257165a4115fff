#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "gearwright/base/testing/named_limit.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

using namespace literals;

using By = TipFilletSpec::By;

// The pinion of the paper: 2 teeth, m_n 1.75 mm, λ 60°, x 0.7, a sharp rack.
CylindricalSpec two_teeth() {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = 2, .module = 1.75, .beta_deg = 30, .x = 0.7, .face_width = 20.0});
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  return s;
}

CylindricalSpec spur(int teeth, double shift) {
  return testing::plain_spec({.teeth = teeth, .module = 2.0, .x = shift, .face_width = 20.0});
}

CylindricalSpec with_root(CylindricalSpec s, double offset) {
  s.root_fillet = RootFilletSpec{offset};
  return s;
}

CylindricalSpec with_tip(CylindricalSpec s, By by, double value) {
  s.tip_fillet = TipFilletSpec{by, value};
  return s;
}

Gear made(const CylindricalSpec& s) { return testing::taken(make_gear(s)); }

// Returns the error message of a spec and checks its field. The message is empty if the gear can be
// made.
std::string refusal(const CylindricalSpec& s, const std::string& field) {
  const auto gear = make_gear(s);
  if (gear) return "";
  const Error& e = gear.error();
  EXPECT_EQ(e.field, field) << e.message();
  return e.message();
}

void expect_refused(const CylindricalSpec& s, const std::string& key) {
  const auto gear = make_gear(s);
  ASSERT_FALSE(gear) << key;
  EXPECT_EQ(gear.error().field, key) << gear.error().message();
}

void expect_stands(const CylindricalSpec& s) {
  const auto gear = make_gear(s);
  ASSERT_TRUE(gear) << gear.error().message();
  if (!gear->exists()) return;  // a severed tooth is not an error of the range
  EXPECT_EQ(gear->tooth->root_fillet.has_value(), s.root_fillet.has_value());
  EXPECT_EQ(gear->tooth->tip_fillet.has_value(), s.tip_fillet.has_value());
}

constexpr double kJust = 1e-9;

TEST(FlankRuler, measures_along_the_racks_flank) {
  for (const double beta : {0.0, 30.0}) {
    const auto edge = make_edge(StraightRack{}, 2.0, 20_deg);
    ASSERT_TRUE(edge);
    const double c = std::cos(beta * std::numbers::pi / 180);
    const RackMotion motion{7.0 / c, c, 0.6};
    const FlankRuler ruler = flank_ruler(edge->edge, motion);
    const auto flank = std::find_if(edge->edge.arcs.begin(), edge->edge.arcs.end(),
                                    [](const EdgeArc& a) { return a.cuts == ArcName::flank; });
    const auto* line = std::get_if<EdgeLine>(&flank->shape);
    ASSERT_NE(line, nullptr);
    const double cos_alpha = std::cos(std::numbers::pi / 9);
    for (const double l : {0.0, 0.5, 1.0, 3.0}) {
      const double x = line->begin_height + motion.shift + l * cos_alpha;
      EXPECT_NEAR(ruler.roll(l), rack_involute_roll(motion, *line, x), 1e-15 * 8);
      EXPECT_NEAR(ruler.l(ruler.roll(l)), l, 1e-14);
    }
    EXPECT_NEAR(ruler.roll(ruler.undercut_l()), 0.0, 1e-15 * 8);
    // l_F = (h_Ff − x m_n − r sin² α_t)/cos α_n. [T6.5]
    const double sin_t = std::sin(std::atan(std::tan(std::numbers::pi / 9) / c));
    const double l_F = (edge->edge.flank_begin_depth - 0.6 - 7.0 / c * sin_t * sin_t) / cos_alpha;
    EXPECT_NEAR(ruler.undercut_l(), l_F, 1e-14);
  }
}

// l_F > 0 is equivalent to undercut. A root fillet removes the undercut.
TEST(FewTeeth, undercut_length_has_the_sign_of_the_undercut) {
  for (const int teeth : {2, 3, 5, 8, 12, 17, 30}) {
    for (const double x : {-0.5, 0.0, 0.3, 0.7, 1.1}) {
      const Gear gear = made(spur(teeth, x));
      EXPECT_EQ(gear.undercut, *gear.involute()->undercut_l > 0.0) << teeth << " " << x;
      const auto filleted = make_gear(with_root(spur(teeth, x), 0.01));
      EXPECT_FALSE(filleted && filleted->undercut);
    }
  }
}

TEST(FewTeeth, point_c_is_the_undercut_limit_and_the_offset) {
  const Gear undercut = made(with_root(two_teeth(), 0.01));
  EXPECT_NEAR(*undercut.involute()->point_c_l, *undercut.involute()->undercut_l + 0.01, 1e-15 * 4);
  const Gear free = made(with_root(spur(12, 0.5), 0.05));
  EXPECT_LT(*free.involute()->undercut_l, 0.0);
  EXPECT_NEAR(*free.involute()->point_c_l, 0.05, 1e-15 * 8);
  EXPECT_FALSE(free.involute()->point_j_l);
  EXPECT_FALSE(free.tooth->tip_fillet);
  const Gear plain = made(two_teeth());
  EXPECT_FALSE(plain.involute()->point_c_l || plain.involute()->point_j_l);
}

TEST(FewTeeth, three_ways_to_name_a_tip_fillet) {
  const Gear by_radius = made(with_tip(two_teeth(), By::radius, 0.332));
  const Gear by_l = made(with_tip(two_teeth(), By::l, *by_radius.involute()->point_j_l));
  const Gear by_end = made(with_tip(two_teeth(), By::end_radius, by_radius.tip_diameter / 2));
  for (const Gear* g : {&by_l, &by_end}) {
    EXPECT_NEAR(g->tooth->tip_fillet->radius, 0.332, 1e-13);
    EXPECT_NEAR(*g->involute()->point_j_l, *by_radius.involute()->point_j_l, 1e-13);
    EXPECT_NEAR(g->tip_diameter, by_radius.tip_diameter, 1e-13);
  }
  EXPECT_TRUE(by_radius.tooth->rounded_tip);
  EXPECT_EQ(by_radius.tip_tooth_thickness_normal, 0.0);
  EXPECT_NEAR(by_radius.actual_tip_radius(), by_radius.tip_diameter / 2, 1e-15 * 8);
}

// A blank together with a fillet may cut off the end of the fillet, but never extends it.
TEST(FewTeeth, blank_and_tip_fillet) {
  CylindricalSpec s = with_tip(two_teeth(), By::radius, 0.332);
  const Gear whole = made(s);
  s.tip_diameter = whole.tip_diameter - 0.1;
  const Gear turned = made(s);
  EXPECT_FALSE(turned.tooth->rounded_tip);
  EXPECT_NEAR(turned.actual_tip_radius(), *s.tip_diameter / 2, 1e-15 * 8);
  EXPECT_GT(*turned.tip_tooth_thickness_normal, 0.0);
  s.tip_diameter = whole.tip_diameter + 0.1;
  EXPECT_NEAR(made(s).actual_tip_radius(), whole.tip_diameter / 2, 1e-15 * 8);
}

TEST(FewTeethRanges, greatest_offset_of_the_root_fillet) {
  for (CylindricalSpec s : {two_teeth(), spur(5, 0.4), spur(8, 0.3), spur(17, 0.0),
                            with_tip(two_teeth(), By::radius, 0.332)}) {
    const double most =
        named_limit([&](double x) { return refusal(with_root(s, x), "root_fillet.offset"); }, 1e3,
                    "must be less than ");
    ASSERT_GT(most, 0.0);
    expect_stands(with_root(s, most * (1 - kJust)));
    expect_refused(with_root(s, most * (1 + kJust)), "root_fillet.offset");
  }
}

TEST(FewTeethRanges, largest_radius_of_the_tip_fillet) {
  const char* key = "tip_fillet.radius";
  for (CylindricalSpec s : {spur(5, 0.4), spur(8, 0.3), spur(17, 0.0), spur(30, 0.2)}) {
    const double most = named_limit(
        [&](double x) { return refusal(with_tip(s, By::radius, x), key); }, 1e3, "and at most ");
    ASSERT_GT(most, 0.0);
    expect_stands(with_tip(s, By::radius, most * (1 - kJust)));
    expect_refused(with_tip(s, By::radius, most * (1 + kJust)), key);
  }
}

// The flank of the cutter ends before the point of the tooth, so a smaller circle touches no flank.
TEST(FewTeethRanges, least_radius_of_the_tip_fillet) {
  const char* key = "tip_fillet.radius";
  for (CylindricalSpec s : {spur(12, 0.0), spur(17, 0.0), spur(30, 0.2)}) {
    s.straight_rack().tool_addendum = 0.9;
    const double least = named_limit(
        [&](double x) { return refusal(with_tip(s, By::radius, x), key); }, 1e-6, "greater than ");
    ASSERT_GT(least, 0.0);
    expect_refused(with_tip(s, By::radius, least * (1 - kJust)), key);
    expect_stands(with_tip(s, By::radius, least * (1 + kJust)));
  }
}

TEST(FewTeethRanges, ends_of_the_place_of_the_tip_fillet) {
  const char* key = "tip_fillet.l";
  CylindricalSpec short_flank = spur(17, 0.0);
  short_flank.straight_rack().tool_addendum = 0.9;
  for (const CylindricalSpec& s : {two_teeth(), spur(5, 0.4), spur(17, 0.0), short_flank}) {
    const auto refused = [&](double x) { return refusal(with_tip(s, By::l, x), key); };
    const double least = named_limit(refused, -1e3, "between ");
    const double most = named_limit(refused, 1e3, "the flank, and ");
    ASSERT_GT(most, least);
    const double little = kJust * most;
    expect_stands(with_tip(s, By::l, most - little));
    expect_refused(with_tip(s, By::l, most + little), key);
    expect_stands(with_tip(s, By::l, least + little));
    expect_refused(with_tip(s, By::l, least - little), key);
  }
}

TEST(FewTeethRanges, ends_of_the_tip_that_a_fillet_can_make) {
  for (const CylindricalSpec& s : {two_teeth(), spur(5, 0.4), spur(17, 0.0), spur(30, 0.2)}) {
    const char* key = "tip_fillet.end_radius";
    const auto refused = [&](double x) { return refusal(with_tip(s, By::end_radius, x), key); };
    const double least = named_limit(refused, 1e-3, "between ");
    const double most = named_limit(refused, 1e3, " and ");
    ASSERT_GT(most, least);
    expect_stands(with_tip(s, By::end_radius, most * (1 - kJust)));
    expect_refused(with_tip(s, By::end_radius, most * (1 + kJust)), key);
    expect_stands(with_tip(s, By::end_radius, least * (1 + kJust)));
    expect_refused(with_tip(s, By::end_radius, least * (1 - kJust)), key);
  }
}

TEST(FewTeethRanges, what_never_fits) {
  // A tip inside the base circle leaves no flank that a fillet could touch.
  CylindricalSpec low = spur(17, 0.0);
  low.tip_diameter = 31.9;
  expect_refused(with_root(low, 0.0), "root_fillet.offset");
  // An internal gear has no rack. Its cutter determines its fillets.
  for (const char* key : {"root_fillet", "tip_fillet"}) {
    CylindricalSpec ring = spur(-60, 0.0);
    if (std::string(key) == "root_fillet") ring.root_fillet = RootFilletSpec{0.0};
    if (std::string(key) == "tip_fillet") ring.tip_fillet = TipFilletSpec{By::radius, 0.3};
    expect_refused(ring, key);
  }
}

}  // namespace
}  // namespace gearwright
