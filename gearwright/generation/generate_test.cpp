#include "gearwright/generation/generate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/testing/joined_outline.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {
namespace {

using namespace literals;
using testing::expect_joined;
using testing::names;

// The type is not an aggregate. An aggregate of C++20 would accept some of the members and leave
// the others 0.
static_assert(!std::is_constructible_v<GeneratedTooth, Outline>);

struct Cut {
  int teeth = 20;
  double shift = 0.0;  // modules
  StraightRack rack = {};
  double blank = kInfinity;  // radius in modules, default r + 1 + shift
  Angle beta = 0_deg;
  Angle alpha = 20_deg;
};

double pitch_radius(const Cut& cut) { return cut.teeth / (2 * std::cos(cut.beta.rad())); }

GeneratedTooth tooth_of(const Cut& cut) {
  const double r = pitch_radius(cut);
  const double blank = std::isinf(cut.blank) ? r + 1 + cut.shift : cut.blank;
  auto edge = make_edge(cut.rack, 1.0, cut.alpha);
  EXPECT_TRUE(edge);
  auto tooth = cut_by_rack(edge->edge, {r, std::cos(cut.beta.rad()), cut.shift}, cut.teeth, blank);
  EXPECT_TRUE(tooth);
  return std::move(tooth).take();
}

using enum ArcName;

TEST(CutByRack, plain_tooth) {
  const GeneratedTooth tooth = tooth_of({.teeth = 30});
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, flank, tip_land}));
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_EQ(tooth.root_radius, 15 - 1.25);
  EXPECT_EQ(tooth.tip_radius, 16.0);
  EXPECT_EQ(tooth.tip_form_radius, 16.0);
  EXPECT_FALSE(tooth.pointed || tooth.severed || tooth.through_axis || tooth.tip_cut_by_rack);
  // Without undercut, the flank starts where the rounding ends: x = −h_Ff, ξ = (r sin²α + x)/(r sin
  // α cos α).
  const double s = std::sin(std::numbers::pi / 9), c = std::cos(std::numbers::pi / 9);
  const double xi = (15 * s * s - (1.25 - 0.38 * (1 - s))) / (15 * s * c);
  EXPECT_NEAR(*tooth.form_radius, 15 * c * std::hypot(1.0, xi), 1e-13);
}

TEST(CutByRack, undercut_tooth_starts_above_its_base_circle) {
  const GeneratedTooth tooth = tooth_of({.teeth = 8});
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_GT(*tooth.form_radius, 4 * std::cos(std::numbers::pi / 9) * (1 + 1e-3));
  EXPECT_LT(*tooth.neck_radius, *tooth.form_radius);
  EXPECT_GT(tooth.neck_half_angle->rad(), 0.0);
}

TEST(CutByRack, full_radius_has_no_root_land) {
  Cut cut;
  cut.rack.root_fillet_radius = full_radius(cut.rack, cut.alpha);
  const GeneratedTooth tooth = tooth_of(cut);
  EXPECT_EQ(names(tooth), (std::vector{root_fillet, flank, tip_land}));
  EXPECT_NEAR(
      std::atan2(tooth.outline.arcs[0].begin_point.y(), tooth.outline.arcs[0].begin_point.x()),
      std::numbers::pi / 20, 1e-15);
}

TEST(CutByRack, bottom_rounding_ends_on_the_land) {
  Cut cut;
  cut.rack.tip_fillet_radius = 0.2;
  cut.blank = 12.0;
  const GeneratedTooth tooth = tooth_of(cut);
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, flank, tip_fillet, tip_land}));
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_TRUE(tooth.tip_cut_by_rack);
  EXPECT_NEAR(tooth.tip_radius, 11.0, 1e-14);
  EXPECT_LT(*tooth.tip_form_radius, 11.0);
  // The outline is tangent to the land, which it joins without a corner.
  const Arc& fillet = tooth.outline.arcs[3];
  const CurvePoint end = fillet.at(1.0);
  EXPECT_NEAR(std::abs(std::sin(end.tangent_angle - fillet.curve->polar_angle(fillet.end))), 1.0,
              1e-12);
}

TEST(CutByRack, semi_topping_cuts_a_chamfer) {
  Cut cut;
  cut.rack.tool_addendum = 0.7;
  cut.rack.semi_topping_angle = 45_deg;
  const GeneratedTooth tooth = tooth_of(cut);
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, flank, tip_fillet, tip_land}));
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_LT(*tooth.tip_form_radius, tooth.tip_radius);
  EXPECT_FALSE(tooth.tip_cut_by_rack);
}

TEST(CutByRack, protuberance_gives_the_root_two_fillet_arcs) {
  Cut cut;
  // With fewer teeth, the flank would start above the part that the protuberance cuts.
  cut.teeth = 120;
  cut.rack.dedendum = 1.4;
  cut.rack.root_fillet_radius = 0.3;
  cut.rack.protuberance = 0.05;
  const GeneratedTooth tooth = tooth_of(cut);
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, root_fillet, flank, tip_land}));
  expect_joined(tooth, tooth.tip_radius);
}

TEST(CutByRack, pointed_tooth_ends_on_its_centre_line) {
  const GeneratedTooth tooth = tooth_of({.teeth = 12, .shift = 1.2, .blank = 20.0});
  EXPECT_TRUE(tooth.pointed);
  EXPECT_EQ(names(tooth).back(), flank);
  EXPECT_EQ(tooth.outline.arcs.back().end_point, Vec2(tooth.tip_radius, 0.0));
  EXPECT_LT(tooth.tip_radius, 20.0);
  EXPECT_FALSE(tooth.tip_cut_by_rack);
}

TEST(CutByRack, severed_tooth_has_flags_and_no_arcs) {
  const GeneratedTooth tooth = tooth_of({.teeth = 4, .shift = -0.6});
  EXPECT_TRUE(tooth.severed);
  EXPECT_TRUE(tooth.outline.arcs.empty());
  EXPECT_LE(tooth.neck_half_angle->rad(), 0.0);
}

TEST(CutByRack, through_the_axis) {
  const GeneratedTooth tooth = tooth_of({.teeth = 2, .shift = 0.1});
  EXPECT_TRUE(tooth.through_axis);
  EXPECT_LT(tooth.root_radius, 0.0);
  EXPECT_TRUE(tooth.outline.arcs.empty());
}

TEST(CutByRack, a_blank_below_the_root_is_an_error) {
  const auto edge = make_edge(StraightRack{}, 1.0, 20_deg);
  const auto tooth = cut_by_rack(edge->edge, {10.0, 1.0, 0.0}, 20, 8.75);
  ASSERT_FALSE(tooth);
  EXPECT_EQ(tooth.error().field, "tip_diameter");
}

// The profile shift is within 4 ulp of the limit of undercut. The loop between fillet and flank is
// then smaller than rounding, and the two arcs must join without it.
TEST(CutByRack, undercut_begins_within_rounding) {
  for (const int teeth : {1, 4, 8, 12, 17, 40}) {
    for (const double rho : {0.0, 0.2, 0.38}) {
      Cut cut;
      cut.teeth = teeth;
      cut.rack.root_fillet_radius = rho;
      const double s = std::sin(std::numbers::pi / 9);
      double shift = 1.25 - rho * (1 - s) - teeth * s * s / 2;
      for (int i = 0; i < 4; ++i) shift = std::nextafter(shift, -kInfinity);
      for (int i = 0; i < 8; ++i) {
        cut.shift = shift;
        const GeneratedTooth tooth = tooth_of(cut);
        expect_joined(tooth, tooth.tip_radius);
        ASSERT_TRUE(tooth.form_radius);
        EXPECT_NEAR(*tooth.form_radius, teeth * std::cos(std::numbers::pi / 9) / 2, 1e-9);
        shift = std::nextafter(shift, kInfinity);
      }
    }
  }
}

// The trochoid has removed the whole flank. It meets the branch that the bottom rounding of the
// cutter cuts, and does not extend past it.
TEST(CutByRack, fillet_that_swallows_the_flank_meets_the_bottom_rounding) {
  Cut cut;
  cut.teeth = 3;
  cut.alpha = 14.5_deg;
  cut.shift = -0.7577065200119832;
  cut.rack.dedendum = 0.3139653716727288;
  cut.rack.root_fillet_radius = 0.2208798950586156;
  cut.rack.tip_fillet_radius = 0.19755959119300553;
  const GeneratedTooth tooth = tooth_of(cut);
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, tip_fillet, tip_land}));
  EXPECT_FALSE(tooth.form_radius);
  // The two branches cross. Below the intersection the fillet is the inner branch, above it the
  // rounding.
  const Arc& fillet = tooth.outline.arcs[1];
  const Arc& tip = tooth.outline.arcs[2];
  const auto theta = [](const Arc& arc, double rho) {
    return arc.curve->polar_angle(arc.curve->parameter_at_radius(rho, arc.begin, arc.end));
  };
  const double rho = fillet.end_point.norm();
  EXPECT_NEAR(theta(fillet, rho), theta(tip, rho), 1e-13);
}

// The protuberance is smaller than the height of the rounding, so it has no straight part. Rounding
// and flank intersect once.
TEST(CutByRack, small_protuberance) {
  Cut cut;
  cut.teeth = 6;
  cut.alpha = 17.5_deg;
  cut.shift = 1.1;
  cut.rack.dedendum = 1.0;
  cut.rack.root_fillet_radius = 0.1988488476725295;
  cut.rack.protuberance = 0.002605061802482456;
  cut.rack.protuberance_angle = 3.3_deg;
  const GeneratedTooth tooth = tooth_of(cut);
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_EQ(names(tooth)[2], flank);
}

// The extended line of the protuberance would cross the flank only above the blank, so this
// crossing must have no effect.
TEST(CutByRack, what_happens_above_the_blank_does_not_matter) {
  Cut cut;
  cut.teeth = 61;
  cut.alpha = Angle::degrees(6.568760937718309);
  cut.shift = 0.4739770071379429;
  cut.rack.dedendum = 0.5739770071379429;
  cut.rack.root_fillet_radius = 0.35507953690159344;
  cut.rack.protuberance = 0.03760013440653818;
  cut.rack.protuberance_angle = Angle::degrees(1.3406326382672307);
  cut.blank = pitch_radius(cut) + 0.9064868547747107 + cut.shift;
  const GeneratedTooth tooth = tooth_of(cut);
  expect_joined(tooth, tooth.tip_radius);
  EXPECT_EQ(names(tooth), (std::vector{root_land, root_fillet, tip_land}));
}

// A neck far above the blank does not belong to the tooth. A neck below the blank severs the tooth.
TEST(CutByRack, neck_is_sought_below_the_tip) {
  Cut cut;
  cut.teeth = 4;
  cut.alpha = 14.5_deg;
  cut.beta = Angle::degrees(2.647567830680842);
  cut.shift = -0.4969173973618578;
  cut.rack.dedendum = 1.0;
  cut.rack.root_fillet_radius = 0.0;
  cut.rack.protuberance = 0.056717576414342066;
  cut.rack.protuberance_angle = Angle::degrees(13.40306862593172);
  cut.rack.tool_addendum = 2.4458248713897994;
  const GeneratedTooth tooth = tooth_of(cut);
  EXPECT_TRUE(tooth.severed);
  EXPECT_LT(*tooth.neck_radius, tooth.tip_radius);
}

}  // namespace
}  // namespace gearwright
