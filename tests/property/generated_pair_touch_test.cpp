// Meshes gears with few teeth and gears that are cut by gears. Both finished outlines are turned
// through a pitch of gear 1. Of the pair, only its centre distance, poses and play are used, and
// none of its formulas.
//
//   E, a      generating and operating centre distance, mm        j   play: angle of gear 2, rad
//   ξ, ρ_1    roll angle and curvature radius of the contact on gear 1, also beyond the path
//   ψ_b       half angle of gear 1's tooth on its base circle
//
// If the path is longer than a pitch, the leading flanks touch in every phase. If it is shorter,
// they touch only in the phases in which a contact is on the path. In all other phases, the gears
// have more play. Nothing may overlap.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "tests/oracle/random_pinion_cut.hpp"
#include "tests/property/generated_pairs.hpp"
#include "tests/property/turned_outlines.hpp"

namespace gearwright::property {
namespace {

constexpr int kPhases = 64;        // number of phases over a pitch of gear 1
constexpr double kOverlap = 1e-9;  // mm
constexpr double kCloser = 0.01;   // mm by which the gears are mounted closer than without backlash

// True if, after the rotation φ, the leading flanks touch on the path at least `edge` mm from its
// ends. The trailing flanks then touch after −φ.
//
// The string of tooth 0's leading flank leaves the base circle at ξ − ψ_b − φ, and the line of
// action leaves it at α_wt. Therefore ξ = α_wt + ψ_b + φ, and one pitch more for each tooth behind.
constexpr double kEdge = 1e-6;  // mm; nearer to an end of the path, the result depends on rounding

bool on_path(const InvolutePair& pair, double phi, double edge = kEdge) {
  const Gear& g = pair.gears[0];
  const double r_b = g.base_radius(), pitch = 2 * std::numbers::pi / g.spec.teeth;
  const double xi = pair.mesh.rack.sides[0].transverse_angle +
                    g.reference().base_tooth_thickness / g.reference().base_diameter + phi;
  for (int k = -g.spec.teeth - 2; k <= g.spec.teeth + 2; ++k) {
    const double rho = r_b * (xi + k * pitch);
    if (rho > pair.mesh.rho1_true_begin + edge && rho < pair.mesh.rho1_true_end - edge) return true;
  }
  return false;
}

// Half of the play between the flanks of one side, mm, along the line of action in the section.
double half_gap(const InvolutePair& pair) {
  return pair.mesh.backlash.normal_base /
         (2 * std::cos(pair.gears[0].reference().base_helix_angle));
}

// Turns a pair through a pitch, with the leading flanks in contact, in the middle of the play, and
// with the trailing flanks in contact.
class PitchTurn {
 public:
  explicit PitchTurn(const InvolutePair& pair) : pair_(pair), outlines_(pair) {
    for (int i = 0; i < kPhases; ++i) {
      phi_ = 2 * std::numbers::pi * i / (kPhases * pair.gears[0].spec.teeth);
      leads_ = on_path(pair, phi_);
      trails_ = on_path(pair, -phi_);
      on_path_ += leads_ + trails_;
      SCOPED_TRACE(fmt::format("phase {} of {}", i, kPhases));
      expect_contact();
      expect_middle();
    }
    if (pair.flanks_meet() && pair.mesh.true_ratio >= 1.0) {
      EXPECT_GE(on_path_, 2 * kPhases - 2);  // if the ratio is 1, both ends may coincide with one
                                             // phase
    }
    // The play must be the reported one: at one end one side touches, and at the other end the
    // other side.
    EXPECT_NEAR(min_leading_, 0.0, kOverlap);
    EXPECT_NEAR(min_trailing_, 0.0, kOverlap);
    EXPECT_GT(on_path_, 0);
  }

 private:
  bool has_play() const { return pair_.mesh.backlash.circumferential[1] > kOverlap; }

  void expect_contact() {
    const double turn = outlines_.to_leading();
    const Nearness one = outlines_.at(phi_, turn);
    const Nearness other = has_play() ? outlines_.at(phi_, -turn) : one;
    EXPECT_GE(one.min(), -kOverlap) << "leading flanks in contact";
    EXPECT_GE(other.min(), -kOverlap) << "trailing flanks in contact";
    if (leads_) {
      EXPECT_LE(one.leading, kOverlap);
    }
    if (trails_) {
      EXPECT_LE(other.trailing, kOverlap);
    }
    min_leading_ = std::min(min_leading_, one.leading);
    min_trailing_ = std::min(min_trailing_, other.trailing);
  }

  // In the middle of the play, flanks on the path are half the play apart, measured along the line
  // of action. The path must extend by this amount so that both flanks are on it.
  void expect_middle() const {
    if (!has_play()) return;
    const Nearness middle = outlines_.at(phi_, 0.0);
    const double half = half_gap(pair_);
    ASSERT_LT(half, outlines_.reach());
    EXPECT_GT(middle.min(), 0.0) << "in the middle of the play";
    if (on_path(pair_, phi_, half + kEdge)) {
      EXPECT_LE(middle.leading, half + kOverlap);
    }
    if (on_path(pair_, -phi_, half + kEdge)) {
      EXPECT_LE(middle.trailing, half + kOverlap);
    }
  }

  const InvolutePair& pair_;
  TurnedOutlines outlines_;
  double phi_ = 0.0;
  bool leads_ = false, trails_ = false;
  int on_path_ = 0;
  double min_leading_ = kInfinity, min_trailing_ = kInfinity;
};

// The clearances of tip and root on the line of centres: for tooth 0 of gear 1 in space 0 of gear
// 2, and half a pitch later the other way round. Only the ends of the outlines are used.
void expect_tip_clearance(const InvolutePair& pair) {
  const double side = pair.gears[1].internal() ? -1.0 : 1.0;
  for (const int i : {0, 1}) {
    const Outline& tip = pair.gears[i].tooth->outline;
    const Outline& root = pair.gears[1 - i].tooth->outline;
    const double r_a = tip.arcs.back().end_point.x();
    const double r_f = root.arcs.front().begin_point.norm();
    // For an external pair, a − r_a − r_f. For an internal pair, the radius of the ring minus a and
    // the radius of the pinion.
    const double clear = side > 0 ? pair.center_distance - r_a - r_f
                         : i == 0 ? r_f - r_a - pair.center_distance
                                  : r_a - r_f - pair.center_distance;
    EXPECT_NEAR(pair.tip_clearance[i], clear, kOverlap) << "tip of gear " << i + 1;
    EXPECT_GE(clear, -kOverlap);
  }
}

// With this number of phases, some find a contact on the path.
bool meets_long_enough(const InvolutePair& pair) {
  return pair.flanks_meet() && pair.mesh.true_ratio > 2.0 / kPhases;
}

// If the gears are mounted closer by a hundredth of a millimetre than without play, the flanks on
// the path overlap on both sides.
void expect_overlap_when_closer(const InvolutePair& pair) {
  ASSERT_TRUE(pair.backlash_free_center_distance);
  const double a = *pair.backlash_free_center_distance;
  const auto closer = mount_as<ParallelPair>(
      pair.gears[0], pair.gears[1], {pair.gears[1].internal() ? a + kCloser : a - kCloser});
  ASSERT_TRUE(closer) << closer.error().message();
  const TurnedOutlines outlines(*closer);
  const double half = -half_gap(*closer);
  EXPECT_GT(half, kCloser / 100);  // the sine of the working angle gives 1e-4 mm from 0.6° on
  Nearness deepest;
  for (int i = 0; i < kPhases; ++i) {
    const double phi = 2 * std::numbers::pi * i / (kPhases * pair.gears[0].spec.teeth);
    const Nearness here = outlines.at(phi, 0.0);
    if (on_path(*closer, phi)) {
      EXPECT_LT(here.leading, -kOverlap) << "phase " << i;
    }
    if (on_path(*closer, -phi)) {
      EXPECT_LT(here.trailing, -kOverlap) << "phase " << i;
    }
    deepest.leading = std::min(deepest.leading, here.leading);
    deepest.trailing = std::min(deepest.trailing, here.trailing);
  }
  EXPECT_LE(deepest.leading, -half + kOverlap);
  EXPECT_LE(deepest.trailing, -half + kOverlap);
}

void expect_good(const std::vector<NamedPair>& pairs) {
  for (const auto& [name, pair] : pairs) {
    SCOPED_TRACE(name);
    for (const Interference& i : pair.interference)
      ADD_FAILURE() << to_string(i.code) << ": " << i.message;
    PitchTurn{pair};
    expect_tip_clearance(pair);
    expect_overlap_when_closer(pair);
  }
}

// The walk along the outline must not miss anything: every point of both outlines has at least the
// reported distance.
TEST(TurnedOutlines, walk_to_the_nearest_place) {
  for (const auto& [name, pair] : {two_tooth_drive(), planetary_ring()}) {
    SCOPED_TRACE(name);
    const TurnedOutlines outlines(pair);
    for (const double turn : {outlines.to_leading(), 0.3 * outlines.to_leading()}) {
      const double least = outlines.at(0.2, turn).min();
      const double every = outlines.min_of_all(0.2, turn);
      EXPECT_GE(every, least - 1e-12);
      EXPECT_LE(every, least + outlines.step());
    }
  }
}

TEST(GeneratedPairTouch, examples) {
  expect_good({two_tooth_drive(), printed_drive(), planetary_ring()});
}

TEST(GeneratedPairTouch, pinions_of_the_paper_and_the_wheels_they_cut) {
  expect_good(paper_sets());
}

TEST(GeneratedPairTouch, pinions_cut_by_a_wheel) { expect_good(cut_pinions()); }

TEST(GeneratedPairTouch, rings) { expect_good(rings()); }

// A gear that was cut by its mating gear never overlaps that gear at the generating distance, even
// if the pair has other defects. At a greater distance it does not overlap either, unless the pair
// reports it. (The root of an undercut cutter meets the tip that it has cut before the flanks meet,
// because at a normal angle below α_w the play closes faster than it opens.)
TEST(GeneratedPairTouch, random_cutters_and_what_they_cut) {
  constexpr int kPairs = 24;
  Random random(20240617);
  int found = 0, rings = 0, apart = 0;
  for (int i = 0; i < 20 * kPairs && found < kPairs; ++i) {
    const CylindricalSpec spec = oracle::random_cutter(random);
    const auto cutter = make_gear(spec);
    if (!cutter || !cutter->exists() || !oracle::smooth_to_the_oracle(*cutter)) continue;
    const auto wanted = oracle::random_cut(random, *cutter);
    if (!wanted) continue;
    const auto gear = make_pinion_cut_gear(*cutter, *wanted);
    if (!gear || !gear->exists()) continue;
    const bool ring = gear->internal();
    const double e = wanted->distance;
    const auto pair = mount_as<ParallelPair>(*cutter, *gear, {e});
    if (!pair || !meets_long_enough(*pair)) continue;
    SCOPED_TRACE(describe(spec) + "; " + oracle::describe(*wanted));
    ++found;
    rings += ring;
    PitchTurn{*pair};
    expect_tip_clearance(*pair);
    expect_overlap_when_closer(*pair);
    const auto with_play = mount_as<ParallelPair>(*cutter, *gear, {e + (ring ? -kPlay : kPlay)});
    if (!with_play || !meets_long_enough(*with_play)) continue;
    if (!with_play->interference.empty() || !with_play->beyond_flank.empty())
      continue;  // reported by the pair
    ++apart;
    PitchTurn{*with_play};
  }
  EXPECT_EQ(found, kPairs);
  EXPECT_GT(rings, kPairs / 4);
  EXPECT_GT(apart, kPairs / 4);
}

}  // namespace
}  // namespace gearwright::property
