// Tests laws of tooth contact over seeded pairs: invariants, and quantities that must change in a
// known way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/error_map.hpp"
#include "tests/property/contact_pairs.hpp"
#include "tests/property/random_crossed.hpp"

namespace gearwright::property {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// ---- involutes without errors ----

// (1) at the backlash-free distance, there is no transmission error; external and internal pairs,
//     either gear driving
// (2) the teeth always touch along lines    (3) the ends of these lines lie on the ends of the
//     flanks
TEST(ContactLaws, conjugate_flanks) {
  Random random(11);
  int externals = 0, rings = 0;
  for (int i = 0; i < 400 && (externals < 40 || rings < 40); ++i) {
    Wanted want;
    want.internal = i % 2 == 1;
    want.errors = want.modifications = false;
    if ((want.internal ? rings : externals) >= 40) continue;
    const auto p = random_modified(random, want);
    if (!p) continue;
    ++(want.internal ? rings : externals);
    const ContactPair pair = p->set.pair();
    const auto r = over_a_pitch(pair, 12);
    EXPECT_EQ(r.unfinished, 0);
    for (const ContactPoint& q : r.positions) {
      EXPECT_NEAR(q.te.rad(), 0.0, 1e-12);            // (1)
      ASSERT_EQ(q.kind, TouchKind::line) << p->name;  // (2)
      ASSERT_TRUE(q.line);
      for (const Vec3& end : *q.line) {  // (3)
        const double z = std::abs(end.z());
        const double rho_1 = end.head<2>().norm();
        const double rho_2 = (end - Vec3(p->set.mount.center_distance, 0, 0)).head<2>().norm();
        double off = std::numeric_limits<double>::infinity();
        for (const double d : {z - p->brute.one.z_high, z - p->brute.two.z_high,
                               rho_1 - p->brute.one.rho_low, rho_1 - p->brute.one.rho_high,
                               rho_2 - p->brute.two.rho_low, rho_2 - p->brute.two.rho_high})
          off = std::min(off, std::abs(d));
        EXPECT_LT(off, 1e-6 * rho_2);
      }
    }
  }
  EXPECT_GE(externals, 40);
  EXPECT_GE(rings, 40);
}

// Gears on crossed axes are conjugate at any centre distance. The contact is half the backlash away
// from the middle of the play. The point of contact lies on the line of action, at the position
// that follows from its radius.
TEST(ContactLaws, crossed_involutes_keep_to_the_line_of_action) {
  Random random(12);
  int pairs = 0;
  for (int i = 0; i < 400 && pairs < 150; ++i) {
    const CrossedSpecs specs = random_crossed(random, 3.0);
    const auto p = mounted(specs, i % 2 ? 0.0 : 0.2 * random.unit());
    if (!p || !p->gears[0].root_form_radius() || !p->gears[1].root_form_radius()) continue;
    if (!(p->mesh.true_ratio > 1.05)) continue;
    ++pairs;
    ContactMount place;
    place.center_distance = p->center_distance;
    place.axis_angle = p->axis_angle();
    place.gear2_drives = i % 3 == 0;
    const double sense = place.gear2_drives ? 1.0 : -1.0;
    const auto r = over_a_pitch(ContactPair({&p->gears[0], {}}, {&p->gears[1], {}}, place), 8);
    for (const ContactPoint& q : r.positions) {
      ASSERT_EQ(q.kind, TouchKind::interior) << describe(specs);
      EXPECT_NEAR(q.te.rad(), sense * p->mesh.backlash.rotation[1] / 2, 1e-12);
      const double rho = q.diameter[0] / 2, r_b = p->input.gears[0].radius;
      const double rho1 = std::sqrt((rho - r_b) * (rho + r_b));
      const Vec3 line =
          place.gear2_drives ? p->on_trailing_line(rho1).r : p->on_line_of_action(rho1).r;
      const double sine = std::sin(p->shaft_angle.rad());
      EXPECT_LT((q.point - line).norm(), 1e-12 * p->center_distance / (sine * sine));
    }
    if (HasFailure()) FAIL() << describe(specs);
  }
  EXPECT_EQ(pairs, 150);
}

// If a pair of teeth is followed through its range, its contact is the same as from a search
// without a start value. The curve does not depend on the number of positions.
TEST(ContactLaws, positions_are_rotations) {
  over_contacts(26, 40, [](const ContactPair& pair) {
    const auto followed = over_a_pitch(pair, 32);
    std::vector<Angle> rotations;
    for (std::size_t i = 0; i < followed.positions.size(); i += 4)
      rotations.push_back(followed.positions[i].rotation1);
    const auto cold = at_rotations(pair, rotations);
    const auto coarse = transmission_error(pair, 8);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      EXPECT_NEAR(followed.positions[4 * i].te.rad(), cold.positions[i].te.rad(), 1e-12);
      EXPECT_NEAR(followed.positions[4 * i].te.rad(), coarse[i], 1e-12);
    }
  });
}

// The errors do not rotate with the gears, so every pitch repeats the first one, with the tooth
// numbers increased by one.
TEST(ContactLaws, pitches_repeat) {
  over_contacts(27, 30, [](const ContactPair& pair) {
    const auto r = over_a_pitch(pair, 10, 3);
    ASSERT_EQ(r.positions.size(), 30u);
    for (std::size_t i = 10; i < 30; ++i) {
      EXPECT_TRUE(same_bits(r.positions[i].te.rad(), r.positions[i - 10].te.rad()));
      EXPECT_EQ(r.positions[i].pair, r.positions[i - 10].pair + 1);
      EXPECT_EQ(r.positions[i].kind, r.positions[i - 10].kind);
    }
    std::vector<Angle> rotations{r.positions[3].rotation1, r.positions[17].rotation1,
                                 r.positions[26].rotation1};
    const auto alone = at_rotations(pair, rotations);
    EXPECT_NEAR(alone.positions[0].te.rad(), r.positions[3].te.rad(), 1e-12);
    EXPECT_NEAR(alone.positions[1].te.rad(), r.positions[17].te.rad(), 1e-12);
    EXPECT_NEAR(alone.positions[2].te.rad(), r.positions[26].te.rad(), 1e-12);
    EXPECT_EQ(alone.positions[2].pair, r.positions[26].pair);
  });
}

// Same input, same bits.
TEST(ContactLaws, twice_is_the_same) {
  over_contacts(28, 20, [](const ContactPair& pair) {
    const auto a = over_a_pitch(pair, 16), b = over_a_pitch(pair, 16);
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
      EXPECT_TRUE(same_bits(a.positions[i].te.rad(), b.positions[i].te.rad()));
      EXPECT_EQ(a.positions[i].point, b.positions[i].point);
    }
    EXPECT_EQ(a.work.evaluations, b.work.evaluations);
  });
}

double greatest_step(std::span<const double> te) {
  double step = 0.0;
  for (std::size_t i = 1; i < te.size(); ++i) step = std::max(step, std::abs(te[i] - te[i - 1]));
  return step;
}

// The curve has no jumps: neither where the next pair or an edge takes over, nor between pieces of
// a modified flank. If a step between two positions is divided, its parts are smaller. Of 512
// steps, those are divided by 16 that are greatest, and those that differ most from their
// neighbours, as a jump does. The parts are computed without start values.
TEST(ContactLaws, the_curve_has_no_jump) {
  constexpr std::size_t kSteps = 512, kDivided = 16, kParts = 16;
  over_sets(29, {15, 4, 3}, {}, [&](const auto& set, Random&) {
    const ContactPair pair = set.pair();
    const auto curve = over_a_pitch(pair, kSteps, 2).positions;
    const auto step = [&](std::size_t i) {
      i %= kSteps;
      return curve[i + 1].te.rad() - curve[i].te.rad();
    };
    std::set<std::size_t> divided;
    double greatest = 0.0, greatest_part = 0.0;
    const auto divide_greatest = [&](const auto& size) {
      std::vector<std::pair<double, std::size_t>> steps;
      for (std::size_t i = 0; i < kSteps; ++i) steps.emplace_back(size(i), i);
      std::ranges::sort(steps, std::greater{});
      for (std::size_t k = 0; k < kDivided; ++k) divided.insert(steps[k].second);
      return steps.front().first;
    };
    greatest = divide_greatest([&](std::size_t i) { return std::abs(step(i)); });
    divide_greatest([&](std::size_t i) {
      return std::abs(step(i) - 0.5 * (step(i + kSteps - 1) + step(i + 1)));
    });
    for (const std::size_t k : divided) {
      const Angle from = curve[k].rotation1, to = curve[k + 1].rotation1;
      std::vector<Angle> rotations;
      for (std::size_t i = 0; i <= kParts; ++i)
        rotations.push_back(from + static_cast<double>(i) / kParts * (to - from));
      std::vector<double> te;
      for (const auto& at : at_rotations(pair, rotations).positions) te.push_back(at.te.rad());
      EXPECT_NEAR(te.front(), curve[k].te.rad(), 1e-12);
      EXPECT_NEAR(te.back(), curve[k + 1].te.rad(), 1e-12);
      greatest_part = std::max(greatest_part, greatest_step(te));
    }
    EXPECT_LT(greatest_part, 0.5 * greatest + 1e-13);
  });
}

TEST(LongContactLaws, the_curve_has_no_jump) {
  over_pairs(29, 60, {}, [](const ModifiedPair& p, Random&) {
    const ContactPair pair = p.set.pair();
    const auto closed_step = [&](int n) {
      std::vector<double> te = transmission_error(pair, n);
      te.push_back(te.front());
      return greatest_step(te);
    };
    EXPECT_LT(closed_step(8192), 0.5 * closed_step(512) + 1e-13);
  });
}

// Where two pieces of a modified flank meet, the field has the same value on both sides.
TEST(ContactLaws, pieces_meet) {
  int seams = 0;
  int ridges = 0;
  over_sets(30, {60, 5, 30}, {}, [&](const auto& set, Random& random) {
    const ContactPair pair = set.pair();
    const auto& patches = pair.patches(1);
    const FlankPatch& mate = pair.patches(2)[0];
    const auto jet = [&](const FlankPatch& f, double s, double z) {
      const GapField field = pair.field(f, mate);
      double s2 = 0.5 * (mate.s_lo + mate.s_hi);
      return field.at(s, z, s2).t;
    };
    // A border is a ridge if and only if the slope across it jumps.
    const auto end_for = [&](double slope, double other) {
      const bool jumps = std::abs(slope - other) > 1e-8 * (std::abs(slope) + std::abs(other));
      ridges += jumps;
      return jumps ? FlankPatch::End::ridge : FlankPatch::End::seam;
    };
    for (const FlankPatch& a : patches) {
      for (const FlankPatch& b : patches) {
        const double z_lo = std::max(a.z_lo, b.z_lo), z_hi = std::min(a.z_hi, b.z_hi);
        const double s_lo = std::max(a.s_lo, b.s_lo), s_hi = std::min(a.s_hi, b.s_hi);
        if (a.s_hi == b.s_lo && z_hi > z_lo) {
          ++seams;
          const double z = random.uniform(z_lo, z_hi);
          const Jet2 x = jet(a, a.s_hi, z), y = jet(b, b.s_lo, z);
          EXPECT_NEAR(x.v, y.v, 1e-13);
          EXPECT_EQ(a.s_hi_end, end_for(x.s, y.s));
          EXPECT_EQ(b.s_lo_end, a.s_hi_end);
        }
        if (a.z_hi == b.z_lo && s_hi > s_lo) {
          ++seams;
          const double s = random.uniform(s_lo, s_hi);
          const Jet2 x = jet(a, s, a.z_hi), y = jet(b, s, b.z_lo);
          EXPECT_NEAR(x.v, y.v, 1e-13);
          EXPECT_EQ(b.z_lo_end, end_for(x.z, y.z));
          EXPECT_EQ(a.z_hi_end, b.z_lo_end);
        }
      }
    }
  });
  EXPECT_GT(seams, 30);
  EXPECT_GT(ridges, 10);
}

CylindricalSpec doubled(CylindricalSpec s) {
  s.normal_module *= 2, s.face_width *= 2, s.thickness_allowance *= 2;
  if (s.tip_diameter) *s.tip_diameter *= 2;
  return s;
}

ContactMount doubled(ContactMount mount) {
  auto& e = mount.errors;
  mount.center_distance *= 2, e.center_distance *= 2, e.axial *= 2;
  e.helix_twist[0] /= 2, e.helix_twist[1] /= 2;
  return mount;
}

ContactSet doubled(const ContactSet& set) {
  const auto made = [](const Gear& g) {
    return std::move(make_gear_with_default_cutter(doubled(g.spec))).take();
  };
  return {{made(set.gears[0]), made(set.gears[1])}, {}, doubled(set.mount)};
}

RackSet doubled(const RackSet& set) {
  auto pinion = make_gear(doubled(set.rack.pinion.spec));
  return {std::move(mount_rack(std::move(pinion).take(), {})).take(), {}, doubled(set.mount)};
}

// If all lengths are doubled, the rotations are exactly the same.
TEST(ContactLaws, scaling_by_two_is_exact) {
  Wanted want;
  want.modifications = false;
  over_sets(31, {20, 20, 20}, want, [](const auto& set, Random&) {
    const auto twice = doubled(set);
    const auto a = over_a_pitch(set.pair(), 8), b = over_a_pitch(twice.pair(), 8);
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
      EXPECT_NEAR(a.positions[i].te.rad(), b.positions[i].te.rad(), 1e-15);
      // On a gear of twice the size, a nanometre is half as large in relation to the gear.
      if (a.positions[i].kind == TouchKind::line || b.positions[i].kind == TouchKind::line)
        continue;
      EXPECT_EQ(a.positions[i].kind, b.positions[i].kind);
    }
  });
}

void reverse_hand(Gear& gear) {
  gear.lead = -gear.lead;
  gear.spec.helix_angle = -gear.spec.helix_angle;
}

ContactMount mirrored_mount(ContactMount mount) {
  auto& e = mount.errors;
  e = mirrored(e);
  e.helix_twist = {-e.helix_twist[0], -e.helix_twist[1]};
  mount.axis_angle = -mount.axis_angle;
  return mount;
}

ContactSet mirrored_hands(const ContactSet& set) {
  ContactSet other{set.gears, set.removal, mirrored_mount(set.mount)};
  for (Gear& g : other.gears) reverse_hand(g);
  return other;
}

RackSet mirrored_hands(const RackSet& set) {
  RackSet other{set.rack, set.removal, mirrored_mount(set.mount)};
  reverse_hand(other.rack.pinion);
  other.rack.rack.helix_angle = -set.rack.rack.helix_angle;
  return other;
}

// Compares with the mirror image z → −z.
TEST(ContactLaws, mirroring_both_hands) {
  Wanted want;
  want.modifications = false;
  over_sets(32, {30, 30, 20}, want, [](const auto& set, Random&) {
    const auto a = over_a_pitch(set.pair(), 8);
    const auto b = over_a_pitch(mirrored_hands(set).pair(), 8);
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
      EXPECT_NEAR(a.positions[i].te.rad(), b.positions[i].te.rad(), 1e-14);
      const Vec3 &r = a.positions[i].point, &q = b.positions[i].point;
      if (a.positions[i].kind == TouchKind::line || a.positions[i].pair != b.positions[i].pair)
        continue;
      EXPECT_LT((Vec3(q.x(), q.y(), -q.z()) - r).norm(), 1e-7 * r.norm());
    }
  });
}

// If the other gear drives, the other flanks touch. A half turn about the centre line gives TE(φ;
// Δδ, Δz) = −TE(−φ; −Δδ, −Δz).
TEST(ContactLaws, the_other_driver_is_half_a_turn) {
  Wanted want;
  want.modifications = false;
  over_sets(33, {40, 40, 20}, want, [](const auto& set, Random& random) {
    auto other = set;
    other.mount.gear2_drives = !set.mount.gear2_drives;
    other.mount.errors.intersecting = -set.mount.errors.intersecting;
    other.mount.errors.axial = -set.mount.errors.axial;
    std::vector<Angle> rotations, back;
    for (int i = 0; i < 5; ++i) rotations.push_back(Angle::radians(random.uniform(-0.2, 0.2)));
    for (const Angle r : rotations) back.push_back(-r);
    const auto a = at_rotations(set.pair(), rotations), b = at_rotations(other.pair(), back);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(a.positions[i].te.rad(), -b.positions[i].te.rad(), 1e-14);
      EXPECT_EQ(a.positions[i].kind, b.positions[i].kind);
    }
  });
}

// If the gears are exchanged, the same flanks touch, as seen from the other axis. The rotation −φ_2
// − π/z_2 of the new gear 1 corresponds to φ_1, and the ratio converts the transmission error.
TEST(ContactLaws, exchanging_the_gears) {
  Wanted want;
  want.modifications = false;
  int pairs = 0;
  over_pairs(34, 40, want, [&pairs](const ModifiedPair& p, Random& random) {
    if (p.set.gears[1].internal()) return;
    ++pairs;
    ContactSet set = p.set;
    auto& e = set.mount.errors;
    e.intersecting = Angle();
    if (random.chance(0.5))
      e.axial = 0.0;
    else
      e.crossing = Angle();
    ContactSet other{{set.gears[1], set.gears[0]}, {}, set.mount};
    other.mount.errors.axial = -e.axial;
    std::swap(other.mount.errors.helix_twist[0], other.mount.errors.helix_twist[1]);
    const double z1 = set.gears[0].spec.teeth, z2 = set.gears[1].spec.teeth;
    std::vector<Angle> rotations, seen;
    for (int i = 0; i < 5; ++i) rotations.push_back(Angle::radians(random.uniform(-0.2, 0.2)));
    const auto a = at_rotations(set.pair(), rotations);
    for (const ContactPoint& q : a.positions)
      seen.push_back(-q.rotation2 - Angle::radians(kPi / z2));
    const auto b = at_rotations(other.pair(), seen);
    // Contacts of several tooth pairs within 1e-13 rad count as the same.
    for (int i = 0; i < 5; ++i)
      EXPECT_NEAR(b.positions[i].te.rad(), z2 / z1 * a.positions[i].te.rad(),
                  1e-13 * (1 + z2 / z1));
  });
  EXPECT_GT(pairs, 15);
}

// ---- maps ----

TEST(ContactLaws, a_map_does_not_depend_on_threads) {
  const ContactSet set = contact_set(some_arcs());
  std::vector<double> x, y;
  for (int i = 0; i < 7; ++i) x.push_back(1e-4 * (i - 3)), y.push_back(0.01 * (i - 3));
  const auto te_at = [&set](double crossing, double d_center) {
    ContactSet s = set;
    s.mount.errors.crossing = Angle::radians(crossing), s.mount.errors.center_distance = d_center;
    return transmission_error(s.pair(), 16);
  };
  const ErrorMap one = map_of_errors(x, y, te_at, 1);
  for (const int threads : {2, 3, 0}) {
    const ErrorMap other = map_of_errors(x, y, te_at, threads);
    for (std::size_t i = 0; i < y.size(); ++i)
      for (std::size_t k = 0; k < x.size(); ++k)
        EXPECT_TRUE(same_bits(one.value[i][k], other.value[i][k]));
  }
  // dC alone has no effect, but the other error does.
  for (std::size_t i = 0; i < y.size(); ++i) {
    EXPECT_LT(one.value[i][3], 1e-13);
    EXPECT_GT(one.value[i][0], 1e-6);
  }
}

}  // namespace
}  // namespace gearwright::property
