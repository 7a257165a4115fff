// Laws of drives with a rack: a rack moves by one pitch for each tooth of its pinion, and its
// backlash is its travel between the flanks.
#include <gtest/gtest.h>

#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {
namespace {

TEST(DriveRack, RackMovesOnePitchPerTooth) {
  DriveGraph graph;
  graph.bodies = {{"pinion", {}, 1, {}}, {"bar", {}, 1, {}}};
  graph.gears = {{"g", 0, 17, {}, {}, {}}, {"r", 1, 0, RackBar{}, {}, {}}};
  graph.meshes = {{"r_g", {1, 0}, 0.97, {}}};
  graph.inputs = {0};
  graph.output = 1;
  const auto drive = make_drive({graph, {}});
  ASSERT_TRUE(drive) << drive.error().message();
  EXPECT_TRUE(drive->motion.speeds[1][0] == Rational(17));
  EXPECT_NEAR(drive->flow->efficiency, 0.97, 1e-14);
}

// A wheel drives a pinion on the same shaft as the pinion of a rack. If the rack is held, the
// rotation of the wheel has two parts: the play of its own mesh, and the play of the rack between
// its flanks, divided by the reference radius of the pinion and by the ratio. If the wheel is held,
// the motion of the rack is the sum of both, measured along the rack.
TEST(DriveRack, BacklashOfARackIsTheTravelBetweenItsFlanks) {
  for (const bool rack_drives : {false, true}) {
    CylindricalSpec spec;
    spec.normal_module = 2.0;
    spec.helix_angle = Angle::degrees(12);
    spec.thickness_allowance = -0.04;
    CylindricalSpec wheel = spec;
    wheel.helix_angle = Angle::degrees(-12);
    DriveGraph graph;
    graph.bodies = {{"wheel", {}, 1, {}}, {"shaft", {}, 1, {}}, {"bar", {}, 1, {}}};
    graph.gears = {{"w", 0, 53, {}, wheel, 0.0},
                   {"p", 1, 19, {}, spec, 0.1},
                   {"q", 1, 17, {}, spec, 0.2},
                   {"r", 2, 0, RackBar{}, {}, {}}};
    graph.meshes = {{"w_p", {0, 1}, {}, {}}, {"q_r", {2, 3}, {}, {}}};
    graph.inputs = {0};
    graph.output = 2;
    if (rack_drives) std::swap(graph.inputs.front(), graph.output);
    const auto drive = make_drive({graph, {}});
    ASSERT_TRUE(drive) << drive.error().message();
    ASSERT_TRUE(drive->backlash);
    const RackPair& rack = *drive->geometry.racks[1];
    const auto& turns = drive->geometry.pairs[0]->involute()->mesh.backlash.rotation;
    const double r = rack.pinion.reference_diameter / 2;
    const double at_wheel = turns[0] + rack.circumferential_backlash() / r * 19 / 53;
    const double travel = r * turns[1] + rack.circumferential_backlash();
    const double lever = rack.rack.transverse_pitch / kTurn;
    const DriveBacklash& play = *drive->backlash;
    EXPECT_GT(rack.circumferential_backlash(), 0.03);
    EXPECT_NEAR(rack_drives ? play.output : play.input, at_wheel, 1e-13);
    EXPECT_NEAR(lever * (rack_drives ? play.input : play.output), travel, 1e-13);

    // With a given backlash, pinion and rack get half of the thinning each.
    graph.meshes[1].backlash = 0.15;
    const auto thinned = make_drive({graph, {}});
    ASSERT_TRUE(thinned) << thinned.error().message();
    const RackPair& play_rack = *thinned->geometry.racks[1];
    EXPECT_NEAR(play_rack.normal_backlash(), 0.15, 1e-12);
    EXPECT_NEAR(play_rack.rack.bar.thickness_allowance, -0.075, 1e-12);
    EXPECT_NEAR(play_rack.pinion.spec.thickness_allowance, -0.075, 1e-12);
  }
}

}  // namespace
}  // namespace gearwright
