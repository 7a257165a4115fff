// Compares the clearance of tips and roots on crossed axes with sections of both solids. The oracle
// shares no code with the computation of the gap. Every point of a tip edge is tested over a whole
// pitch against the section of the mating gear.
//
//   free     at both ends of the backlash, no point of an edge lies in the material
//   tight    at a reported collision, both solids have a point in common
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gearwright/gear/pinion_cut.hpp"
#include "tests/oracle/engine_curves.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/property/random_crossed.hpp"

namespace gearwright::oracle {
namespace {

constexpr double kCrossedShared = 1e-6;  // mm, between the tested points
constexpr double kCrossedTight = 1e-8;   // mm

// The solid of a gear: its section, turned as it goes up.
class Screwed {
 public:
  Screwed(const InvolutePair& pair, int which)
      : gear_(pair.gears[which - 1]),
        place_(which == 1 ? pair.pose_1().isometry() : pair.pose_2().isometry()),
        section_(std::abs(gear_.spec.teeth), curves_of(gear_.tooth->outline)) {}

  // Distance from a point of the housing to the section of the gear turned by `turn`; > 0 outside.
  double distance(const Vec3& housing, double turn) const {
    const Vec3 p = place_.inverse() * housing;
    if (std::abs(p.z()) > gear_.spec.face_width / 2) return 1.0;
    const double short_of_tip =
        gear_.side() * (std::hypot(p.x(), p.y()) - gear_.actual_tip_radius());
    if (short_of_tip > 0.0) return short_of_tip;
    const double back = -turn - (gear_.lead == 0.0 ? 0.0 : 2 * kPi * p.z() / gear_.lead);
    const double c = std::cos(back), s = std::sin(back);
    return gear_.side() * section_.distance({c * p.x() - s * p.y(), s * p.x() + c * p.y()});
  }
  // A point on the edge at which the flank of tooth 0 ends.
  Vec3 edge(double z, double turn, double side) const {
    const Vec2 end = gear_.tooth->outline.find(ArcName::flank)->end_point;
    const double angle = side * std::atan2(end.y(), end.x()) + turn +
                         (gear_.lead == 0.0 ? 0.0 : 2 * kPi * z / gear_.lead);
    return place_ * Vec3(end.norm() * std::cos(angle), end.norm() * std::sin(angle), z);
  }
  double half_face() const { return gear_.spec.face_width / 2; }
  int teeth() const { return gear_.spec.teeth; }

 private:
  const Gear& gear_;
  Eigen::Isometry3d place_;
  ToothedOutline section_;
};

// The greatest depth of the edges of `one` in `two`. Gear 2 is turned by `away` from its middle
// position.
double deepest(const Screwed& one, const Screwed& two, bool first_moves, double away) {
  constexpr int kTurns = 60, kHeights = 81;
  double least = 1.0;
  const double reach = std::min(one.half_face(), 12.0 * 2 * kPi / std::abs(one.teeth()));
  // In an internal gear, tips can also come close to each other away from the mesh.
  const int around = one.teeth() * two.teeth() < 0 ? std::abs(one.teeth()) / 2 : 2;
  for (int i = 0; i < kTurns; ++i) {
    const double turn = 2 * kPi / one.teeth() * (i - kTurns / 2) / kTurns;
    const double mate = -turn * one.teeth() / two.teeth();
    // `away` is added to the rotation of gear 2 only.
    const double turn_1 = first_moves ? turn : turn + away;
    const double turn_2 = first_moves ? mate + away : mate;
    for (int k = -around; k <= around; ++k) {
      for (int j = 0; j < kHeights; ++j) {
        const double z = reach * (2.0 * j / (kHeights - 1) - 1.0);
        for (const double side : {1.0, -1.0}) {
          const Vec3 p = one.edge(z, turn_1 + 2 * kPi * k / one.teeth(), side);
          least = std::min(least, two.distance(p, turn_2));
        }
      }
    }
  }
  return least;
}

TEST(CrossedGapOracle, edges_are_free_within_the_free_play_and_collisions_are_tight) {
  property::Random random(4033);
  int pairs = 0, collisions = 0;
  for (int i = 0; i < 4000 && pairs < 22; ++i) {
    auto specs = property::random_crossed(random, 10.0, false);
    const double m = specs.first.normal_module;
    for (CylindricalSpec* spec : {&specs.first, &specs.second})
      spec->profile_shift = random.uniform(-0.5, 0.3);
    // Most tips are longer than usual, so that some of them reach the fillets.
    const auto plain = property::mounted(specs, 0.05 * m);
    if (!plain) continue;
    specs.first.tip_diameter = plain->gears[0].tip_diameter + random.uniform(-0.1, 0.45) * m;
    specs.second.tip_diameter = plain->gears[1].tip_diameter + random.uniform(-0.1, 0.45) * m;
    const auto pair = property::mounted(specs, random.uniform(0.0, 0.1) * m);
    if (!pair || !pair->overlap || !pair->free_play || !(pair->mesh.path_ratio > 1.0)) continue;
    if (pair->gears[0].pointed() || pair->gears[1].pointed()) continue;
    if (std::min(pair->tip_clearance[0], pair->tip_clearance[1]) < 0.0) continue;
    // For pairs without a collision, testing a dozen is sufficient.
    if (pair->overlap->empty() && pair->beyond_flank.empty() && pairs >= 12) continue;
    SCOPED_TRACE(describe(specs));
    ++pairs;
    const Screwed one(*pair, 1), two(*pair, 2);
    const double half = pair->free_play->rad() / 2;
    if (half > 0.0) {
      for (const double away : {half, -half}) {
        EXPECT_GE(deepest(one, two, true, away), -kCrossedShared);
        EXPECT_GE(deepest(two, one, false, away), -kCrossedShared);
      }
    }
    std::vector<Collision> all = *pair->overlap;
    all.insert(all.end(), pair->beyond_flank.begin(), pair->beyond_flank.end());
    for (const Collision& s : all) {
      if (!s.touch || s.cause == CollisionCause::negative_backlash) continue;
      ++collisions;
      const double turn_1 = -s.touch->rotation_1;
      const double turn_2 = -turn_1 * one.teeth() / two.teeth() + s.touch->turn_2;
      const Vec3 p(s.touch->point.x(), s.touch->point.y(), s.touch->height);
      const bool of_1 = s.touch->places[0].corner;
      EXPECT_LE(std::abs((of_1 ? two : one).distance(p, of_1 ? turn_2 : turn_1)), kCrossedTight);
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(pairs, 22);
  EXPECT_GT(collisions, 8);
  RecordProperty("collisions", collisions);
}

// Internal pairs with a small difference of the numbers of teeth, whose tips collide away from the
// mesh. If no overlap is reported, no edge lies in the material in the middle of the play. The play
// is greater than the depth of the saddle of the flanks.
TEST(CrossedGapOracle, tips_inside_an_internal_gear_collide_where_the_solids_do) {
  property::Random random(4034);
  int free = 0, collisions = 0;
  for (int i = 0; i < 4000 && (free < 4 || collisions < 4); ++i) {
    const auto specs = property::random_crossed_internal(random, 4, 24);
    const double m = specs.first.normal_module;
    const auto plain = property::mounted(specs, 0.15 * m);
    if (!plain) continue;
    const auto ring = cut_by_default(plain->gears[1]);
    if (!ring) continue;
    const auto pair = mount_as<CrossedPair>(plain->gears[0], *ring,
                                            {plain->center_distance, plain->shaft_angle, {}});
    if (!pair || !pair->overlap || !(pair->mesh.path_ratio > 0.8)) continue;
    if (std::min(pair->tip_clearance[0], pair->tip_clearance[1]) < 0.0) continue;
    const double half_play = pair->mesh.backlash.normal_base / 2;
    bool shallow = true;
    for (const auto& crowning : pair->needed_crowning)
      shallow = shallow && crowning && 1.5 * *crowning < 0.5 * half_play;
    if (!shallow) continue;
    if (pair->overlap->empty() ? free >= 4 : collisions >= 4) continue;
    SCOPED_TRACE(describe(specs));
    const Screwed one(*pair, 1), two(*pair, 2);
    if (pair->overlap->empty()) {
      ++free;
      EXPECT_GE(deepest(one, two, true, 0.0), -kCrossedShared);
      EXPECT_GE(deepest(two, one, false, 0.0), -kCrossedShared);
    }
    for (const Collision& s : *pair->overlap) {
      if (!s.touch) continue;
      ++collisions;
      const double turn_1 = -s.touch->rotation_1;
      const double turn_2 =
          -turn_1 * pair->gears[0].spec.teeth / pair->gears[1].spec.teeth + s.touch->turn_2;
      const Vec3 p(s.touch->point.x(), s.touch->point.y(), s.touch->height);
      const bool of_1 = s.touch->places[0].corner;
      EXPECT_LE(std::abs((of_1 ? two : one).distance(p, of_1 ? turn_2 : turn_1)), kCrossedTight);
      EXPECT_LT(std::min(deepest(one, two, true, 0.0), deepest(two, one, false, 0.0)), 0.0);
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GE(free, 4);
  EXPECT_GE(collisions, 4);
}

}  // namespace
}  // namespace gearwright::oracle
