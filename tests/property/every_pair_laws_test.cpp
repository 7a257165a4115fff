// Tests laws of a mounted pair that run by the same code for external and internal pairs on parallel
// and on crossed axes, and for pinions with racks.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "tests/property/random_crossed.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright::property {
namespace {

using testing::kEps;

// A pinion with a rack of its profile.
struct PinionOfRack {
  CylindricalSpec pinion;
  RackBar bar{};
  // A friend, so that it hides no other describe() from tests that are compiled together.
  friend std::string describe(const PinionOfRack& s) {
    return "\n  a rack and " + property::describe(s.pinion);
  }
};

// Mounts the gears at the distance `a`, or without backlash if `a` is absent.
std::optional<ParallelPair> mounted_at(const SpecPair& specs, std::optional<double> a) {
  return mounted(specs, a);
}
std::optional<CrossedPair> mounted_at(const CrossedSpecs& specs, std::optional<double> a) {
  const auto p = mounted(specs);
  if (!p || !p->backlash_free_center_distance) return std::nullopt;
  auto q = mount_as<CrossedPair>(p->gears[0], p->gears[1],
                                 {a.value_or(*p->backlash_free_center_distance), p->shaft_angle});
  return q ? std::optional(std::move(q).take()) : std::nullopt;
}
std::optional<RackPair> mounted_at(const PinionOfRack& specs, std::optional<double> a) {
  const auto gear = make_gear(specs.pinion);
  if (!gear) return std::nullopt;
  const auto p = mount_rack(*gear, specs.bar);
  if (!p) return std::nullopt;
  auto q = mount_rack(*gear, specs.bar, a.value_or(p->backlash_free_center_distance));
  return q ? std::optional(std::move(q).take()) : std::nullopt;
}

void double_lengths(CylindricalSpec& s) {
  s.normal_module *= 2, s.thickness_allowance *= 2, s.face_width *= 2;
}
SpecPair doubled(SpecPair s) { return double_lengths(s.first), double_lengths(s.second), s; }
CrossedSpecs doubled(CrossedSpecs s) {
  return double_lengths(s.first), double_lengths(s.second), s;
}
PinionOfRack doubled(PinionOfRack s) { return double_lengths(s.pinion), s; }

void reverse_hand(CylindricalSpec& s) { s.helix_angle = -s.helix_angle; }
SpecPair mirrored(SpecPair s) { return reverse_hand(s.first), reverse_hand(s.second), s; }
CrossedSpecs mirrored(CrossedSpecs s) {
  s.shaft_angle = -s.shaft_angle;
  return reverse_hand(s.first), reverse_hand(s.second), s;
}
PinionOfRack mirrored(PinionOfRack s) { return reverse_hand(s.pinion), s; }

double side(const MountedGears& p) { return p.side(); }
double side(const RackPair&) { return 1.0; }

double gear_sizes(const MountedGears& p) {
  return p.gears[0].tip_diameter + p.gears[1].tip_diameter;
}
double gear_sizes(const RackPair& p) { return p.pinion.tip_diameter; }

// The values that every kind of pair has.
struct PairValues {
  double path_ratio, true_ratio;
  std::vector<double> lengths;
};
PairValues values(const InvolutePair& p) {
  return {p.mesh.path_ratio,
          p.mesh.true_ratio,
          {p.center_distance, p.normal_backlash(), p.tip_clearance[0], p.tip_clearance[1]}};
}
PairValues values(const RackPair& p) {
  return {p.transverse_contact_ratio(),
          p.true_contact_ratio(),
          {p.center_distance, p.normal_backlash(), p.tip_clearance[0], p.tip_clearance[1]}};
}

// Calls the law with the specs, and with the pair that they give at a distance with a little
// backlash.
template <class Law>
void over_every_kind(std::uint64_t seed, Law law) {
  constexpr int kOfAKind = 200;
  const auto over = [&](auto draw) {
    Random random(seed);
    int held = 0;
    for (int i = 0; i < kOfAKind && !::testing::Test::HasFailure(); ++i) {
      const auto specs = draw(random);
      const auto tight = mounted_at(specs, std::nullopt);
      if (!tight) continue;
      const double apart = side(*tight) * 0.05 * random.unit();
      const auto pair = mounted_at(specs, tight->center_distance + apart);
      if (!pair) continue;
      ++held;
      law(specs, *tight, *pair);
      if (::testing::Test::HasFailure()) ADD_FAILURE() << "the pair: " << describe(specs);
    }
    EXPECT_GT(held, kOfAKind / 3);
  };
  over([](Random& r) { return random_pair(r, false); });
  over([](Random& r) { return random_pair(r, true); });
  over([](Random& r) { return random_crossed(r, 5.0); });
  over([](Random& r) { return random_crossed_internal(r); });
  over([](Random& r) { return PinionOfRack{random_pair(r, false).first}; });
}

TEST(EveryPairLaws, doubling_every_length_is_exact) {
  over_every_kind(211, [](const auto& specs, const auto&, const auto& p) {
    const auto q = mounted_at(doubled(specs), 2 * p.center_distance);
    ASSERT_TRUE(q);
    const PairValues one = values(p), two = values(*q);
    EXPECT_EQ(two.path_ratio, one.path_ratio);
    EXPECT_EQ(two.true_ratio, one.true_ratio);
    for (std::size_t i = 0; i < one.lengths.size(); ++i)
      EXPECT_EQ(two.lengths[i], 2 * one.lengths[i]) << i;
  });
}

TEST(EveryPairLaws, both_hands_are_mirror_images) {
  over_every_kind(212, [](const auto& specs, const auto&, const auto& p) {
    const auto q = mounted_at(mirrored(specs), p.center_distance);
    ASSERT_TRUE(q);
    const PairValues one = values(p), other = values(*q);
    EXPECT_EQ(other.path_ratio, one.path_ratio);
    EXPECT_EQ(other.true_ratio, one.true_ratio);
    EXPECT_EQ(other.lengths, one.lengths);
  });
}

// Without backlash, j_n is 0 within the rounding error of the lengths. If the gears move apart, by
// which a ring and its pinion move together, the backlash and both tip clearances increase.
TEST(EveryPairLaws, backlash_and_clearances_follow_the_distance) {
  over_every_kind(213, [](const auto&, const auto& tight, const auto& p) {
    const PairValues none = values(tight), some = values(p);
    const double size = tight.center_distance + gear_sizes(tight);
    EXPECT_NEAR(none.lengths[1], 0.0, 256 * kEps * size);
    EXPECT_FALSE(tight.stated_backlash().negative());
    for (std::size_t i = 1; i < none.lengths.size(); ++i)
      EXPECT_GT(some.lengths[i], none.lengths[i]) << i;
  });
}

// ρ at the end of contact at which the tip of the mating gear touches gear i.
double contact_root_curvature(const InvolutePair& p, std::size_t i) {
  const auto [start, end] = contact_ends(p);
  return i == 0 ? start : p.mesh.rho2(end);
}
double contact_root_curvature(const RackPair& p, std::size_t) {
  const double alpha_t = p.pinion.reference().transverse_pressure_angle;
  return p.pinion.reference_diameter / 2 * std::sin(alpha_t) + p.contact_start();
}

std::vector<const Gear*> gears(const MountedGears& p) { return {&p.gears[0], &p.gears[1]}; }
std::vector<const Gear*> gears(const RackPair& p) { return {&p.pinion}; }

// On an undercut gear, contact begins on the usable flank.
TEST(EveryPairLaws, contact_begins_on_the_usable_flank_of_an_undercut_gear) {
  int undercut = 0;
  over_every_kind(214, [&undercut](const auto&, const auto&, const auto& p) {
    if (!(values(p).true_ratio > 0.0)) return;
    const double size = p.center_distance + gear_sizes(p);
    for (std::size_t i = 0; i < gears(p).size(); ++i) {
      const Gear& gear = *gears(p)[i];
      if (!gear.undercut) continue;
      ++undercut;
      const double rho = contact_root_curvature(p, i);
      EXPECT_GE(rho, -16 * kEps * size) << "gear " << i + 1;
      EXPECT_GE(std::hypot(gear.base_radius(), rho),
                gear.root_form_radius().value() - 16 * kEps * size)
          << "gear " << i + 1;
    }
  });
  EXPECT_GT(undercut, 100);
}

// The thickness allowances of both gears.
std::array<double*, 2> allowances(SpecPair& s) {
  return {&s.first.thickness_allowance, &s.second.thickness_allowance};
}
std::array<double*, 2> allowances(CrossedSpecs& s) {
  return {&s.first.thickness_allowance, &s.second.thickness_allowance};
}
std::array<double*, 2> allowances(PinionOfRack& s) {
  return {&s.pinion.thickness_allowance, &s.bar.thickness_allowance};
}

// The specs of the basic racks of both gears.
std::array<CylindricalSpec, 2> profiles(const SpecPair& s) { return {s.first, s.second}; }
std::array<CylindricalSpec, 2> profiles(const CrossedSpecs& s) { return {s.first, s.second}; }
std::array<CylindricalSpec, 2> profiles(const PinionOfRack& s) { return {s.pinion, s.pinion}; }

double base_backlash(const InvolutePair& p) { return p.mesh.backlash.normal_base; }
double base_backlash(const RackPair& p) { return p.base_backlash(); }

// If either tooth is thinned by a further E_sn, j_bn increases by E_sn cos α_n.
TEST(EveryPairLaws, thinner_teeth_have_more_backlash) {
  int thinned = 0;
  over_every_kind(215, [&thinned](const auto& specs, const auto&, const auto& p) {
    for (const std::size_t i : {0, 1}) {
      auto thinner = specs;
      const CylindricalSpec profile = profiles(specs)[i];
      const double e = 0.05 * profile.normal_module;
      *allowances(thinner)[i] -= e;
      const auto q = mounted_at(thinner, p.center_distance);
      if (!q) continue;
      ++thinned;
      EXPECT_NEAR(base_backlash(*q) - base_backlash(p),
                  e * std::cos(profile.normal_pressure_angle.rad()),
                  256 * kEps * (p.center_distance + gear_sizes(p)))
          << "gear " << i + 1;
    }
  });
  EXPECT_GT(thinned, 1000);
}

double extended_distance(const InvolutePair& p) { return p.extended_center_distance; }
double extended_distance(const RackPair& p) {
  return p.pinion.reference_diameter / 2 +
         p.pinion.spec.profile_shift * p.pinion.spec.normal_module;
}

double tip_shortening(const InvolutePair& p) { return p.tip_shortening; }
double tip_shortening(const RackPair&) { return 0.0; }

bool closest_at_ends(const MountedGears& p) { return p.crossed_inside(); }
bool closest_at_ends(const RackPair&) { return false; }

// At the extended distance, without allowances, the tips have the clearance of the racks. In a
// crossed internal pair, they have it on the centre line, and less at the ends of the faces.
TEST(EveryPairLaws, extended_distance_gives_the_standard_clearance) {
  int held = 0;
  over_every_kind(216, [&held](const auto& specs, const auto& tight, const auto&) {
    auto nominal = specs;
    for (double* allowance : allowances(nominal)) *allowance = 0.0;
    const auto p = mounted_at(nominal, extended_distance(tight));
    if (!p) return;
    for (const Gear* gear : gears(*p))
      if (gear->tooth && gear->tooth->pointed) return;
    ++held;
    const double tiny = 16 * kEps * (p->center_distance + gear_sizes(*p));
    const auto racks = profiles(nominal);
    for (const std::size_t i : {0, 1}) {
      const CylindricalSpec &tip = racks[i], &root = racks[1 - i];
      const double c = root.normal_module * root.straight_rack().dedendum -
                       tip.normal_module * tip.straight_rack().addendum;
      if (closest_at_ends(*p)) {
        EXPECT_LT(p->tip_clearance[i], c + tiny) << i;
      } else {
        EXPECT_NEAR(p->tip_clearance[i], c, tiny) << i;
      }
    }
    EXPECT_NEAR(tip_shortening(*p), 0.0, tiny);
  });
  EXPECT_GT(held, 300);
}

}  // namespace
}  // namespace gearwright::property
