// An independent check of a mesh: two finished outlines are turned against each other and tested
// for overlap. The check uses only the centre distance and the poses of the pair, and none of its
// formulas.
//
//   ρ, θ     polar coordinates in a gear's own frame; θ(ρ) half angle of its tooth at that radius
//   gap      ρ (|θ| − θ(ρ)) for a point of the mating gear and the nearest tooth, mm: arc between
//            point and flank, < 0 where the point is inside the material
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright::property {
namespace {

constexpr double kTouch = 1e-9;  // mm

Vec2 turned(const Vec2& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x() * c - p.y() * s, p.x() * s + p.y() * c};
}

double half_angle(const Outline& outline, double rho) {
  const double z = outline.teeth;
  if (rho <= outline.arcs.front().begin_point.norm()) return std::numbers::pi / z;
  for (const Arc& arc : outline.arcs) {
    if (arc.name == ArcName::root_land || arc.name == ArcName::tip_land) continue;
    if (rho > arc.end_point.norm()) continue;
    return arc.curve->polar_angle(arc.curve->parameter_at_radius(rho, arc.begin, arc.end));
  }
  return -kInfinity;  // beyond the tip: no material
}

struct Contact {
  double left = kInfinity, right = kInfinity;  // mm, least gap on the left and on the right side of
                                               // the teeth
};

// Both gears are turned according to the rotation of gear 1 (clockwise). Points on the teeth of one
// gear are tested against the other.
class Turned {
 public:
  Turned(const InvolutePair& pair, double rotation) : pair_(pair) {
    const Eigen::Matrix4d one = pair.pose_1().isometry().matrix();
    const Eigen::Matrix4d two = pair.pose_2().isometry().matrix();
    const double ratio = static_cast<double>(pair.input.gears[0].teeth) / pair.input.gears[1].teeth;
    angle_[0] = std::atan2(one(1, 0), one(0, 0)) - rotation;
    angle_[1] = std::atan2(two(1, 0), two(0, 0)) + rotation * ratio;
  }

  /// Signed gap between the mating gear and a point on the side ±1 of tooth k of gear `which`, and
  /// the side on which the gap occurs.
  double gap(int which, int tooth, double side, const Arc& arc, double u, bool& left) const {
    const Outline& mate = pair_.gears[1 - which].tooth->outline;
    const double pitch = 2 * std::numbers::pi / pair_.gears[which].spec.teeth;
    Vec2 p = arc.point(u);
    p = turned({p.x(), side * p.y()}, angle_[which] + tooth * pitch);
    const double a = pair_.center_distance;
    p = turned(which == 0 ? Vec2(p.x() - a, p.y()) : Vec2(p.x() + a, p.y()), -angle_[1 - which]);
    const double mate_pitch = 2 * std::numbers::pi / mate.teeth;
    const double theta = std::remainder(std::atan2(p.y(), p.x()), mate_pitch);
    left = theta > 0.0;
    const double rho = p.norm();
    const double half = half_angle(mate, rho);
    return std::isinf(half) ? kInfinity : rho * (std::abs(theta) - half);
  }

  /// Least gaps of gear `which` on both sides, from 24 points per arc and a golden section around
  /// the least.
  void add(int which, Contact& contact) const {
    const int z = pair_.gears[which].spec.teeth;
    // The tooth nearest to the mating gear, and two on each side.
    const double towards = which == 0 ? 0.0 : std::numbers::pi;
    const int nearest =
        static_cast<int>(std::lround((towards - angle_[which]) / (2 * std::numbers::pi / z)));
    for (int k = nearest - 2; k <= nearest + 2; ++k) {
      for (const double side : {-1.0, 1.0}) {
        for (const Arc& arc : pair_.gears[which].tooth->outline.arcs) {
          if (arc.name == ArcName::root_land) continue;
          min_gap(which, k, side, arc, contact);
        }
      }
    }
  }

 private:
  void min_gap(int which, int k, double side, const Arc& arc, Contact& contact) const {
    constexpr int kSteps = 24;
    const auto take = [&](double u) {
      bool left = false;
      const double g = gap(which, k, side, arc, u, left);
      double& best = left ? contact.left : contact.right;
      best = std::min(best, g);
      return g;
    };
    double best = kInfinity;
    int at = 0;
    for (int i = 0; i <= kSteps; ++i) {
      const double g = take(static_cast<double>(i) / kSteps);
      if (g < best) {
        best = g;
        at = i;
      }
    }
    if (best > 0.05 * pair_.gears[0].spec.normal_module) return;
    constexpr double kGolden = 0.6180339887498949;
    double lo = std::max(0, at - 1) / static_cast<double>(kSteps);
    double hi = std::min(kSteps, at + 1) / static_cast<double>(kSteps);
    for (int i = 0; i < 45; ++i) {
      const double u = hi - kGolden * (hi - lo), v = lo + kGolden * (hi - lo);
      (take(u) < take(v) ? hi : lo) = take(u) < take(v) ? v : u;
    }
  }

  const InvolutePair& pair_;
  double angle_[2];
};

Contact contact_of(const InvolutePair& pair, double rotation) {
  Contact contact;
  const Turned turned(pair, rotation);
  turned.add(0, contact);
  turned.add(1, contact);
  return contact;
}

// External pairs without interference and with continuous motion. The tips are shortened so that
// the clearance of the racks is kept.
template <class Check>
int over_running_pairs(std::uint64_t seed, int wanted, Check check) {
  Random random(seed);
  int found = 0;
  for (int i = 0; i < 40 * wanted && found < wanted; ++i) {
    SpecPair specs = random_pair(random, false);
    const auto first = mounted(specs);
    if (!first) continue;
    specs.first.tip_diameter = first->gears[0].tip_diameter + 2 * first->tip_shortening;
    specs.second.tip_diameter = first->gears[1].tip_diameter + 2 * first->tip_shortening;
    const auto pair = mounted(specs);
    if (!pair || !pair->interference.empty() || pair->mesh.true_ratio < 1.02) continue;
    ++found;
    check(specs, *pair);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "the pair: " << describe(specs) << "\n  a = " << pair->center_distance;
      break;
    }
  }
  return found;
}

constexpr int kRotations = 7;  // number of rotations over a pitch; at the first, a tooth and a
                               // space are on the centre line

TEST(PairTouch, backlash_free_outlines_touch_on_both_sides_and_do_not_overlap) {
  constexpr int kPairs = 300;
  const int found =
      over_running_pairs(301, kPairs, [](const SpecPair& specs, const InvolutePair& pair) {
        for (int i = 0; i < kRotations; ++i) {
          const Contact c =
              contact_of(pair, 2 * std::numbers::pi / specs.first.teeth * i / kRotations);
          EXPECT_NEAR(c.left, 0.0, kTouch) << "rotation " << i;
          EXPECT_NEAR(c.right, 0.0, kTouch) << "rotation " << i;
        }
      });
  EXPECT_EQ(found, kPairs);
}

TEST(PairTouch, closer_by_a_hundredth_they_overlap) {
  constexpr int kPairs = 150;
  const int found =
      over_running_pairs(302, kPairs, [](const SpecPair& specs, const InvolutePair& pair) {
        const auto closer = mounted(specs, pair.center_distance - 0.01);
        ASSERT_TRUE(closer);
        // Half of the negative backlash is on each side.
        const double half = -closer->mesh.backlash.circumferential[0] / 2;
        EXPECT_GT(half, 1e-3);
        for (int i = 0; i < kRotations; ++i) {
          const Contact c =
              contact_of(*closer, 2 * std::numbers::pi / specs.first.teeth * i / kRotations);
          EXPECT_LT(c.left, -0.5 * half);
          EXPECT_LT(c.right, -0.5 * half);
        }
      });
  EXPECT_EQ(found, kPairs);
}

// At a larger distance, the flanks do not touch. If gear 2 turns by half its backlash, one side
// closes and the other opens.
TEST(PairTouch, backlash_is_what_closes_the_gap) {
  constexpr int kPairs = 150;
  const int found =
      over_running_pairs(303, kPairs, [](const SpecPair& specs, const InvolutePair& pair) {
        const double m = specs.first.normal_module;
        const auto apart = mounted(specs, pair.center_distance + 0.02 * m);
        ASSERT_TRUE(apart);
        if (apart->mesh.true_ratio < 1.02) return;
        const Contact c = contact_of(*apart, 0.0);
        EXPECT_GT(c.left, 0.0);
        EXPECT_GT(c.right, 0.0);
        // If gear 2 is thickened by the backlash, both sides touch at the unchanged distance.
        SpecPair filled = specs;
        filled.second.thickness_allowance +=
            apart->mesh.backlash.normal_base / std::cos(specs.first.normal_pressure_angle.rad());
        const auto tight = mounted(filled, apart->center_distance);
        ASSERT_TRUE(tight);
        if (!tight->interference.empty()) return;
        const Contact touch = contact_of(*tight, 0.0);
        EXPECT_NEAR(touch.left, 0.0, kTouch);
        EXPECT_NEAR(touch.right, 0.0, kTouch);
      });
  EXPECT_EQ(found, kPairs);
}

}  // namespace
}  // namespace gearwright::property
