// The tip corners of a pinion cutter determine ρ_F of the gears that it cuts. This ρ_F is compared
// with a printed report and with the outline.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright {
namespace {

using testing::made;

enum class Corner { of_the_rack, circle };

struct Ring {
  int z_1 = 36, z = -93, z_0 = 30;
  double m = 21, x_1 = 0.5039, x = 0.1171;
  double d_a1 = 815.663, d_a = 1906.081, root = 2000.581, a = 584.0;
  double rho = 0.30;  // radius of the tip corners of the cutter, modules
  double cutter_root = 0.38;
  Corner corner = Corner::circle;
};

// The ring's cutter has no shift and reaches its root circle.
Gear cutter_of(const Ring& k) {
  CylindricalSpec c = testing::plain_spec({.teeth = k.z_0, .module = k.m, .face_width = 20.0});
  c.straight_rack().root_fillet_radius = k.cutter_root;
  const double e = testing::taken(generating_distance(made(c), k.z, k.x));
  const double h = (k.root / 2 - e - k.z_0 * k.m / 2) / k.m;
  c.straight_rack().addendum = h;
  if (k.corner == Corner::of_the_rack) c.straight_rack().tip_fillet_radius = k.rho;
  if (k.corner == Corner::circle && k.rho > 0.0)
    c.tip_fillet = TipFilletSpec{TipFilletSpec::By::corner, k.rho * k.m};
  return made(c);
}

struct Rated {
  Gear ring;
  RatedPair pair;
  CriticalSection section;
};

Rated rated(const Ring& k) {
  const Gear cutter = cutter_of(k);
  const double e = testing::taken(generating_distance(cutter, k.z, k.x));
  Gear ring = testing::taken(make_pinion_cut_gear(cutter, {k.z, e, 550.0, k.d_a}));
  CylindricalSpec planet =
      testing::plain_spec({.teeth = k.z_1, .module = k.m, .x = k.x_1, .face_width = 550.0});
  planet.tip_diameter = k.d_a1;
  const auto mounted =
      testing::taken(mount_as<ParallelPair>(made(planet), ring, PairSpec{.center_distance = k.a}));
  const RatedPair pair = testing::taken(rated_pair(mounted));
  const auto section = critical_section(pair, pair.gears[1]);
  EXPECT_TRUE(section.has_value());
  return {std::move(ring), pair, section.value_or(CriticalSection{})};
}

// KISSsoft 03/2017, second stage of the 5 MW wind turbine of NREL: the ring −93 of the rack
// 1.25/0.30 and its pinion cutter with 30 teeth. With the root rounding of the cutter, ρ_F would be
// 10.94 mm.
TEST(RingRoot, takes_the_rounding_of_the_cutters_tip) {
  for (const Corner corner : {Corner::of_the_rack, Corner::circle}) {
    Ring k;
    k.corner = corner;
    const Rated r = rated(k);
    EXPECT_NEAR(r.ring.root_diameter, 2000.581, 1e-9);
    EXPECT_NEAR(r.pair.gears[1].tool.fillet, 0.30, 1e-12);
    EXPECT_NEAR(r.pair.gears[1].tool.cutter_shift, 0.0, 1e-12);
    EXPECT_NEAR(r.pair.gears[1].tool.dedendum, 1.25, 5e-4 / 21);  // the root is printed to 1 µm
    EXPECT_NEAR(r.section.rho_F, 8.78, 5e-3);
    EXPECT_NEAR(r.section.s_Fn, 56.76, 5e-3);
    EXPECT_NEAR(r.section.h_F, 30.32, 1.1e-2);
    EXPECT_NEAR(r.section.alpha_Fen / kRadPerDeg, 18.63, 5e-3);
    EXPECT_NEAR(form_factor(RatingEdition::iso_2006, r.pair, r.section).value, 1.20, 5e-3);
    EXPECT_NEAR(stress_correction_factor(r.section).value, 2.34, 5e-3);
  }
}

// The cutter that a ring has by default is not rounded like the rack if such a tip would be too
// narrow. The rating then uses the rounding of the cutter.
TEST(RingRoot, takes_the_rounding_of_the_default_cutter) {
  for (const auto& [shift, rounding] : {std::pair(-0.3, 0.2), {0.0, 0.38}}) {
    CylindricalSpec ring =
        testing::plain_spec({.teeth = -60, .module = 2, .x = shift, .face_width = 20});
    ring.straight_rack().root_fillet_radius = shift < 0.0 ? 0.45 : 0.38;
    const Gear cut = *cut_by_default(made(ring));
    EXPECT_NEAR(cut.cut_by->tip_rounding, 2 * rounding, 1e-12);
    const Gear planet =
        made(testing::plain_spec({.teeth = 20, .module = 2, .x = 0.1, .face_width = 20}));
    const auto mounted = testing::taken(mount_as<ParallelPair>(planet, cut, PairSpec{}));
    EXPECT_NEAR(testing::taken(rated_pair(mounted)).gears[1].tool.fillet, rounding, 1e-12);
  }
}

// (1) the tip rounding of the cutter changes the root
// (2) the root rounding of the cutter has no effect
TEST(RingRoot, does_not_know_the_cutters_root) {
  double before = 0.0;
  for (const double rho : {0.0, 0.1, 0.2, 0.3}) {
    for (const Corner corner : {Corner::of_the_rack, Corner::circle}) {
      Ring k;
      k.rho = rho;
      k.corner = corner;
      const Rated r = rated(k);
      EXPECT_NEAR(r.pair.gears[1].tool.fillet, rho, 1e-12);
      if (corner == Corner::of_the_rack) {
        EXPECT_GT(r.section.rho_F, before);  // (1)
        before = r.section.rho_F;
      } else {
        EXPECT_DOUBLE_EQ(r.section.rho_F, before);
      }
      Ring other = k;
      other.cutter_root = 0.1;
      EXPECT_EQ(rated(other).section.rho_F, r.section.rho_F);  // (2)
      EXPECT_EQ(rated(other).section.s_Fn, r.section.s_Fn);
    }
  }
}

// The point at which the tangent of the fillet of the ring is inclined by 60° to the centre line of
// the tooth.
struct Exact {
  double rho, half_chord;  // mm
};
std::optional<Exact> at_60_degrees(const Gear& ring) {
  std::optional<Exact> found;
  for (const Arc& arc : ring.tooth->outline.arcs) {
    if (arc.name != ArcName::root_fillet) continue;
    const auto lean = [&](double u) {
      const double t = arc.at(u).tangent_angle;
      return std::atan2(std::abs(std::sin(t)), std::abs(std::cos(t))) - kPi / 3;
    };
    constexpr int kMany = 2000;
    for (int i = 0; i < kMany; ++i) {
      double lo = static_cast<double>(i) / kMany, hi = static_cast<double>(i + 1) / kMany;
      if (lean(lo) * lean(hi) > 0.0) continue;
      for (int n = 0; n < 60; ++n) {
        const double middle = (lo + hi) / 2;
        (lean(lo) * lean(middle) <= 0.0 ? hi : lo) = middle;
      }
      const CurvePoint p = arc.at(lo);
      found = Exact{1 / std::abs(p.curvature), std::abs(p.point.y())};
    }
  }
  return found;
}

// ρ_fPv of the standard is an approximation. On outlines cut by circular corners, ρ_F is 11 to 21 %
// greater than the radius at the 60° tangent, and s_Fn is 1.2 to 1.9 % less than the chord there.
// The difference of ρ_F is smaller for rounder corners.
TEST(RingRoot, of_the_standard_is_near_that_of_the_outline) {
  double worst_rho = 0.0, worst_chord = 0.0;
  int compared = 0;
  for (const double rho : {0.2, 0.25, 0.3}) {
    for (const int z_0 : {20, 25, 30, 40}) {
      Ring k;
      k.rho = rho;
      k.z_0 = z_0;
      const Rated r = rated(k);
      const auto exact = at_60_degrees(r.ring);
      ASSERT_TRUE(exact) << rho << " " << z_0;
      const double off_rho = r.section.rho_F / exact->rho - 1;
      const double off_chord = r.section.s_Fn / (2 * exact->half_chord) - 1;
      worst_rho = std::max(worst_rho, std::abs(off_rho));
      worst_chord = std::max(worst_chord, std::abs(off_chord));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
  EXPECT_NEAR(worst_rho, 0.207, 5e-3);
  EXPECT_NEAR(worst_chord, 0.0192, 5e-4);
}

}  // namespace
}  // namespace gearwright
