#include "gearwright/pair/pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/testing/violation.hpp"
#include "gearwright/contact/compensation.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/design/few_teeth_design.hpp"
#include "gearwright/design/fit.hpp"
#include "gearwright/design/search_problem.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {
namespace {

using namespace literals;

// The type is not an aggregate. C++20 would accept values for some members of an aggregate and set
// the others to 0.
static_assert(!std::is_constructible_v<InvolutePair, MountedGears>);
static_assert(!std::is_constructible_v<ArcPair, MountedGears>);
static_assert(!std::is_constructible_v<ParallelPair, InvolutePair>);
static_assert(!std::is_constructible_v<CrossedPair, InvolutePair>);
static_assert(!std::is_constructible_v<MountedGears, double>);
static_assert(!std::is_constructible_v<Pair, Gear>);

// Each kind of pair is a type, so a function for parallel axes accepts no other pair. A number
// without a unit is not an angle, so {.shaft_angle = 90} does not compile.
static_assert(std::is_invocable_v<decltype(axial_force), const ParallelPair&>);
static_assert(!std::is_invocable_v<decltype(axial_force), const CrossedPair&>);
static_assert(!std::is_invocable_v<decltype(face_width_needed), const CrossedPair&>);
static_assert(!std::is_invocable_v<decltype(axial_force), const ArcPair&>);
static_assert(!std::is_invocable_v<decltype(axial_force), const Pair&>);
static_assert(!std::is_invocable_v<decltype(fillet_clearance), const ArcPair&, int>);
static_assert(!std::is_convertible_v<ArcPair, InvolutePair>);
static_assert(!std::is_convertible_v<InvolutePair, ArcPair>);
static_assert(!std::is_convertible_v<ParallelPair, CrossedPair>);
static_assert(!std::is_convertible_v<MountedGears, Pair>);

template <class T>
concept IsShaftAngle = requires(T angle) {
  PairSpec{.shaft_angle = angle};
};
static_assert(IsShaftAngle<Angle>);
static_assert(!IsShaftAngle<int>);
static_assert(!IsShaftAngle<double>);

template <class Struct, class Member>
constexpr bool takes_a_number(Member Struct::*) {
  return std::is_assignable_v<Member&, double>;
}
static_assert(takes_a_number(&PairSpec::center_distance));
static_assert(!takes_a_number(&PairSpec::shaft_angle));
static_assert(!takes_a_number(&PairPlace::shaft_angle));
static_assert(!takes_a_number(&CylindricalSpec::helix_angle));
static_assert(!takes_a_number(&CylindricalSpec::normal_pressure_angle));
static_assert(!takes_a_number(&ContactErrors::crossing));
static_assert(!takes_a_number(&ContactErrors::intersecting));
static_assert(!takes_a_number(&ContactMount::axis_angle));
static_assert(!takes_a_number(&ContactPoint::te));
static_assert(!takes_a_number(&CompensationTask::centering));
static_assert(!takes_a_number(&FitProblem::shaft_angle));
static_assert(!takes_a_number(&FewTeethProblem::helix));
static_assert(!takes_a_number(&SearchProblem::shaft_angle));
static_assert(!takes_a_number(&SearchProblem::normal_pressure_angle));

Gear gear(int teeth, const Rack& rack, Angle beta) {
  CylindricalSpec s = testing::plain_spec({.teeth = teeth, .module = 4.0, .face_width = 60.0});
  s.helix_angle = beta;
  s.rack = rack;
  return testing::taken(make_gear(s));
}

TEST(Mount, two_involute_gears_are_an_involute_pair) {
  const auto pair = mount(gear(20, StraightRack{}, 20_deg), gear(40, StraightRack{}, -20_deg));
  ASSERT_TRUE(pair) << pair.error().message();
  ASSERT_TRUE(pair->involute());
  EXPECT_EQ(pair->involute(), pair->parallel());
  EXPECT_FALSE(pair->arcs());
  EXPECT_FALSE(pair->crossed());
  EXPECT_EQ(pair->gear(2).spec.teeth, 40);
  for (const int which : {-1, 0, 3}) GW_EXPECT_VIOLATION(pair->gear(which));
  EXPECT_EQ(pair->gear_ratio(), 2.0);
  EXPECT_EQ(pair->contact_ratio(), pair->involute()->contact_ratio());
  // If no centre distance is given, the pair is free of backlash.
  EXPECT_NEAR(pair->center_distance(), *pair->involute()->backlash_free_center_distance, 1e-12);
  EXPECT_NEAR(pair->involute()->mesh.backlash.normal, 0.0, 1e-12);
}

// If neither distance nor shaft angle is given and parallel axes are impossible, the pair has the
// shaft angle of the least centre distance.
TEST(Mount, helices_of_one_hand_cross) {
  const auto pair = mount(gear(20, StraightRack{}, 45_deg), gear(30, StraightRack{}, 45_deg));
  ASSERT_TRUE(pair) << pair.error().message();
  ASSERT_TRUE(pair->crossed());
  EXPECT_EQ(pair->involute(), pair->crossed());
  EXPECT_FALSE(pair->parallel());
  EXPECT_EQ(pair->kind(), PairKind::crossed);
  EXPECT_NEAR(pair->shaft_angle().deg(), 90.0, 1e-12);
  EXPECT_EQ(pair->shaft_angle().rad(), *pair->involute()->input.shaft_angle);
  const auto forced =
      mount(gear(20, StraightRack{}, 45_deg), gear(30, StraightRack{}, 45_deg), {200.0, {}, {}});
  EXPECT_FALSE(forced);  // parallel axes are required
}

TEST(Mount, two_arc_gears_are_an_arc_pair) {
  const auto pair = mount(gear(18, DoubleArcRack{}, 22_deg), gear(50, DoubleArcRack{}, -22_deg));
  ASSERT_TRUE(pair) << pair.error().message();
  ASSERT_TRUE(pair->arcs());
  EXPECT_FALSE(pair->involute());
  EXPECT_EQ(pair->kind(), PairKind::parallel_external);
  EXPECT_EQ(pair->center_distance(), pair->arcs()->reference_center_distance);
  EXPECT_EQ(pair->contact_ratio(), pair->arcs()->contact_ratio());
  EXPECT_EQ(pair->shaft_angle(), 0_deg);
  EXPECT_EQ(pair->pose_2().isometry().translation().x(), pair->center_distance());
}

TEST(Mount, kinds_do_not_mix) {
  const Gear involute = gear(20, StraightRack{}, 20_deg);
  const Gear arcs = gear(40, DoubleArcRack{}, -20_deg);
  for (const auto& pair : {mount(involute, arcs, {125.0, {}, {}}), mount(arcs, involute)}) {
    ASSERT_FALSE(pair);
    EXPECT_NE(pair.error().message().find("does not mesh"), std::string::npos);
  }
  EXPECT_EQ(mount(involute, arcs).error().field, "gear1.rack");
  EXPECT_EQ(mount(arcs, arcs, {125.0, 90_deg, {}}).error().field, "pair.shaft_angle");
  GW_EXPECT_VIOLATION(
      static_cast<void>(mount_as<CrossedPair>(involute, gear(40, StraightRack{}, -20_deg))));
}

}  // namespace
}  // namespace gearwright
