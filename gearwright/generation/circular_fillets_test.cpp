#include "gearwright/generation/circular_fillets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

struct Tooth {
  int teeth;
  Involute flank;
};

// 1, 2, 5 and 8 teeth, and a tooth so thick that the space closes above the base circle.
std::vector<Tooth> teeth() {
  return {{1, {1.472, 2.43}},
          {2, {1.863, 1.19}},
          {5, {4.70, 0.41}},
          {8, {11.276, 0.2376}},
          {2, {3.0, 1.9}}};
}

std::vector<double> rolls(const Tooth& tooth) {
  const double point = std::tan(inverse_involute(tooth.flank.base_half_angle()));
  std::vector<double> all;
  for (int i = 0; i <= 12; ++i) all.push_back(point * i / 12.5);
  return all;
}

Vec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

// The step of the central difference gives an accuracy of 1e-9 for values of a few millimetres.
template <class F>
double slope(const F& f, double x) {
  constexpr double h = 1e-5;
  return (f(x + h) - f(x - h)) / (2 * h);
}

// [T6.2]: the circle about D∠π/z passes through C, where it is tangent to the flank. It meets the
// middle of the space at `end`. The arc from `end` to C has the angle σ.
TEST(RootFillet, touches_the_flank_and_is_centred_in_the_space) {
  int arcs = 0;
  for (const Tooth& tooth : teeth()) {
    for (const double xi : rolls(tooth)) {
      const auto arc = root_fillet_at(tooth.flank, tooth.teeth, xi);
      if (!arc) continue;
      ++arcs;
      const double gamma = kPi / tooth.teeth;
      const OffsetCircle circle(arc->distance, gamma, arc->radius);
      const double at_c = gamma - kPi + arc->span.rad();
      const double scale = 1e-14 * (arc->distance + arc->radius);
      EXPECT_LE((circle.point(at_c) - tooth.flank.point(xi)).norm(), 4 * scale) << xi;
      if (xi > 0.0) {
        const double turn = circle.at(at_c).tangent_angle - tooth.flank.at(xi).tangent_angle;
        EXPECT_NEAR(std::remainder(turn, 2 * kPi), 0.0, 1e-14) << xi;
      }
      const Vec2 end = circle.point(gamma - kPi);
      EXPECT_LE((end - arc->end * unit(gamma)).norm(), 4 * scale) << xi;
      EXPECT_GT(arc->span.rad(), 0.0);
      EXPECT_LT(arc->span.rad(), kPi);
    }
  }
  EXPECT_GT(arcs, 30);
}

// dr_r/dξ = r_b tan² u and d(end)/dξ = r_b (1 − 1/(1 + sin u)), where u is the angle from the base
// tangent point to the middle of the space.
TEST(RootFillet, laws) {
  int compared = 0;
  for (const Tooth& tooth : teeth()) {
    const double r_b = tooth.flank.base_radius();
    for (const double xi : rolls(tooth)) {
      const double u = xi + kPi / tooth.teeth - tooth.flank.base_half_angle();
      const auto before =
          xi > 1e-5 ? root_fillet_at(tooth.flank, tooth.teeth, xi - 1e-5) : std::nullopt;
      const auto after = root_fillet_at(tooth.flank, tooth.teeth, xi + 1e-5);
      if (!before || !after || u > 1.4) continue;
      const auto radius = [&](double x) {
        return root_fillet_at(tooth.flank, tooth.teeth, x)->radius;
      };
      const auto end = [&](double x) { return root_fillet_at(tooth.flank, tooth.teeth, x)->end; };
      const double tan_u = std::tan(u);
      EXPECT_NEAR(slope(radius, xi), r_b * tan_u * tan_u, 1e-7 * r_b * (1 + tan_u * tan_u));
      EXPECT_NEAR(slope(end, xi), r_b * (1.0 - 1.0 / (1.0 + std::sin(u))), 1e-7 * r_b);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

// The span is the angle between the tangent of the flank and the line perpendicular to the middle
// of the space.
TEST(RootFillet, span_is_the_turn_of_the_tangent) {
  int compared = 0;
  for (const Tooth& tooth : teeth()) {
    for (const double xi : rolls(tooth)) {
      const auto arc = root_fillet_at(tooth.flank, tooth.teeth, xi);
      if (!arc || xi == 0.0) continue;
      const double root_tangent = kPi / tooth.teeth - kHalfPi;
      EXPECT_NEAR(tooth.flank.at(xi).tangent_angle - root_tangent, arc->span.rad(), 1e-13);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(RootFillet, is_nothing_where_no_circle_fits) {
  // If u ≥ π/2, the normal points away from the middle of the space.
  const Involute thin(2.0, 0.1);
  EXPECT_FALSE(root_fillet_at(thin, 2, 0.2));
  EXPECT_TRUE(root_fillet_at(thin, 8, 0.2));
  // If the space is closed, no fillet fits below the radius where the flanks meet, but one fits
  // just above it.
  const Involute thick(3.0, 1.9);
  const double closed = std::tan(inverse_involute(1.9 - kHalfPi));
  EXPECT_FALSE(root_fillet_at(thick, 2, closed - 1e-9));
  ASSERT_TRUE(root_fillet_at(thick, 2, closed + 1e-9));
  EXPECT_LT(root_fillet_at(thick, 2, closed + 1e-9)->radius, 1e-8);
}

// [T6.3]: the circle about D on the x axis passes through J with the tangent of the flank.
TEST(TipFillet, touches_the_flank_and_is_centred_on_the_tooth) {
  int arcs = 0;
  for (const Tooth& tooth : teeth()) {
    for (const double xi : rolls(tooth)) {
      const auto arc = tip_fillet_at(tooth.flank, xi);
      if (!arc) continue;
      ++arcs;
      const OffsetCircle circle(arc->distance, 0.0, arc->radius);
      const double scale = 1e-14 * (arc->distance + arc->radius);
      EXPECT_LE((circle.point(arc->span.rad()) - tooth.flank.point(xi)).norm(), 4 * scale) << xi;
      if (xi > 0.0) {  // run from the flank to the centre line, against increasing t
        const double turn =
            circle.at(arc->span.rad()).tangent_angle + kPi - tooth.flank.at(xi).tangent_angle;
        EXPECT_NEAR(std::remainder(turn, 2 * kPi), 0.0, 1e-14) << xi;
      }
      EXPECT_LE((circle.point(0.0) - Vec2(arc->end, 0.0)).norm(), scale) << xi;
    }
  }
  EXPECT_GT(arcs, 40);
}

// [T6.4] dr_t/dξ = −r_b tan² δ;  [T6.6] d(end)/dξ = −r_b tan δ (1 + sin δ)/cos δ.
TEST(TipFillet, laws) {
  int places = 0;
  for (const Tooth& tooth : teeth()) {
    const double r_b = tooth.flank.base_radius();
    for (const double xi : rolls(tooth)) {
      const double delta = tooth.flank.base_half_angle() - xi;
      if (xi < 1e-4 || std::abs(delta) > 1.4 || !tip_fillet_at(tooth.flank, xi + 1e-5)) continue;
      ++places;
      const double t = std::tan(delta), c = std::cos(delta);
      const auto radius = [&](double x) { return tip_fillet_at(tooth.flank, x)->radius; };
      const auto end = [&](double x) { return tip_fillet_at(tooth.flank, x)->end; };
      const double rounding = 1e-7 * r_b * (1 + t * t) * (1 + t * t);
      EXPECT_NEAR(slope(radius, xi), -r_b * t * t, rounding) << xi;
      EXPECT_NEAR(slope(end, xi), -r_b * t * (1 + std::sin(delta)) / c, rounding) << xi;
    }
  }
  EXPECT_GT(places, 30);
}

// The end moves outward as ξ grows beyond ψ_b. If the radius vanishes, the end is the point of the
// tooth.
TEST(TipFillet, ends_in_the_point_of_the_tooth) {
  for (const Tooth& tooth : teeth()) {
    const double point = std::tan(inverse_involute(tooth.flank.base_half_angle()));
    const auto arc = tip_fillet_at(tooth.flank, point * (1 - 1e-9));
    ASSERT_TRUE(arc);
    EXPECT_LT(arc->radius, 1e-7);
    EXPECT_NEAR(arc->end, tooth.flank.base_radius() * std::hypot(1.0, point), 1e-6);
    EXPECT_FALSE(tip_fillet_at(tooth.flank, point * (1 + 1e-9)));
  }
}

TEST(TipFillet, roll_of_a_radius_is_its_inverse) {
  for (const Tooth& tooth : teeth()) {
    for (const double xi : rolls(tooth)) {
      const auto arc = tip_fillet_at(tooth.flank, xi);
      if (!arc || xi == 0.0) continue;
      const auto found = roll_of_tip_fillet(tooth.flank, arc->radius);
      ASSERT_TRUE(found) << xi;
      // Near δ = 0 the radius is stationary, so ξ is accurate only to the root of the rounding
      // error.
      const double delta = tooth.flank.base_half_angle() - xi;
      const double gain = std::max(1e-10, std::pow(std::tan(delta), 2));
      EXPECT_NEAR(*found, xi, 1e-14 * (1 + xi) / gain + 1e-14) << xi;
      EXPECT_NEAR(tip_fillet_at(tooth.flank, *found)->radius, arc->radius,
                  1e-14 * (1 + arc->distance));
    }
  }
}

// r_t decreases with ξ, so r_t is greatest at ξ = 0.
TEST(TipFillet, a_radius_too_large_has_no_place) {
  const Involute flank(11.276, 0.2376);
  const double largest = tip_fillet_at(flank, 0.0)->radius;
  EXPECT_FALSE(roll_of_tip_fillet(flank, largest * (1 + 1e-12)));
  const auto found = roll_of_tip_fillet(flank, largest * (1 - 1e-12));
  ASSERT_TRUE(found);
  EXPECT_LT(*found, 1e-9);
  // A tooth with ψ_b > π/2 has a tip fillet for every radius.
  EXPECT_TRUE(roll_of_tip_fillet(Involute(1.472, 2.43), 1e6));
}

}  // namespace
}  // namespace gearwright
