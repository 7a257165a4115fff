// Compares internal pairs on crossed axes with a search over a dense set of points on their flanks
// (brute_flanks.hpp), which uses no rack, no line of action and no curvature.
//
//   ρ_1    curvature radius of flank 1 in its transverse section, a place on the line of action
//   T      turn of gear 2 from the expected rotation until its flank passes a point of flank 1
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/saddle_gap.hpp"
#include "tests/oracle/contact_gears.hpp"
#include "tests/property/random_crossed.hpp"

namespace gearwright::oracle {
namespace {

using property::CrossedSpecs;
using property::Random;

// Applies a lead crowning of C, mm, to a gear, in the engine and in the search.
void crown(ContactSet& s, BrutePair& brute, int i, double C) {
  if (C == 0.0) return;
  FlankModifications m;
  m.lead_crowning = C;
  const Gear& g = s.gears[static_cast<std::size_t>(i)];
  const double b = g.spec.face_width;
  s.removal[static_cast<std::size_t>(i)] = std::make_shared<RemovalField>(
      m, FlankExtent{g.base_radius(), *g.root_form_radius(), g.tip_form_radius(), b});
  (i == 0 ? brute.one : brute.two).removed = [C, b](double, double z) {
    return 4 * C * z * z / b / b;
  };
}

// The rotation of gear 1 at which flank 1 of pair 0 passes the point of the line of action.
struct OnLine {
  double rotation, rho, z;
};
OnLine on_line(const CrossedPair& p, const BrutePair& brute, double rho1) {
  const Vec3 r = (brute.gear2_drives ? p.on_trailing_line(rho1) : p.on_line_of_action(rho1)).r;
  const double rho = std::hypot(r.x(), r.y());
  const double at = std::numbers::pi + brute.one.turn(rho, r.z()) - std::atan2(r.y(), r.x());
  return {std::remainder(at, 2 * std::numbers::pi), rho, r.z()};
}

// T by second differences over (ρ, z): slopes and the determinant of the second derivatives.
struct Differences {
  double value, by_rho, by_z, determinant;
};
Differences differences(const BruteContact& brute, const OnLine& at, double step) {
  const auto T = [&](int i, int j) {
    return brute.look(at.rotation, 0, at.rho + i * step, at.z + j * step).te;
  };
  const double h = step * step;
  const double ss = (T(1, 0) - 2 * T(0, 0) + T(-1, 0)) / h;
  const double zz = (T(0, 1) - 2 * T(0, 0) + T(0, -1)) / h;
  const double sz = (T(1, 1) - T(1, -1) - T(-1, 1) + T(-1, -1)) / (4 * h);
  return {T(0, 0), (T(1, 0) - T(-1, 0)) / (2 * step), (T(0, 1) - T(0, -1)) / (2 * step),
          ss * zz - sz * sz};
}

// Both flanks pass every point of the line of action at the expected rotation and are tangent to
// each other, so their ratio is constant. The path ends where a point leaves a flank. The gap is a
// saddle. If the crowning exceeds the needed one, it becomes a minimum.
TEST(CrossedInternal, flanks_are_tangent_on_the_line_and_overlap_beside_it) {
  Random random(5101);
  int pairs = 0, crowned = 0;
  double worst = 0.0;
  for (int i = 0; i < 400 && pairs < 60; ++i) {
    CrossedSpecs specs;
    const auto p = property::crossed_pair_with_ring(random, i % 2 ? 0.0 : 0.05, specs);
    if (!p || !(p->mesh.true_ratio > 0.3)) continue;
    // At a base circle the surface ends, so differences cannot be computed.
    if (!(p->mesh.rho1_true_begin > 0.2 * specs.first.normal_module)) continue;
    SCOPED_TRACE(property::describe(specs));
    ++pairs;
    const double size = p->input.gears[1].radius;
    for (const bool gear2_drives : {false, true}) {
      ContactSet set = contact_set(*p, gear2_drives);
      const BrutePair plain = brute_pair(set);
      const BruteContact brute(plain);
      const double half_play = p->mesh.backlash.rotation[1] / 2;
      const double expected = gear2_drives ? half_play : -half_play;
      constexpr double kFirst = 0.02, kLast = 0.98;  // inside both flanks, for the differences
      for (const double part : {kFirst, 0.3, 0.7, kLast}) {
        const double rho1 =
            p->mesh.rho1_true_begin + part * (p->mesh.rho1_true_end - p->mesh.rho1_true_begin);
        const OnLine at = on_line(*p, plain, rho1);
        const auto seen = brute.look(at.rotation, 0, at.rho, at.z);
        EXPECT_LT(seen.outside, 1e-10 * size);
        const Differences d = differences(brute, at, 2e-5 * size);
        EXPECT_NEAR(d.value, expected, 1e-12);
        worst = std::max(worst, std::abs(d.value - expected));
        EXPECT_NEAR(d.by_rho * size, 0.0, 1e-5);
        EXPECT_NEAR(d.by_z * size, 0.0, 1e-5);
        EXPECT_LT(d.determinant, 0.0);
        // The crowning is centred on the middle of the face, where the contact remains. Near the
        // tangent point, the second derivatives are therefore those of the crowned flanks.
        for (const int gear : {0, 1}) {
          const auto& needed = p->needed_crowning[static_cast<std::size_t>(gear)];
          if (!needed || part != (gear == 0 ? kFirst : kLast)) continue;
          for (const double more : {0.98, 1.02}) {
            BrutePair other = plain;
            ContactSet unused = contact_set(*p, gear2_drives);
            crown(unused, other, gear, more * *needed);
            const Differences c = differences(BruteContact(other), at, 2e-5 * size);
            EXPECT_EQ(c.determinant > 0.0, more > 1.0) << "gear " << gear + 1;
            std::array<double, 2> crowning{};
            crowning[static_cast<std::size_t>(gear)] = more * *needed;
            EXPECT_EQ(clears_beside_line(p->input, p->mesh, crowning), more > 1.0);
            ++crowned;
          }
        }
      }
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(pairs, 60);
  EXPECT_GT(crowned, 200);
  std::printf("crossed internal: %d pairs, T on the line %.1e rad\n", pairs, worst);
}

// The length of the path equals the rotation between its ends: AE/p_bn pitches of gear 1.
TEST(CrossedInternal, contact_ratio_is_the_rotation_between_the_ends) {
  Random random(5102);
  int pairs = 0;
  for (int i = 0; i < 200 && pairs < 40; ++i) {
    CrossedSpecs specs;
    const auto p = property::crossed_pair_with_ring(random, 0.0, specs);
    if (!p || !(p->mesh.rho1_A > 0.0)) continue;
    SCOPED_TRACE(property::describe(specs));
    ++pairs;
    const BrutePair brute = brute_pair(contact_set(*p, false));
    const OnLine A = on_line(*p, brute, p->mesh.rho1_A), E = on_line(*p, brute, p->mesh.rho1_E);
    const double pitch = 2 * std::numbers::pi / p->gears[0].spec.teeth;
    EXPECT_NEAR(
        std::remainder(E.rotation - A.rotation - p->contact_ratio() * pitch, 2 * std::numbers::pi),
        0.0, 1e-11);
    EXPECT_NEAR(E.rho, p->gears[0].tip_form_radius(), 1e-11 * E.rho);
  }
  EXPECT_EQ(pairs, 40);
}

// Under errors of every kind, with crowned and plain leads, for both driving directions: no point
// of the flanks touches before the contact of the engine, and this contact is a point of both
// flanks.
struct Tally {
  int pairs = 0, edges = 0, inside = 0;
  double below = 0.0;
};
Tally compare(std::uint64_t seed, int pairs, int sections, int radii) {
  Random random(seed);
  Tally tally;
  for (int i = 0; i < 20 * pairs && tally.pairs < pairs; ++i) {
    CrossedSpecs specs;
    const auto p = property::crossed_pair_with_ring(random, 0.02, specs);
    if (!p || !(p->mesh.true_ratio > 0.8)) continue;
    SCOPED_TRACE(property::describe(specs));
    ++tally.pairs;
    ContactSet set = contact_set(*p, random.chance(0.4));
    const auto sign = [&random] { return random.chance(0.5) ? 1.0 : -1.0; };
    if (random.chance(0.6)) {
      const double size = random.logarithmic(1e-2, 1.0);
      set.mount.errors.center_distance = -0.03 * size * random.unit();
      set.mount.errors.crossing = Angle::radians(2e-3 * size * sign() * random.unit());
      set.mount.errors.intersecting = Angle::radians(2e-3 * size * sign() * random.unit());
      set.mount.errors.axial = 0.5 * size * sign() * random.unit();
      set.mount.errors.helix_twist[0] = 1e-4 * size * sign() * random.unit();
    }
    BrutePair brute = brute_pair(set);
    const int crowned = random.integer(0, 3);
    for (const int g : {0, 1}) {
      const auto& needed = p->needed_crowning[static_cast<std::size_t>(g)];
      if ((crowned & (g + 1)) != 0 && needed)
        crown(set, brute, g, std::min(0.1, *needed * random.uniform(0.5, 4.0)));
    }
    const BruteContact places(brute);
    const ContactPair contact = set.pair();
    ContactRequest request;
    for (int k = 0; k < 3; ++k)
      request.rotations.push_back(Angle::radians(contact.pitch() * random.uniform(-0.5, 0.5)));
    const ContactResult r = analyse_contact(contact, request);
    EXPECT_EQ(r.unfinished, 0);
    for (const ContactPoint& q : r.positions) {
      SCOPED_TRACE(::testing::Message() << to_string(q.kind) << " at " << q.rotation1.rad()
                                        << " gear2_drives " << set.mount.gear2_drives);
      const auto dense = places.touch(q.rotation1.rad(), 3, sections, radii);
      EXPECT_EQ(dense.has_value(), q.kind != TouchKind::none);
      if (!dense || q.kind == TouchKind::none) continue;
      (q.kind == TouchKind::interior ? tally.inside : tally.edges) += 1;
      const auto seen = places.look(q.rotation1.rad(), q.pair, q.diameter[0] / 2, q.height[0]);
      EXPECT_NEAR(seen.te, q.te.rad(), 1e-12);
      EXPECT_LT(seen.outside, 1e-9 * q.diameter[1]);
      const double sense = set.mount.gear2_drives ? -1.0 : 1.0;
      const double ahead = sense * (dense->te - q.te.rad());
      EXPECT_LT(ahead, 1e-12);
      tally.below = std::max(tally.below, -ahead);
    }
    if (::testing::Test::HasFailure()) break;
  }
  std::printf(
      "crossed internal contact: %d pairs, %d inside, %d at edges, search below by %.1e rad\n",
      tally.pairs, tally.inside, tally.edges, tally.below);
  return tally;
}

TEST(CrossedInternal, contact_under_errors_against_dense_places) {
  const Tally t = compare(5103, 12, 60, 40);
  EXPECT_EQ(t.pairs, 12);
  EXPECT_GT(t.edges, 8);
  EXPECT_GT(t.inside, 4);
}
TEST(LongCrossedInternal, contact_under_errors_against_dense_places) {
  const Tally t = compare(5104, 200, 60, 40);
  EXPECT_EQ(t.pairs, 200);
}

// If there are no errors and no crowning, gear 2 is ahead of its position on the line of action by
// at most the depth that is attributed to the saddle.
TEST(CrossedInternal, edges_lead_by_no_more_than_the_saddle) {
  Random random(5107);
  int pairs = 0;
  double most = 0.0;
  for (int i = 0; i < 400 && pairs < 60; ++i) {
    CrossedSpecs specs;
    const auto p = property::crossed_pair_with_ring(random, 0.1, specs);
    if (!p || !p->interference.empty() || !(p->mesh.true_ratio > 1.0)) continue;
    if (!p->needed_crowning[0] || !p->needed_crowning[1]) continue;
    SCOPED_TRACE(property::describe(specs));
    ++pairs;
    const ContactSet set = contact_set(*p, false);
    const ContactPair contact = set.pair();
    ContactRequest request;
    for (int j = 0; j < 8; ++j)
      request.rotations.push_back(Angle::radians(contact.pitch() * (j / 8.0 - 0.5)));
    const BaseGear<double>& g = p->input.gears[1];
    const double arm = g.radius * std::cos(g.helix_angle);
    double depth = 0.0;
    for (const std::size_t k : {0U, 1U}) {
      const double off = std::min(1.0, p->face_widths.both_flanks[k] / p->input.face_width[k]);
      depth = std::max(depth, *p->needed_crowning[k] * (1 + off) * (1 + off));
    }
    for (const ContactPoint& q : analyse_contact(contact, request).positions) {
      EXPECT_TRUE(is_edge(q.kind)) << to_string(q.kind);
      const double ahead = (q.te.rad() + p->mesh.backlash.rotation[1] / 2) * arm;
      EXPECT_GT(ahead, -1e-10);
      EXPECT_LT(ahead, 1.5 * depth);
      most = std::max(most, ahead / depth);
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(pairs, 60);
  std::printf("crossed internal: edges lead by at most %.2f of the depth\n", most);
}

// A spur pinion touches its helical mating gear in one section at all positions. If it is crowned
// around this section by more than needed, the ratio remains exact.
TEST(CrossedInternal, a_crowned_spur_gear_keeps_the_ratio) {
  Random random(5105);
  int pairs = 0;
  for (int i = 0; i < 4000 && pairs < 20; ++i) {
    CrossedSpecs specs;
    auto p = property::crossed_pair_with_ring(random, 0.03, specs);
    if (!p) continue;
    const int spur = specs.first.helix_angle.rad() == 0.0 ? 0 : 1;
    const auto k = static_cast<std::size_t>(spur);
    if ((spur == 1 && specs.second.helix_angle.rad() != 0.0) || !p->needed_crowning[k]) continue;
    // Near its base circle, a flank is not well approximated by a quadratic surface.
    if (!(p->mesh.rho1_A > 0.5 * specs.first.normal_module)) continue;
    // The section of the contact is the middle of the face only at X = 0.
    const auto at_least =
        mount_as<CrossedPair>(p->gears[0], p->gears[1],
                              {p->min_distance->center_distance, p->min_distance->shaft_angle, {}});
    ASSERT_TRUE(at_least);
    if (!(at_least->mesh.true_ratio > 1.02)) continue;
    const double crowning = 3.0 * at_least->needed_crowning[k].value_or(1.0);
    if (crowning > 0.05 * specs.first.normal_module)
      continue;  // a greater crowning is not a modification
    SCOPED_TRACE(property::describe(specs));
    ++pairs;
    ContactSet set = contact_set(*at_least, i % 2 == 0);
    BrutePair unused = brute_pair(set);
    crown(set, unused, spur, crowning);
    ContactRequest request;
    const ContactPair contact = set.pair();
    for (int j = 0; j < 9; ++j)
      request.rotations.push_back(Angle::radians(contact.pitch() * (j / 9.0 - 0.5)));
    for (const ContactPoint& q : analyse_contact(contact, request).positions) {
      EXPECT_EQ(q.kind, TouchKind::interior) << to_string(q.kind);
      EXPECT_NEAR(q.te.rad(), 0.0, 1e-12);
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(pairs, 20);
}

// The tip cylinders are sampled within both faces. They reach as far as the clearances state.
TEST(CrossedInternal, tips_come_closest_at_the_ends_of_the_faces) {
  Random random(5106);
  int pairs = 0;
  for (int i = 0; i < 200 && pairs < 40; ++i) {
    CrossedSpecs specs;
    const auto p = property::crossed_pair_with_ring(random, 0.0, specs);
    if (!p) continue;
    SCOPED_TRACE(property::describe(specs));
    ++pairs;
    const double sigma = p->axis_angle().rad();
    const Vec3 axis_2(0.0, std::sin(sigma), std::cos(sigma)), foot_2(p->center_distance, 0.0, 0.0);
    const Vec3 across_2(0.0, std::cos(sigma), -std::sin(sigma));
    const double half_1 = p->gears[0].spec.face_width / 2, half_2 = p->gears[1].spec.face_width / 2;
    double farthest = 0.0, nearest = std::numeric_limits<double>::infinity();
    constexpr int kAround = 1200, kAlong = 200;
    for (int k = 0; k <= kAround; ++k) {
      const double at = std::numbers::pi * (k - kAround / 2) / kAround;
      for (int j = 0; j <= kAlong; ++j) {
        const double part = 2.0 * j / kAlong - 1.0;
        const double r_1 = p->gears[0].actual_tip_radius();
        const Vec3 q_1(-r_1 * std::cos(at), r_1 * std::sin(at), part * half_1);
        if (std::abs((q_1 - foot_2).dot(axis_2)) <= half_2)
          farthest = std::max(farthest, (q_1 - foot_2).cross(axis_2).norm());
        const double r_2 = p->gears[1].actual_tip_radius();
        const Vec3 q_2 = foot_2 + Vec3(-r_2 * std::cos(at), 0.0, 0.0) +
                         r_2 * std::sin(at) * across_2 + part * half_2 * axis_2;
        if (std::abs(q_2.z()) <= half_1) nearest = std::min(nearest, std::hypot(q_2.x(), q_2.y()));
      }
    }
    const double of_1 = p->gears[1].root_diameter / 2 - farthest;
    const double of_2 = nearest - p->gears[0].root_diameter / 2;
    const double rough = 2e-4 * p->input.gears[1].radius;  // of a step of the samples
    EXPECT_LE(p->tip_clearance[0], of_1 + 1e-9);
    EXPECT_GT(p->tip_clearance[0], of_1 - rough);
    EXPECT_LE(p->tip_clearance[1], of_2 + 1e-9);
    EXPECT_GT(p->tip_clearance[1], of_2 - rough);
  }
  EXPECT_EQ(pairs, 40);
}

}  // namespace
}  // namespace gearwright::oracle
