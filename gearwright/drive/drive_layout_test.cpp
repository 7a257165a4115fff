// Laws: (1) at the start and after any motion every copy of every mesh has a tooth opposite a
// space, [T13.15c]; (2) clocked planets have the clocking of [T13.14]; (3) gears that would cut
// each other in one plane do not share a slot; (4) after turns_until_alike() every gear has moved
// by whole teeth; (5) the two places of an idler are mirror images.
#include "gearwright/drive/drive_layout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

PlanetarySpec toothed_set(const std::vector<std::pair<M, int>>& teeth, int planets) {
  PlanetarySpec set;
  for (const auto& [member, z] : teeth) set.z(member) = z;
  set.planets = planets;
  set.normal_module = 2.0;
  set.allowance.all = -0.05;
  return set;
}

Drive laid_drive(const PlanetarySpec& set) {
  return testing::taken(make_drive({testing::taken(graph_of(set)), {}}));
}

DriveLayout laid(const Drive& drive) { return testing::taken(drive_layout(drive)); }

// The distance of the nearest tooth of a gear from a direction, in pitches: 0 for a tooth, 0.5 for
// a space. All teeth are compared.
double tooth_against(const Drive& drive, const PlacedGear& placed, double angle,
                     const Vec2& towards) {
  const int z = std::abs(drive.graph.gears[placed.gear].teeth);
  double best = 1.0;
  for (int k = 0; k < z; ++k) {
    const double tooth = angle + kTurn * k / z;
    const double off =
        std::remainder(std::atan2(towards.y(), towards.x()) - tooth, kTurn) * z / kTurn;
    if (std::abs(off) < std::abs(best)) best = off;
  }
  return best;
}

// The greatest deviation of any mesh from the position in which a tooth is opposite a space, in
// pitches.
double worst_mesh(const Drive& drive, const DriveLayout& layout) {
  double worst = 0.0;
  for (const DriveMesh& mesh : drive.graph.meshes) {
    for (std::size_t i = 0; i < layout.gears.size(); ++i) {
      for (std::size_t k = 0; k < layout.gears.size(); ++k) {
        const PlacedGear &a = layout.gears[i], &b = layout.gears[k];
        if (a.gear != mesh.gears[0] || b.gear != mesh.gears[1]) continue;
        const bool riders = drive.graph.bodies[drive.graph.gears[a.gear].body].count > 1 &&
                            drive.graph.bodies[drive.graph.gears[b.gear].body].count > 1;
        if (riders && a.copy != b.copy) continue;
        const bool ring = drive.graph.gears[b.gear].teeth < 0;
        const double height = a.height;
        const double one = tooth_against(drive, a, layout.angle_at(drive, i, height),
                                         ring ? a.axis - b.axis : Vec2(b.axis - a.axis));
        const double two =
            tooth_against(drive, b, layout.angle_at(drive, k, height), a.axis - b.axis);
        // As a mesh turns, the tooth positions of two external gears change in opposite senses. The
        // tooth positions of a gear and its ring change in the same sense.
        const double off = std::remainder(one + (ring ? -two : two) - 0.5, 1.0);
        worst = std::max(worst, std::abs(off));
      }
    }
  }
  return worst;
}

std::vector<PlanetarySpec> sets() {
  PlanetarySpec helical = toothed_set({{M::sun, 21}, {M::planet, 33}, {M::ring, 87}}, 4);
  helical.helix_deg.all = 11.0;
  PlanetarySpec clocked =
      toothed_set({{M::sun, 17}, {M::planet, 31}, {M::planet2, 13}, {M::ring2, 61}}, 3);
  clocked.fixed = {{"ring2"}};
  clocked.spacing = Spacing::equal_clocked;
  PlanetarySpec joint = toothed_set(
      {{M::sun, 12}, {M::planet, 24}, {M::planet2, 21}, {M::ring, 60}, {M::ring2, 57}}, 3);
  joint.output = "ring2";
  PlanetarySpec ravigneaux =
      toothed_set({{M::sun, 28}, {M::idler, 22}, {M::planet, 22}, {M::sun2, 38}, {M::ring, 82}}, 3);
  ravigneaux.fixed = {{"carrier"}};
  ravigneaux.output = "ring";
  PlanetarySpec clockwise = ravigneaux;
  clockwise.idler_side = IdlerSide::clockwise;
  PlanetarySpec idler =
      toothed_set({{M::sun, 26}, {M::idler, 17}, {M::planet, 17}, {M::ring, 80}}, 3);
  idler.idler_side = IdlerSide::clockwise;
  return {toothed_set({{M::sun, 20}, {M::planet, 25}, {M::ring, 70}}, 3),
          toothed_set({{M::sun, 19}, {M::planet, 17}, {M::ring, 53}}, 5),
          helical,
          clocked,
          joint,
          ravigneaux,
          clockwise,
          idler};
}

TEST(DriveLayout, AllMeshesMeetAtAllTimes) {
  for (const PlanetarySpec& set : sets()) {
    const Drive drive = laid_drive(set);
    const DriveLayout layout = laid(drive);
    for (const double turns : {0.0, 0.137, 2.81}) {
      EXPECT_LT(worst_mesh(drive, turned(drive, layout, turns)), 1e-6)
          << drive.graph.gears.size() << " gears, after " << turns;
    }
  }
}

// Law (5). Only the angle of the idler changes its sign, and with it the direction of its mesh.
TEST(DriveLayout, TheSidesOfAnIdlerAreMirrorImages) {
  PlanetarySpec set =
      toothed_set({{M::sun, 26}, {M::idler, 17}, {M::planet, 17}, {M::ring, 80}}, 3);
  set.positions_deg = {0.0, 120.0, 240.0};
  const Drive left = laid_drive(set);
  set.idler_side = IdlerSide::clockwise;
  const Drive right = laid_drive(set);
  const DriveLayout one = laid(left), two = laid(right);
  double off_line = 0.0;
  for (std::size_t b = 0; b < left.graph.bodies.size(); ++b) {
    EXPECT_EQ(one.places.axes[b].x(), two.places.axes[b].x());
    EXPECT_EQ(one.places.axes[b].y(), -two.places.axes[b].y());
    off_line = std::max(off_line, one.places.axes[b].y());
  }
  EXPECT_GT(off_line, 10.0);
  EXPECT_EQ(left.sets[0].assembly.places, right.sets[0].assembly.places);
  EXPECT_NEAR(left.sets[0].neighbours->clearance, right.sets[0].neighbours->clearance, 1e-12);
  EXPECT_EQ(left.sets[0].neighbours->most, right.sets[0].neighbours->most);
  EXPECT_EQ(left.backlash->output, right.backlash->output);
  set.z(M::idler).reset();
  EXPECT_EQ(graph_of(set).error().field, "planetary.idler_side");
}

TEST(DriveLayout, ALayoutThatIsOffByATenthOfAPitchIsSeen) {
  const Drive drive = laid_drive(sets().front());
  DriveLayout layout = laid(drive);
  layout.gears.back().angle += 0.1 * kTurn / 70;
  EXPECT_NEAR(worst_mesh(drive, layout), 0.1, 1e-6);
}

// A pinion that drives racks in the given directions, rad.
Drive rack_drive(int teeth, int rack_teeth, double beta_deg,
                 const std::vector<double>& directions) {
  CylindricalSpec spec;
  spec.normal_module = 2.0;
  spec.helix_angle = Angle::degrees(beta_deg);
  spec.face_width = 20.0;
  DriveGraph graph;
  graph.bodies = {{"pinion", {}, 1, {}}};
  graph.gears = {{"pinion", 0, teeth, {}, spec, 0.2}};
  for (const double direction : directions) {
    graph.bodies.push_back({"rack", {}, 1, {}});
    DriveGear rack{"rack", graph.bodies.size() - 1, 0, RackBar{.teeth = rack_teeth}, {}, {}};
    graph.gears.push_back(rack);
    DriveMesh mesh{"mesh", {0, graph.gears.size() - 1}, {}, {}};
    mesh.direction = Angle::radians(direction);
    graph.meshes.push_back(mesh);
  }
  graph.inputs = {0};
  graph.output = 1;
  return testing::taken(make_drive({graph, {}}));
}

// The teeth of a rack are half a pitch from the teeth of its pinion, measured along the rack where
// the pitch circle of the pinion touches it.
TEST(DriveLayout, RacksMeshWithTheirPinionsAtAllTimes) {
  for (const int teeth : {17, 20}) {
    for (const int rack_teeth : {26, 31}) {
      for (const double beta : {0.0, 25.0}) {
        const Drive drive = rack_drive(teeth, rack_teeth, beta, {0.0, kTurn / 2, 1.0});
        const DriveLayout start = laid(drive);
        for (const double turns : {0.0, 0.137, -0.81}) {
          const DriveLayout layout = turned(drive, start, turns);
          const PlacedGear& pinion = layout.gears.front();
          for (std::size_t i = 1; i < layout.gears.size(); ++i) {
            const PlacedGear& placed = layout.gears[i];
            const RackGeometry& rack = drive.geometry.racks[i - 1]->rack;
            const Vec2 up(std::cos(placed.angle), std::sin(placed.angle)), along(-up.y(), up.x());
            const Vec2 apart = placed.axis - pinion.axis;
            EXPECT_NEAR(-apart.dot(up), drive.geometry.racks[i - 1]->center_distance, 1e-9);
            // The pinion and the rack are compared at the height of the middle of the rack.
            const double angle = layout.angle_at(drive, 0, placed.height);
            const double pitch = rack.transverse_pitch;
            const double away = std::remainder(std::atan2(-up.y(), -up.x()) - angle, kTurn / teeth);
            const double tooth_of_pinion = away * teeth / kTurn * pitch;
            const double tooth_of_rack = apart.dot(along) - (rack_teeth - 1) / 2.0 * pitch;
            const double off = std::remainder(tooth_of_rack - tooth_of_pinion, pitch);
            EXPECT_NEAR(std::abs(off), pitch / 2, 1e-6) << teeth << " " << rack_teeth << " " << i;
          }
        }
        // In one turn of the pinion, a rack moves by z pitches. A pinion that turns
        // counter-clockwise moves the rack at its right upwards.
        const Vec2 moved = turned(drive, start, 1.0).gears[1].axis - start.gears[1].axis;
        EXPECT_NEAR(moved.x(), 0.0, 1e-9);
        EXPECT_NEAR(moved.y(), drive.geometry.racks[0]->travel_per_turn, 1e-9);
      }
    }
  }
}

TEST(DriveLayout, RacksThatWouldCrossHaveDifferentPlanes) {
  EXPECT_EQ(laid(rack_drive(20, 26, 0.0, {0.0, kTurn / 2})).sections.size(), 1u);
  EXPECT_EQ(laid(rack_drive(20, 26, 0.0, {0.0, kTurn / 4})).sections.size(), 2u);
}

TEST(DriveLayout, ADirectionIsFromTheFirstGearToTheSecond) {
  Drive drive = rack_drive(20, 26, 0.0, {1.0});
  drive.graph.inputs = {1};
  const auto places = drive_places(drive);
  ASSERT_TRUE(places);
  const Vec2 way = places->axes[1] - places->axes[0];
  EXPECT_NEAR(std::atan2(way.y(), way.x()), 1.0, 1e-12);
}

TEST(DriveLayout, ClockedPlanetsHaveTheirClocking) {
  const Drive drive = laid_drive(sets()[3]);
  const DriveLayout layout = laid(drive);
  const auto& clocking = drive.sets.front().assembly.clocking;
  ASSERT_EQ(clocking.size(), 3u);
  const auto angle = [&](std::size_t gear, int copy) {
    for (const PlacedGear& p : layout.gears)
      if (p.gear == gear && p.copy == copy) return p.angle;
    return 0.0;
  };
  // The angle of the second gear relative to the first, compared with planet 0, up to whole teeth
  // of either gear.
  const int z_1 = drive.graph.gears[1].teeth, z_2 = drive.graph.gears[2].teeth;
  for (int copy = 1; copy < 3; ++copy) {
    const double found = (angle(2, copy) - angle(1, copy) - angle(2, 0) + angle(1, 0)) / kTurn;
    const double off = (found - clocking[static_cast<std::size_t>(copy)].value()) * z_1 * z_2;
    EXPECT_NEAR(off, std::round(off), 1e-6) << copy;
  }
}

TEST(DriveLayout, GearsThatCutEachOtherStandBesideEachOther) {
  const Drive joint = laid_drive(sets()[4]);
  const DriveLayout layout = laid(joint);
  ASSERT_EQ(layout.sections.size(), 2u);
  EXPECT_EQ(layout.sections[0].gears.size(), 1u + 3u + 1u);  // sun, planets, ring
  EXPECT_EQ(layout.sections[1].gears.size(), 3u + 1u);
  const Drive simple = laid_drive(sets().front());
  EXPECT_EQ(laid(simple).sections.size(), 1u);
  // One planet gear meshes with two rings. It is as wide as both rings and a gap of two modules.
  PlanetarySpec wolfrom = toothed_set({{M::planet, 21}, {M::ring, 57}, {M::ring2, 60}}, 3);
  wolfrom.inputs = {"carrier"};
  wolfrom.output = "ring2";
  wolfrom.face_width.all = 20.0;
  const Drive two = laid_drive(wolfrom);
  ASSERT_TRUE(two.geometry.gears[0]);
  EXPECT_EQ(two.geometry.gears[0]->spec.face_width, 20 + 20 + 2 * 2.0);
}

StageSpec layout_stage(int z1, int z2, double module = 2.0) {
  StageSpec stage;
  stage.pair.teeth = {z1, z2};
  stage.pair.set_teeth({.normal_module = module, .face_width = 20.0});
  return stage;
}

Drive laid_train(const std::vector<StageSpec>& stages) {
  return testing::taken(make_drive(testing::taken(train_of(stages))));
}

TEST(DriveLayout, ATrainStandsInLine) {
  const Drive drive = laid_train({layout_stage(19, 57), layout_stage(19, 57)});
  const DriveLayout layout = laid(drive);
  EXPECT_EQ(layout.sections.size(), 2u);
  EXPECT_NEAR((layout.places.axes[2] - layout.places.axes[0]).norm(), 152.0, 1e-9);
  EXPECT_LT(worst_mesh(drive, turned(drive, layout, 0.3)), 1e-6);
}

// The last shaft of a coaxial train lies on the axis of the first shaft. With three stages, the
// centre distances are the sides of a triangle, which lies on the left of its first side.
TEST(DriveLayout, ACoaxialTrainClosesByItself) {
  std::vector<StageSpec> two{layout_stage(19, 57), layout_stage(16, 60)};
  two.front().pair.direction = Angle::degrees(30);
  two.back().pair.coaxial = true;
  const Drive folded = laid_train(two);
  const DriveLayout layout = laid(folded);
  EXPECT_NEAR((layout.places.axes[1] - 76 * Vec2(std::sqrt(0.75), 0.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(layout.places.axes[2].norm(), 0.0, 1e-9);
  EXPECT_EQ(layout.sections.size(), 2u);
  EXPECT_LT(worst_mesh(folded, turned(folded, layout, 0.3)), 1e-6);

  std::vector<StageSpec> three{layout_stage(20, 60), layout_stage(20, 50),
                               layout_stage(18, 63, 2.5)};
  three.back().pair.coaxial = true;
  const Drive triangle = laid_train(three);
  const auto places = laid(triangle).places;
  EXPECT_NEAR(places.axes[1].x(), 80.0, 1e-9);
  EXPECT_NEAR((places.axes[2] - places.axes[1]).norm(), 70.0, 1e-9);
  EXPECT_NEAR(places.axes[2].norm(), 101.25, 1e-9);
  EXPECT_GT(places.axes[2].y(), 0.0);
  EXPECT_NEAR(places.axes[3].norm(), 0.0, 1e-9);
  EXPECT_LT(worst_mesh(triangle, turned(triangle, laid(triangle), 0.3)), 1e-6);

  // The axes of four equal stages in a line fold back, and their triangle is flat.
  std::vector<StageSpec> flat(4, layout_stage(19, 40));
  for (StageSpec& stage : flat) stage.pair.center_distance = 58.7;
  flat.back().pair.coaxial = true;
  const auto folds = laid(laid_train(flat)).places;
  EXPECT_NEAR(folds.axes[2].norm(), 2 * 58.7, 1e-9);
  EXPECT_NEAR(folds.axes[3].norm(), 58.7, 1e-6);
  EXPECT_NEAR(folds.axes[4].norm(), 0.0, 1e-6);

  for (const auto& [z, words] : {std::pair{61, "81.0000"}, std::pair{300, "320.0000"}}) {
    std::vector<StageSpec> open{layout_stage(20, 60), layout_stage(20, z)};
    if (z == 300) open.insert(open.begin() + 1, layout_stage(20, 60));
    open.back().pair.coaxial = true;
    const auto made = train_of(open);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().field, "stage[" + std::to_string(open.size()) + "].angle");
    EXPECT_NE(made.error().rule.find(words), std::string::npos) << made.error().rule;
  }
}

// The wheel of the first stage covers the axis of the third shaft if the tip radius of this wheel
// is greater than the centre distance of the second stage.
TEST(DriveLayout, AShaftWithinAGearIsANote) {
  for (const int teeth : {40, 110}) {
    const Drive drive = laid_train({layout_stage(18, teeth), layout_stage(18, 40)});
    const auto notes = shafts_through_gears(drive, laid(drive).places);
    ASSERT_EQ(notes.size(), teeth > 56 ? 1u : 0u);
    if (notes.empty()) continue;
    EXPECT_EQ(notes.front().code, WarningCode::shaft_through_gear);
    EXPECT_NE(notes.front().message.find("58.0000 mm from the axis of the gear s1_gear2"),
              std::string::npos)
        << notes.front().message;
    EXPECT_NE(notes.front().message.find("112.0000"), std::string::npos);
  }
}

// The second wheel of an idler would cut the pinion in one plane, so the idler meshes in two planes.
// With the width that the finding gives, the idler covers both gears.
TEST(DriveLayout, AnIdlerInTwoPlanesIsTooNarrow) {
  const auto idler = [](double face_width) {
    DriveGraph graph;
    for (const auto& [name, teeth] : {std::pair{"A", 20}, {"B", 30}, {"C", 40}}) {
      graph.bodies.push_back({name, std::nullopt, 1, {}});
      CylindricalSpec spec;
      spec.normal_module = 2.0;
      spec.face_width = teeth == 30 ? face_width : 20.0;
      graph.gears.push_back({name, graph.bodies.size() - 1, teeth, std::nullopt, spec, 0.0});
    }
    graph.meshes.push_back({"A_B", {0, 1}, std::nullopt, std::nullopt});
    graph.meshes.push_back({"B_C", {1, 2}, std::nullopt, std::nullopt});
    graph.meshes.back().direction = Angle::degrees(180);
    graph.inputs = {0};
    graph.output = 2;
    const Drive drive = testing::taken(make_drive({graph, {}}));
    return partial_faces(drive, laid(drive));
  };
  const auto findings = idler(20.0);
  ASSERT_EQ(findings.size(), 2u);
  for (const Warning& w : findings) {
    EXPECT_EQ(w.code, WarningCode::partial_face);
    EXPECT_NE(w.message.find("share 8.0000 mm of their faces"), std::string::npos) << w.message;
    EXPECT_NE(w.message.find("Give B the `face_width` 44.0000 mm."), std::string::npos);
  }
  EXPECT_EQ(idler(43.9).size(), 2u);
  EXPECT_TRUE(idler(44.0).empty());
  for (const PlanetarySpec& set : sets()) {
    const Drive drive = laid_drive(set);
    EXPECT_TRUE(partial_faces(drive, laid(drive)).empty());
  }
}

TEST(DriveLayout, LooksAlikeAfterTheLeastTurn) {
  for (const PlanetarySpec& set : sets()) {
    const Drive drive = laid_drive(set);
    const auto turns = turns_until_alike(drive);
    ASSERT_TRUE(turns);
    const DriveLayout before = laid(drive);
    const DriveLayout after = turned(drive, before, turns->value());
    for (std::size_t i = 0; i < before.gears.size(); ++i) {
      // A copy of the same gear must be on this axis, with its teeth at the same places.
      bool found = false;
      for (std::size_t k = 0; k < before.gears.size(); ++k) {
        const PlacedGear &a = after.gears[i], &b = before.gears[k];
        if (a.gear != b.gear || (a.axis - b.axis).norm() > 1e-6) continue;
        const double teeth = (a.angle - b.angle) * drive.graph.gears[a.gear].teeth / kTurn;
        found = found || std::abs(teeth - std::round(teeth)) < 1e-5;
      }
      EXPECT_TRUE(found) << drive.graph.gears[before.gears[i].gear].name;
    }
  }
  // If the ring of a set with three planets is held, the carrier turns by 1/3 and the sun by 1.5
  // turns.
  EXPECT_TRUE(*turns_until_alike(laid_drive(sets().front())) == Rational::of(3, 2));
}

}  // namespace
}  // namespace gearwright
