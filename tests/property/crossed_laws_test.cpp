// Laws of pairs on crossed axes, over seeded pairs, and their limit for parallel axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/differentiation/autodiff.hpp>
#include <cmath>
#include <numbers>

#include "gearwright/base/testing/numbers.hpp"
#include "tests/property/random_crossed.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright::property {
namespace {

using testing::kEps;
constexpr int kCrossedPairs = 600;

template <class Draw, class Law>
void over_pairs(std::uint64_t seed, Draw draw, Law law) {
  Random random(seed);
  int held = 0;
  for (int i = 0; i < kCrossedPairs; ++i) {
    const CrossedSpecs specs = draw(random);
    const auto pair = mounted(specs, i % 2 ? 0.0 : 0.1 * random.unit());
    if (!pair) continue;
    ++held;
    law(specs, *pair, random);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "the pair: " << describe(specs);
      break;
    }
  }
  EXPECT_GT(held, kCrossedPairs / 3);
}

// External pairs.
template <class Law>
void over_external(std::uint64_t seed, double least, Law law) {
  over_pairs(
      seed, [least](Random& random) { return random_crossed(random, least); }, law);
}

// External pairs, then internal ones.
template <class Law>
void over_crossed(std::uint64_t seed, double least, Law law) {
  over_external(seed, least, law);
  if (!::testing::Test::HasFailure())
    over_pairs(
        seed, [](Random& random) { return random_crossed_internal(random); }, law);
}

// Rounding errors of the angles, converted to lengths. Nearly parallel axes increase them by the
// factor 1/sin Σ.
double grain(const CrossedPair& p) {
  return 256 * kEps * (p.center_distance + p.input.gears[1].radius) /
         std::abs(std::sin(p.shaft_angle.rad()));
}

TEST(CrossedLaws, exchanging_the_gears) {
  over_external(401, 5.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random&) {
    const auto q =
        mount_as<CrossedPair>(p.gears[1], p.gears[0], {p.center_distance, specs.shaft_angle, 0.05});
    ASSERT_TRUE(q) << q.error().message();
    const double tiny = grain(p);
    const auto &m = p.mesh, &n = q->mesh;
    EXPECT_NEAR(m.rack.normal_pressure_angle, n.rack.normal_pressure_angle, 1e-13);
    for (int i : {0, 1}) {
      EXPECT_NEAR(m.rack.sides[i].pitch_radius, n.rack.sides[1 - i].pitch_radius, tiny);
      EXPECT_NEAR(m.rack.sides[i].helix_angle, n.rack.sides[1 - i].helix_angle, 1e-13);
      EXPECT_NEAR(m.backlash.rotation[i], n.backlash.rotation[1 - i], tiny);
      EXPECT_NEAR(p.face_widths.one_flank[i], q->face_widths.one_flank[1 - i], tiny * 4);
      EXPECT_NEAR(p.face_widths.both_flanks[i], q->face_widths.both_flanks[1 - i], tiny * 16);
    }
    EXPECT_NEAR(m.pitch_plane_distance, n.pitch_plane_distance, tiny);
    EXPECT_NEAR(m.path_ratio, n.path_ratio, tiny);
    EXPECT_NEAR(m.rho2(m.rho1_E), n.rho1_A, tiny);
    EXPECT_EQ(p.efficiency.has_value(), q->efficiency.has_value());
    if (p.efficiency && p.efficiency->gear1_drives && q->efficiency->gear2_drives) {
      EXPECT_NEAR(*p.efficiency->gear1_drives, *q->efficiency->gear2_drives, 1e-9);
    }
  });
}

TEST(CrossedLaws, mirroring_both_hands) {
  over_crossed(402, 5.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random&) {
    CrossedSpecs other = specs;
    other.first.helix_angle = -specs.first.helix_angle;
    other.second.helix_angle = -specs.second.helix_angle;
    other.shaft_angle = -specs.shaft_angle;
    const auto g1 = make_gear(other.first), g2 = make_gear(other.second);
    ASSERT_TRUE(g1 && g2);
    const auto q = mount_as<CrossedPair>(*g1, *g2, {p.center_distance, other.shaft_angle, 0.05});
    ASSERT_TRUE(q) << q.error().message();
    EXPECT_EQ(p.mesh.path_ratio, q->mesh.path_ratio);
    EXPECT_EQ(p.mesh.backlash.normal_base, q->mesh.backlash.normal_base);
    EXPECT_EQ(p.mesh.rack.sides[0].helix_angle, -q->mesh.rack.sides[0].helix_angle);
    EXPECT_EQ(p.mesh.line_offset, -q->mesh.line_offset);
    EXPECT_EQ(p.face_widths.both_flanks, q->face_widths.both_flanks);
    const Vec3 A = p.on_line_of_action(p.mesh.rho1_A).r;
    const Vec3 B = q->on_line_of_action(q->mesh.rho1_A).r;
    EXPECT_EQ(A.x(), B.x());
    EXPECT_EQ(A.y(), B.y());
    EXPECT_EQ(A.z(), -B.z());
  });
}

TEST(CrossedLaws, scaling_by_two_is_exact) {
  over_crossed(403, 5.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random&) {
    CrossedSpecs twice = specs;
    for (CylindricalSpec* s : {&twice.first, &twice.second}) {
      s->normal_module *= 2;
      s->face_width *= 2;
    }
    const auto g1 = make_gear(twice.first), g2 = make_gear(twice.second);
    ASSERT_TRUE(g1 && g2);
    const auto q =
        mount_as<CrossedPair>(*g1, *g2, {2 * p.center_distance, specs.shaft_angle, 0.05});
    ASSERT_TRUE(q);
    EXPECT_EQ(q->mesh.pitch_plane_distance, 2 * p.mesh.pitch_plane_distance);
    EXPECT_EQ(q->mesh.path_length, 2 * p.mesh.path_length);
    EXPECT_EQ(q->mesh.path_ratio, p.mesh.path_ratio);
    EXPECT_EQ(q->mesh.backlash.rotation, p.mesh.backlash.rotation);
    EXPECT_EQ(q->mesh.line_offset, 2 * p.mesh.line_offset);
    ASSERT_EQ(q->min_distance.has_value(), p.min_distance.has_value());
    if (p.min_distance) {
      EXPECT_EQ(q->min_distance->center_distance, 2 * p.min_distance->center_distance);
      EXPECT_EQ(q->min_distance->shaft_angle, p.min_distance->shaft_angle);
    }
  });
}

double line_to_axis(const Vec3& p, const Vec3& d, const Vec3& q, const Vec3& axis) {
  const Vec3 n = d.cross(axis);
  return std::abs((p - q).dot(n)) / n.norm();
}

// The line of action touches both base cylinders, and its ends lie on the tip cylinders.
TEST(CrossedLaws, line_of_action) {
  over_crossed(404, 5.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random&) {
    if (!(p.mesh.path_length > 0.05 * p.mesh.step)) return;
    const double tiny = 64 * grain(p) / std::abs(std::sin(p.shaft_angle.rad()));
    const Vec3 A = p.on_line_of_action(p.mesh.rho1_A).r, E = p.on_line_of_action(p.mesh.rho1_E).r;
    const double alpha = p.mesh.rack.normal_pressure_angle;
    const double beta = p.mesh.rack.sides[0].helix_angle;
    const Vec3 n(p.side() * std::sin(alpha), -p.side() * std::cos(alpha) * std::cos(beta),
                 std::cos(alpha) * std::sin(beta));
    EXPECT_LT(((E - A) - n * p.path_length()).norm(), tiny);
    const double turn = p.side() * specs.shaft_angle.rad();
    const Vec3 axis_2(0.0, std::sin(turn), std::cos(turn));
    const Vec3 foot_2(p.center_distance, 0.0, 0.0);
    EXPECT_NEAR(line_to_axis(A, n, Vec3::Zero(), Vec3::UnitZ()), p.input.gears[0].radius, tiny);
    EXPECT_NEAR(line_to_axis(A, n, foot_2, axis_2), p.input.gears[1].radius, tiny);
    EXPECT_NEAR(E.head<2>().norm(), p.input.tip_form_radius[0], tiny);
    EXPECT_NEAR((A - foot_2).cross(axis_2).norm(), p.input.tip_form_radius[1], tiny);
    EXPECT_NEAR((A - foot_2).dot(axis_2), axial_place(p.mesh, p.mesh.rho1_A)[1], tiny);
    const Vec3 trailing = p.on_trailing_line(p.mesh.rho1_E).r;
    EXPECT_EQ(trailing, Vec3(E.x(), 0.0 - E.y(), 0.0 - E.z()));
  });
}

// Backlash is linear in a and zero at the backlash-free distance.
TEST(CrossedLaws, backlash) {
  over_crossed(405, 5.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random& random) {
    ASSERT_TRUE(p.backlash_free_center_distance);
    const double more = random.uniform(-0.2, 0.5);
    const auto q = mount_as<CrossedPair>(
        p.gears[0], p.gears[1],
        {*p.backlash_free_center_distance + p.side() * more, specs.shaft_angle});
    ASSERT_TRUE(q);
    EXPECT_NEAR(q->mesh.backlash.normal_base, 2 * more * p.mesh.rack.angles.sin_alpha, grain(p));
    EXPECT_EQ(q->mesh.rack.normal_pressure_angle, p.mesh.rack.normal_pressure_angle);
    const auto& b = q->mesh.backlash;
    for (int i : {0, 1}) {
      EXPECT_NEAR(b.rotation[i] * q->mesh.rack.sides[i].pitch_radius, b.circumferential[i],
                  8 * kEps * std::abs(b.circumferential[i]));
    }
    // Both flanks lose the same part of p_n.
    EXPECT_NEAR(b.circumferential[0] * q->mesh.rack.sides[0].cos_helix, b.normal, grain(p));
    EXPECT_NEAR(b.circumferential[1] * q->mesh.rack.sides[1].cos_helix, b.normal, grain(p));
  });
}

using Dual = boost::math::differentiation::autodiff_fvar<double, 1>;

// c(α_n) is evaluated with dual numbers. Its slope is −X/tan α_n, which changes sign at the minimum
// distance.
TEST(CrossedLaws, the_slope_of_the_distance) {
  over_crossed(406, 5.0, [](const CrossedSpecs&, const CrossedPair& p, Random&) {
    const BasePair<double>& g = p.input.gears;
    BasePair<Dual> dual;
    for (int i : {0, 1}) {
      dual[i] = {g[i].teeth, Dual(g[i].radius), Dual(g[i].tooth_thickness), Dual(g[i].helix_angle)};
    }
    const double alpha_n = p.mesh.rack.normal_pressure_angle;
    const Dual alpha = boost::math::differentiation::make_fvar<double, 1>(alpha_n);
    const Dual a =
        conjugate_center_distance(dual, common_rack<Dual>(dual, angles_at<Dual>(dual, alpha)));
    const auto rack = common_rack(g, angles_at(g, alpha_n));
    const double slope = conjugate_center_distance_slope(g, rack);
    EXPECT_NEAR(a.derivative(1), slope, 1e-12 * p.center_distance / alpha_n);
    // The formula that avoids cancellation is r_2 + σ (r_1 + X).
    EXPECT_NEAR(a.derivative(0),
                rack.sides[1].pitch_radius +
                    p.side() * (rack.sides[0].pitch_radius + rack.tight_plane_distance()),
                grain(p));
    ASSERT_TRUE(p.min_distance);
    for (const double away : {-0.02, -1e-3, 1e-3, 0.02}) {
      const double there = p.min_distance->normal_pressure_angle.rad() + away;
      EXPECT_GT(conjugate_center_distance(g, common_rack(g, angles_at(g, there))),
                p.min_distance->center_distance);
    }
  });
}

// To first order, dΣ changes a by σ z_L/tan α_n.
TEST(CrossedLaws, the_slope_over_the_shaft_angle) {
  over_crossed(407, 10.0, [](const CrossedSpecs& specs, const CrossedPair& p, Random&) {
    const BasePair<double>& g = p.input.gears;
    // The accuracy of α_n depends on the distance of Σ from the end of its range.
    const double step = 1e-4 * std::abs(specs.shaft_angle.rad() - shaft_angle_range(g).from);
    const auto distance = [&](double sigma) {
      return conjugate_center_distance(g, common_rack(g, angles_at_shaft_angle(g, sigma)));
    };
    const double numeric =
        (distance(specs.shaft_angle.rad() + step) - distance(specs.shaft_angle.rad() - step)) /
        (2 * step);
    const auto tight = mount_as<CrossedPair>(p.gears[0], p.gears[1],
                                             {*p.backlash_free_center_distance, specs.shaft_angle});
    ASSERT_TRUE(tight);
    const double slope = p.side() * tight->mesh.line_offset * p.mesh.rack.angles.cos_alpha /
                         p.mesh.rack.angles.sin_alpha;
    EXPECT_NEAR(numeric, slope, 1e-5 * (std::abs(slope) + p.center_distance));
  });
}

// For a distance above the minimum, both positions have exactly that distance.
TEST(CrossedLaws, two_shaft_angles_of_a_distance) {
  over_external(408, 5.0, [](const CrossedSpecs&, const CrossedPair& p, Random& random) {
    const BasePair<double>& g = p.input.gears;
    const double a = p.min_distance->center_distance * (1 + 0.02 * random.unit());
    const auto places = transverse_angles_at_distance(g, a);
    ASSERT_GE(places.size(), 1u);
    for (const double alpha : places)
      EXPECT_NEAR(crossed_place(g, alpha).center_distance, a, 16 * kEps * a);
    EXPECT_TRUE(
        transverse_angles_at_distance(g, p.min_distance->center_distance * (1 - 1e-9)).empty());
    if (places.size() == 2) {
      const Angle middle = p.min_distance->normal_pressure_angle;
      EXPECT_LT(crossed_place(g, places[0]).normal_pressure_angle, middle);
      EXPECT_GT(crossed_place(g, places[1]).normal_pressure_angle, middle);
    }
  });
}

// The contact ratio is 1 at the ends of the interval, greater inside and smaller outside.
TEST(CrossedLaws, range_of_the_contact_ratio) {
  int ends = 0;
  over_external(409, 5.0, [&](const CrossedSpecs&, const CrossedPair& p, Random&) {
    const auto ratio_at = [&](const CrossedPlace& place) {
      MeshInput<double> in = p.input;
      in.shaft_angle = place.shaft_angle.rad();
      in.center_distance = place.center_distance;
      return mesh_of(in).path_ratio;
    };
    if (!p.contact_ratio_range) {
      ASSERT_TRUE(p.min_distance);
      EXPECT_LT(ratio_at(*p.min_distance), 1.0);
      return;
    }
    const CrossedPlaces& r = *p.contact_ratio_range;
    const double noise = 1e-9;
    EXPECT_NEAR(ratio_at(r.lo), 1.0, noise);
    const auto alpha_of = [&](const CrossedPlace& c) {
      const int g = limiting_gear(p.input.gears);
      return std::asin(std::min(
          1.0, std::sin(c.normal_pressure_angle.rad()) / std::cos(p.input.gears[g].helix_angle)));
    };
    const double lo = alpha_of(r.lo), hi = alpha_of(r.hi);
    for (const double t : {0.1, 0.5, 0.9}) {
      EXPECT_GT(ratio_at(crossed_place(p.input.gears, lo + t * (hi - lo))), 1.0);
    }
    EXPECT_LT(ratio_at(crossed_place(p.input.gears, lo * 0.98)), 1.0);
    if (!r.limit) {
      ++ends;
      EXPECT_NEAR(ratio_at(r.hi), 1.0, noise);
      const double past = std::min(hi + 0.01, 0.5 * (hi + std::numbers::pi / 2));
      EXPECT_LT(ratio_at(crossed_place(p.input.gears, past)), 1.0);
    }
  });
  EXPECT_GT(ends, 50);
}

// As β_b1 + β_b2 → 0, the pair at the minimum distance becomes the parallel pair, with the same a,
// angles, diameters, thicknesses and law of backlash.
TEST(CrossedLaws, parallel_axes_are_the_limit) {
  Random random(410);
  int held = 0;
  for (int i = 0; i < 400; ++i) {
    const SpecPair specs = random_pair(random, i >= 200);
    const auto p = mounted(specs);
    if (!p) continue;
    ++held;
    const auto rack_p = p->mesh.rack;
    double last = 1.0;
    for (const double tilt : {1e-3, 1e-5, 1e-7}) {
      BasePair<double> g = p->input.gears;
      // The normal section is unchanged: base pitch and normal base thickness remain the same.
      const double c = std::cos(g[1].helix_angle);
      g[1].helix_angle += tilt;
      const double ratio = c / std::cos(g[1].helix_angle);
      g[1].radius *= ratio;
      g[1].tooth_thickness *= ratio;
      ASSERT_FALSE(axes_are_parallel(g));
      const auto alpha = transverse_angle_at_min_distance(g);
      ASSERT_TRUE(alpha);
      const auto rack = common_rack(g, angles_at_transverse(g, *alpha));
      // All differences are of first order in the tilt.
      const double a = conjugate_center_distance(g, rack);
      const double scale = 50 * tilt + 1e-12;
      EXPECT_NEAR(a, p->center_distance, scale * p->center_distance);
      EXPECT_NEAR(rack.normal_pressure_angle, rack_p.normal_pressure_angle, scale);
      EXPECT_NEAR(rack.shaft_angle, 0.0, scale);
      for (int k : {0, 1}) {
        EXPECT_NEAR(rack.sides[k].pitch_radius, rack_p.sides[k].pitch_radius,
                    scale * p->center_distance);
        EXPECT_NEAR(rack.sides[k].transverse_angle, rack_p.sides[k].transverse_angle, scale);
        EXPECT_NEAR(rack.sides[k].tooth_thickness_normal, rack_p.sides[k].tooth_thickness_normal,
                    scale * p->center_distance);
      }
      // σ dj_bn/da at the backlash-free position is 2 sin α_n, on crossed axes as well as on
      // parallel ones.
      MeshInput<double> in = p->input;
      in.center_distance += p->side() * 1e-4;
      const double slope = mesh_of(in).backlash.normal_base / 1e-4;
      EXPECT_NEAR(slope, 2 * rack.angles.sin_alpha, scale + 1e-3 * slope);
      const double difference = std::abs(a - p->center_distance);
      EXPECT_LE(difference, last + 1e-9 * a);
      last = difference;
    }
    if (HasFailure()) {
      ADD_FAILURE() << describe(specs);
      break;
    }
  }
  EXPECT_GT(held, 100);
}

}  // namespace
}  // namespace gearwright::property
