// Tips and root fillets under errors of mounting against the sections of both solids, which share no
// code with the contact: every place of a tip's edge is put into the mating gear's section there.
//
//   free     with gear 2 where the whole outlines hold it no place of an edge lies in the material
//   tight    where a fillet is said to be met, both solids have a point
//   said     where the flanks alone would let an edge into the material, a fillet is named
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/contact/fillet_contact.hpp"
#include "gearwright/pair/involute_pair.hpp"
#include "tests/oracle/engine_curves.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/random_mounted_pair.hpp"

namespace gearwright::oracle {
namespace {

constexpr double kFilletShared = 1e-6;  // mm, between the places that are asked
constexpr double kFilletTight = 1e-7;   // mm
constexpr int kFilletPositions = 16;

// R_x(Δγ) R_y(Δδ) r + (0, 0, Δz) for gear 1, axis 2 at a + ΔC.
Eigen::Isometry3d place_of(const InvolutePair& pair, int which, const ContactErrors& e) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  if (which == 2) {
    place.translation() = Vec3(pair.center_distance + e.center_distance, 0.0, 0.0);
    return place;
  }
  const double c = std::cos(e.crossing.rad()), s = std::sin(e.crossing.rad());
  const double k = std::cos(e.intersecting.rad()), l = std::sin(e.intersecting.rad());
  Mat3 about_x, about_y;
  about_x << 1, 0, 0, 0, c, s, 0, -s, c;
  about_y << k, 0, l, 0, 1, 0, -l, 0, k;
  place.linear() = about_x * about_y;
  place.translation() = Vec3(0.0, 0.0, e.axial);
  return place;
}

class Solid {
 public:
  Solid(const InvolutePair& pair, int which, const ContactErrors& errors)
      : gear_(pair.gears[static_cast<std::size_t>(which - 1)]),
        place_(place_of(pair, which, errors)),
        sign_(gear_.internal() ? -1.0 : 1.0),
        section_(std::abs(gear_.spec.teeth), curves_of(gear_.tooth->outline)) {
    // At rest tooth 0 of gear 1 and space 0 of gear 2 stand at the mesh.
    const bool ring = pair.gears[1].internal();
    rest_ = which == 1 ? (ring ? kPi : 0.0) : kPi - kPi / std::abs(gear_.spec.teeth);
  }
  double distance(const Vec3& housing, double turn) const {
    const Vec3 p = place_.inverse() * housing;
    constexpr double kFace = 1e-9;  // mm: a touch at a face is one
    if (std::abs(p.z()) > half_face() + kFace) return 1.0;
    const double back = -turn - rest_ - gear_.twist() * p.z();
    const double c = std::cos(back), s = std::sin(back);
    return sign_ * section_.distance({c * p.x() - s * p.y(), s * p.x() + c * p.y()});
  }
  Vec3 edge(int tooth, double side, double z, double turn) const {
    const auto& arcs = gear_.tooth->outline.arcs;
    const Vec2 end = arcs.back().begin_point;  // where the tip land begins
    const double angle = side * std::atan2(end.y(), end.x()) + turn + rest_ + gear_.twist() * z +
                         2 * kPi * tooth / std::abs(gear_.spec.teeth);
    return place_ * Vec3(end.norm() * std::cos(angle), end.norm() * std::sin(angle), z);
  }
  double half_face() const { return gear_.spec.face_width / 2; }
  /// Of its rotation when gear 1 turns clockwise.
  double sense() const { return sign_; }

 private:
  const Gear& gear_;
  Eigen::Isometry3d place_;
  double sign_, rest_ = 0.0;
  ToothedOutline section_;
};

// The deepest place of an edge of one gear in the other.
double deepest(const Solid& one, const Solid& two, const ContactPoint& at) {
  constexpr int kHeights = 33, kTeeth = 4;
  double least = 1.0;
  const double turn_1 = -at.rotation1.rad();
  const double turn_2 = two.sense() * at.rotation2.rad();
  for (int k = -kTeeth; k <= kTeeth; ++k) {
    for (const double side : {1.0, -1.0}) {
      for (int j = 0; j < kHeights; ++j) {
        const double share = 2.0 * j / (kHeights - 1) - 1.0;
        least = std::min(least,
                         two.distance(one.edge(k, side, share * one.half_face(), turn_1), turn_2));
        least = std::min(least,
                         one.distance(two.edge(k, side, share * two.half_face(), turn_2), turn_1));
      }
    }
  }
  return least;
}

ContactErrors random_errors(Random& random, double m) {
  ContactErrors errors;
  errors.center_distance = random.uniform(-0.2, 0.05) * m;
  errors.crossing = Angle::degrees(random.uniform(-0.2, 0.2));
  errors.intersecting = Angle::degrees(random.uniform(-0.2, 0.2));
  errors.axial = random.uniform(-1.0, 1.0);
  return errors;
}

bool has_round_tip(const Gear& gear) { return gear.tooth->outline.find(ArcName::tip_fillet); }

// The same pair as contact sees it: its flanks, or its whole outlines.
ContactPair seen(const InvolutePair& pair, const ContactErrors& errors, bool gear2_drives,
                 bool fillets) {
  return {{&pair.gears[0], {}},
          {&pair.gears[1], {}},
          {pair.center_distance, Angle(), gear2_drives, errors, fillets}};
}

// Both flanks of a tooth are never touched at once.
bool has_play(const ContactResult& driving, const ContactResult& other) {
  for (std::size_t i = 0; i < driving.positions.size(); ++i)
    if (!(other.positions[i].te.rad() > driving.positions[i].te.rad() + 1e-4)) return false;
  return true;
}

TEST(DisplacedFilletOracle, tips_are_free_of_fillets_where_the_whole_outlines_hold_the_gears) {
  constexpr int kPairs = 24, kMet = 8;
  int pairs = 0, met = 0, said = 0;
  for (std::uint64_t seed = 9000; seed < 13000 && (pairs < kPairs || met < kMet); ++seed) {
    Random random(seed);
    const auto mounted = random_mounted_pair(random);
    if (!mounted) continue;
    const InvolutePair& pair = mounted->pair;
    const ContactErrors errors = random_errors(random, pair.gears[0].spec.normal_module);
    const auto form_1 = pair.gears[0].root_form_radius(), form_2 = pair.gears[1].root_form_radius();
    if (!form_1 || !form_2 || !(pair.mesh.true_ratio > 1.1)) continue;
    if (std::min(pair.tip_clearance[0], pair.tip_clearance[1]) + errors.center_distance < 0.01)
      continue;
    const std::string text = fmt::format("seed {}, {}", seed, mounted->text);
    ContactRequest request;
    request.positions = kFilletPositions;
    const auto by_flanks = analyse_contact(seen(pair, errors, false, false), request);
    const ContactPair outlines = seen(pair, errors, false, true);
    const auto whole = analyse_contact(outlines, request);
    const auto behind = analyse_contact(seen(pair, errors, true, true), request);
    if (by_flanks.contact_lost || !has_play(whole, behind)) continue;
    const auto touch = fillet_contact(outlines, {2 * *form_1, 2 * *form_2}, by_flanks.positions);
    if (touch ? met == kMet : pairs - met == kPairs - kMet) continue;
    ++pairs;
    const Solid first(pair, 1, errors), second(pair, 2, errors);
    double by_flanks_alone = 1.0;
    for (std::size_t i = 0; i < whole.positions.size(); ++i) {
      EXPECT_GE(whole.positions[i].te.rad(), by_flanks.positions[i].te.rad() - 1e-13) << text;
      EXPECT_GE(deepest(first, second, whole.positions[i]), -kFilletShared) << text;
      by_flanks_alone = std::min(by_flanks_alone, deepest(first, second, by_flanks.positions[i]));
    }
    // Tips without a rounding strike nothing but fillets first.
    if (!has_round_tip(pair.gears[0]) && !has_round_tip(pair.gears[1])) {
      ++said;
      EXPECT_TRUE(touch || by_flanks_alone >= -2 * kFilletShared) << text << " " << by_flanks_alone;
    }
    if (touch) {
      ++met;
      const ContactPoint& p = touch->point;
      EXPECT_LE(std::abs(first.distance(p.point, -p.rotation1.rad())), kFilletTight) << text;
      EXPECT_LE(std::abs(second.distance(p.point, second.sense() * p.rotation2.rad())),
                kFilletTight)
          << text;
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(pairs, kPairs);
  EXPECT_EQ(met, kMet);
  EXPECT_GT(said, 6);
}

}  // namespace
}  // namespace gearwright::oracle
