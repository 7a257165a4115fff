// Compares tips and root fillets under mounting errors with sections of both solids. The oracle
// shares no code with the contact room. Every point of a tip edge is tested against the section of
// the mating gear.
//
//   free     with gear 2 in the position given by the whole outlines, no point of an edge lies in
//            the material
//   tight    at a reported contact of a fillet, both solids have a point in common
//   said     if an edge would enter the material with contact of the flanks alone, a fillet is
//            reported
//
// The cases are involutes with every feature that shapes a tooth, arcs of both kinds, and racks
// with another lead.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/contact/fillet_contact.hpp"
#include "gearwright/generation/generate.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/tool/arc_rack.hpp"
#include "gearwright/tool/double_arc_rack.hpp"
#include "gearwright/tool/straight_rack.hpp"
#include "tests/oracle/engine_curves.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/random_mounted_pair.hpp"

namespace gearwright::oracle {
namespace {

constexpr double kFilletShared = 1e-6;  // mm, between the tested points
constexpr double kFilletTight = 1e-7;   // mm
constexpr int kFilletPositions = 10;

struct DisplacedPair {
  std::array<Gear, 2> gears;
  double center_distance;
  ContactErrors errors;
  std::string text;
};

// R_x(Δγ) R_y(Δδ) r + (0, 0, Δz) for gear 1, axis 2 at a + ΔC.
Eigen::Isometry3d place_of(const DisplacedPair& pair, int which) {
  const ContactErrors& e = pair.errors;
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

// Lead angle λ = π/2 − |β| changed by Δλ on the same pitch cylinder.
double lead_angle(const Gear& gear, double delta) {
  return kPi / 2 - std::abs(gear.spec.helix_angle.rad()) + delta;
}

double twist_of(const Gear& gear, double delta) {
  if (delta == 0.0) return gear.twist();
  const double r = gear.reference_diameter / 2;
  return std::copysign(1.0 / (r * std::tan(lead_angle(gear, delta))), gear.twist());
}

// The outline that the gear's own rack cuts if its lead angle is changed by `delta`.
Outline outline_of(const Gear& gear, double delta) {
  if (delta == 0.0) return gear.tooth->outline;
  const CylindricalSpec& spec = gear.spec;
  const double m = spec.normal_module;
  const RackMotion motion{gear.reference_diameter / 2, std::sin(lead_angle(gear, delta)),
                          gear.involute() ? gear.reference().generating_profile_shift * m : 0.0};
  const auto edge =
      std::visit(Overloaded{[&](const StraightRack& rack) {
                              return make_edge(rack, m, spec.normal_pressure_angle)->edge;
                            },
                            [&](const auto& rack) {
                              return *make_edge(*arcs_of(rack), m, spec.thickness_allowance);
                            }},
                 spec.rack);
  return cut_by_rack(edge, motion, spec.teeth, gear.tip_diameter / 2)->outline;
}

class Solid {
 public:
  Solid(const DisplacedPair& pair, int which)
      : gear_(pair.gears[which - 1]),
        place_(place_of(pair, which)),
        sign_(gear_.internal() ? -1.0 : 1.0),
        delta_(pair.errors.cutter_lead[which - 1].rad()),
        twist_(twist_of(gear_, delta_)),
        outline_(outline_of(gear_, delta_)),
        section_(std::abs(gear_.spec.teeth), curves_of(outline_)) {
    // At rest, tooth 0 of gear 1 and space 0 of gear 2 are at the mesh.
    const bool ring = pair.gears[1].internal();
    rest_ = which == 1 ? (ring ? kPi : 0.0) : kPi - kPi / std::abs(gear_.spec.teeth);
  }
  double distance(const Vec3& housing, double turn) const {
    const Vec3 p = place_.inverse() * housing;
    constexpr double kFace = 1e-9;  // mm; a contact this close to an end of the face counts as
                                    // being at the end
    if (std::abs(p.z()) > half_face() + kFace) return 1.0;
    const double back = -turn - rest_ - twist_ * p.z();
    const double c = std::cos(back), s = std::sin(back);
    return sign_ * section_.distance({c * p.x() - s * p.y(), s * p.x() + c * p.y()});
  }
  Vec3 edge(int tooth, double side, double z, double turn) const {
    const Vec2 end = outline_.arcs.back().begin_point;  // beginning of the tip land
    const double angle = side * std::atan2(end.y(), end.x()) + turn + rest_ + twist_ * z +
                         2 * kPi * tooth / std::abs(gear_.spec.teeth);
    return place_ * Vec3(end.norm() * std::cos(angle), end.norm() * std::sin(angle), z);
  }
  double half_face() const { return gear_.spec.face_width / 2; }
  /// Sense of its rotation when gear 1 turns clockwise: +1 counter-clockwise, −1 clockwise.
  double sense() const { return sign_; }

 private:
  const Gear& gear_;
  Eigen::Isometry3d place_;
  double sign_, delta_, twist_, rest_ = 0.0;
  Outline outline_;
  ToothedOutline section_;
};

// The greatest depth of an edge of one gear in the other.
double deepest(const Solid& one, const Solid& two, const ContactPoint& at) {
  constexpr int kHeights = 17, kTeeth = 3;
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

// The same pair, once with its flanks only and once with its whole outlines.
ContactPair seen(const DisplacedPair& pair, bool gear2_drives, bool fillets) {
  return {{&pair.gears[0], {}},
          {&pair.gears[1], {}},
          {pair.center_distance, Angle(), gear2_drives, pair.errors, {}, fillets}};
}

// Returns true if the two flanks of a tooth never touch at the same time.
bool has_play(const std::vector<ContactPoint>& driving, const std::vector<ContactPoint>& other) {
  for (std::size_t i = 0; i < driving.size(); ++i)
    if (!(other[i].te.rad() > driving[i].te.rad() + 1e-4)) return false;
  return true;
}

// Returns true if a tip would meet a root land, which the contact does not check.
bool tips_reach_roots(const DisplacedPair& pair) {
  constexpr double kLeast = 0.01;  // mm
  const double side = pair.gears[1].internal() ? -1.0 : 1.0;
  const double a = pair.center_distance + pair.errors.center_distance;
  const auto root = [&](int i) {
    return pair.gears[static_cast<std::size_t>(i)].root_diameter / 2;
  };
  const auto tip = [&](int i) {
    return pair.gears[static_cast<std::size_t>(i)].actual_tip_radius();
  };
  return std::min(a - side * root(1) - tip(0), side * a - side * tip(1) - root(0)) < kLeast;
}

std::optional<DisplacedPair> displaced_involutes(std::uint64_t seed) {
  Random random(seed);
  const auto mounted = random_mounted_pair(random);
  if (!mounted || !(mounted->pair.mesh.true_ratio > 1.1)) return std::nullopt;
  const InvolutePair& pair = mounted->pair;
  DisplacedPair p{{pair.gears[0], pair.gears[1]},
                  pair.center_distance,
                  random_errors(random, pair.gears[0].spec.normal_module),
                  mounted->text};
  if (std::min(pair.tip_clearance[0], pair.tip_clearance[1]) + p.errors.center_distance < 0.01)
    return std::nullopt;
  return p;
}

// Two gears with one double arc, or F and P of the example in the paper, with the face width
// required for one overlap.
std::optional<DisplacedPair> displaced_arcs(std::uint64_t seed) {
  Random random(seed);
  const double m = random.pick({2.0, 3.0, 4.0});
  const double beta = random.uniform(12.0, 30.0) * kPi / 180;
  const bool twofold = random.chance(0.5);
  std::array<std::optional<Gear>, 2> gears;
  const int z_1 = random.integer(10, 30);
  for (int i = 0; i < 2; ++i) {
    CylindricalSpec spec = testing::plain_spec({.teeth = i == 0 ? z_1 : random.integer(z_1, 70),
                                                .module = m,
                                                .face_width = 1.25 * kPi * m / std::sin(beta)});
    spec.helix_angle = Angle::radians(i == 0 ? beta : -beta);
    spec.thickness_allowance = -m * random.uniform(0.02, 0.06);
    if (twofold) {
      spec.rack = *gbt12759_rack(m);
    } else {
      ArcRack rack = default_arc_rack(i == 0 ? ArcRack::Cutter::F : ArcRack::Cutter::P);
      rack.arc_radius = i == 0 ? 1.4 : 1.55;
      rack.center_a = i == 0 ? 0.4224355652982141 : 0.5523393758658799;
      rack.center_b = i == 0 ? 0.24389328734019564 : 0.31889328734019567;
      spec.rack = rack;
    }
    auto gear = make_gear(spec);
    if (!gear || !gear->exists()) return std::nullopt;
    gears[static_cast<std::size_t>(i)] = std::move(gear).take();
  }
  const double a = (gears[0]->reference_diameter + gears[1]->reference_diameter) / 2;
  DisplacedPair p{{*gears[0], *gears[1]}, a, random_errors(random, m), ""};
  p.text = fmt::format("arcs, two of a flank {}, z {}:{}, m {}, beta {}", twofold,
                       p.gears[0].spec.teeth, p.gears[1].spec.teeth, m, beta);
  if (tips_reach_roots(p)) return std::nullopt;
  return p;
}

// Involutes or arcs whose racks have a wrong lead angle.
std::optional<DisplacedPair> displaced_leads(std::uint64_t seed) {
  auto p = seed % 2 == 0 ? displaced_involutes(seed) : displaced_arcs(seed);
  if (!p) return std::nullopt;
  Random random(seed + 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const CylindricalSpec& spec = p->gears[i].spec;
    if (spec.helix_angle == Angle() || p->gears[i].cut_by || spec.root_fillet || spec.tip_fillet)
      return std::nullopt;
    p->errors.cutter_lead[i] = Angle::degrees(random.uniform(-0.3, 0.3));
    p->text += fmt::format(", lead by {} deg", p->errors.cutter_lead[i].deg());
  }
  return p;
}

struct Sample {
  const char* name;
  std::optional<DisplacedPair> (*make)(std::uint64_t seed);
  int free, met;  ///< numbers of pairs without and with contact of a fillet
};

class DisplacedFilletOracle : public ::testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(All, DisplacedFilletOracle,
                         ::testing::Values(Sample{"involutes", displaced_involutes, 10, 5},
                                           Sample{"arcs", displaced_arcs, 4, 3},
                                           Sample{"leads", displaced_leads, 4, 3}),
                         [](const auto& sample) { return sample.param.name; });

TEST_P(DisplacedFilletOracle, tips_are_free_of_fillets_where_the_whole_outlines_hold_the_gears) {
  const Sample& sample = GetParam();
  int free = 0, met = 0, explained = 0;
  for (std::uint64_t seed = 9000; seed < 13000 && (free < sample.free || met < sample.met);
       ++seed) {
    const auto pair = sample.make(seed);
    if (!pair || !pair->gears[0].root_form_radius() || !pair->gears[1].root_form_radius()) continue;
    const std::string text = fmt::format("seed {}, {}", seed, pair->text);
    ContactRequest request;
    request.positions = kFilletPositions;
    const auto by_flanks = analyse_contact(seen(*pair, false, false), request);
    if (by_flanks.contact_lost) continue;
    const auto [asked, whole, touch] =
        fillet_contacts(seen(*pair, false, true), by_flanks.positions);
    if (touch ? met == sample.met : free == sample.free) continue;
    for (const ContactPoint& p : whole) request.rotations.push_back(p.rotation1);
    if (!has_play(whole, analyse_contact(seen(*pair, true, true), request).positions)) continue;
    ++(touch ? met : free);
    const Solid first(*pair, 1), second(*pair, 2);
    double by_flanks_alone = 1.0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      EXPECT_GE(whole[i].te.rad(), by_flanks.positions[i].te.rad() - 1e-13) << text;
      EXPECT_GE(deepest(first, second, whole[i]), -kFilletShared) << text;
      by_flanks_alone = std::min(by_flanks_alone, deepest(first, second, by_flanks.positions[i]));
    }
    // Tips without rounding can touch only fillets first.
    if (!has_round_tip(pair->gears[0]) && !has_round_tip(pair->gears[1])) {
      ++explained;
      EXPECT_TRUE(touch || by_flanks_alone >= -2 * kFilletShared) << text << " " << by_flanks_alone;
    }
    if (touch) {
      const ContactPoint& p = touch->point;
      EXPECT_LE(std::abs(first.distance(p.point, -p.rotation1.rad())), kFilletTight) << text;
      EXPECT_LE(std::abs(second.distance(p.point, second.sense() * p.rotation2.rad())),
                kFilletTight)
          << text;
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(free, sample.free);
  EXPECT_EQ(met, sample.met);
  EXPECT_GT(explained, sample.met);
}

}  // namespace
}  // namespace gearwright::oracle
