// Laws: (1) for a half at height z, an in-plane deviation δ has exactly the effect of a change of
// the centre distance by z sin δ and of the axial position by z (1 − cos δ)   (2) an out-of-plane
// deviation turns the centre line of a half and does not change the span   (3) derivatives are the
// limits of differences   (4) a stagger multiplies harmonic k by |cos πks|   (5) an axial
// displacement of a floating gear does not change TE.   Oracle for (2): the same axis, seen from
// the turned centre line.
#include "gearwright/contact/halves.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/contact/continuous.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/scatter/testing/drawn_pair.hpp"

namespace gearwright {
namespace {

using testing::SamplePair;

constexpr std::array kWheelsOfHalves{43, -61};  // the second is an internal gear

SamplePair crowned_half(int z2) {
  FlankModifications m;
  m.lead_crowning = 0.008;
  m.profile_crowning = 0.004;
  SamplePair p = testing::involutes(17, z2, 25);
  p.modify(1, m);
  return p;
}

// Returns the mirror image of half B of a pair. Its gears are those of half A, and its errors are
// mirrored.
SamplePair other_half(SamplePair p) {
  p.place.errors = mirrored(p.place.errors);
  return p;
}

struct Both {
  ContactPair a, b;
  HalvesMesh mesh;
  Both(const SamplePair& one, double stagger)
      : a(one.pair()), b(other_half(one).pair()), mesh{&one.gears[0], {&a, &b}, stagger} {}
};

TEST(Halves, AnInPlaneDeviationMovesAHalfByItsLever) {
  for (const int z2 : kWheelsOfHalves) {
    for (const bool gear2_drives : {false, true}) {
      SamplePair p = crowned_half(z2);
      p.place.gear2_drives = gear2_drives;
      const double d = 0.002;  // rad
      const double z = 25.0;
      p.place.middle = {z, z};
      p.place.errors.intersecting = Angle::radians(d);
      const auto there = transmission_error(p.pair(), 16);
      p.place.middle = {};
      // Axis 1 at height z is nearer to axis 2 by z sin δ and lower by z (1 − cos δ).
      p.place.errors.center_distance = -z * std::sin(d);
      p.place.errors.axial = -z * (1 - std::cos(d));
      const auto here = transmission_error(p.pair(), 16);
      for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(there[i], here[i], 1e-13) << i;
    }
  }
}

// Law (1) for gears that are seen from the other face, so that half A lies at z < 0.
TEST(Halves, HalfAMayLieOnEitherSide) {
  auto drawn = testing::crowned_helical_pair();
  const ContactSetup plain = drawn.setup();
  drawn.gap = 6.0;
  const ContactSetup setup = drawn.setup();
  const double d = 0.002;                                  // rad
  const double m = (6.0 + drawn.gears[0].face_width) / 2;  // the middle of a half
  for (const double side : {1.0, -1.0}) {
    const HalvesPair both =
        HalvesSetup(setup, 0.0, side).pair({.intersecting = Angle::radians(d)}, false);
    for (const std::size_t i : {0, 1}) {
      const double tilt = i == 0 ? d : -d;  // half B is a mirror image
      const auto there = transmission_error(*both.half[i], 16);
      const auto here =
          transmission_error(plain.pair({.center_distance = -side * m * std::sin(tilt),
                                         .intersecting = Angle::radians(tilt),
                                         .axial = -side * m * (1 - std::cos(tilt))},
                                        false),
                             16);
      for (std::size_t k = 0; k < here.size(); ++k) EXPECT_NEAR(there[k], here[k], 1e-13) << k;
    }
  }
}

TEST(Halves, AnOutOfPlaneDeviationTurnsTheCentreLine) {
  for (const int z2 : kWheelsOfHalves) {
    SamplePair p = crowned_half(z2);
    const double g = 0.002;  // rad
    const double z = 25.0;
    p.place.middle = {z, z};
    p.place.errors.crossing = Angle::radians(g);
    const auto there = continuous_span(p.pair(), 64);
    // The axis has the direction (0, sin γ, cos γ) and passes through (0, z sin γ, z cos γ). It is
    // seen from a frame that turns with the line of centres at height z.
    const double a = p.place.center_distance;
    const double y = z * std::sin(g);
    const double turn = std::atan2(y, a);
    const Vec3 axis(-std::sin(turn) * std::sin(g), std::cos(turn) * std::sin(g), std::cos(g));
    p.place.middle = {};
    p.place.errors.intersecting = Angle::radians(std::asin(axis.x()));
    p.place.errors.crossing = Angle::radians(std::atan2(axis.y(), axis.z()));
    p.place.errors.center_distance = std::hypot(a, y) - a;
    p.place.errors.axial = z * (std::cos(g) - 1);
    const auto here = continuous_span(p.pair(), 64);
    ASSERT_TRUE(there && here);
    EXPECT_NEAR(there->rad(), here->rad(), 1e-12) << z2;
    EXPECT_GT(there->arcsec(), 0.1);
  }
}

TEST(Halves, DerivativesAreThoseOfDifferences) {
  for (const int z2 : kWheelsOfHalves) {
    SamplePair p = crowned_half(z2);
    p.place.middle = {25.0, 24.0};
    p.place.errors = {.crossing = Angle::degrees(0.02), .intersecting = Angle::degrees(-0.03)};
    const auto te_at = [&](double step, ErrorKind kind) {
      SamplePair q = p;
      ContactErrors& e = q.place.errors;
      if (kind == ErrorKind::crossing) e.crossing += Angle::radians(step);
      if (kind == ErrorKind::intersecting) e.intersecting += Angle::radians(step);
      ContactRequest request;
      request.rotations = {Angle::radians(0.03)};
      request.influences = {{kind}};
      const auto [a, b] = analyse_contact(Both(q, 0.25).mesh, request).half;
      return std::array{a.positions[0].te.rad(), a.sensitivities[0][0].te, b.positions[0].te.rad(),
                        b.sensitivities[0][0].te};
    };
    for (const ErrorKind kind : {ErrorKind::crossing, ErrorKind::intersecting}) {
      constexpr double kStep = 1e-6;
      const auto lo = te_at(-kStep, kind);
      const auto at = te_at(0.0, kind);
      const auto hi = te_at(kStep, kind);
      EXPECT_NEAR(at[1], (hi[0] - lo[0]) / (2 * kStep), 1e-6 * std::abs(at[1]));
      EXPECT_NEAR(at[3], (hi[2] - lo[2]) / (2 * kStep), 1e-6 * std::abs(at[3]));
      EXPECT_GT(std::abs(at[1] - at[3]), 1e-3 * std::abs(at[1]));
    }
  }
}

TEST(Halves, AStaggerChangesHarmonics) {
  for (const int z2 : kWheelsOfHalves) {
    const SamplePair p = crowned_half(z2);
    for (const double s : {0.5, -0.25, 0.1}) {
      const Both both(p, s);
      const HalvesContact found = analyse_contact(both.mesh, {64});
      for (std::size_t k = 1; k <= 4; ++k) {
        const double share = std::abs(std::cos(std::numbers::pi * static_cast<double>(k) * s));
        EXPECT_NEAR(found.whole.harmonics[k - 1].rad(),
                    share * found.half[0].harmonics[k - 1].rad(),
                    1e-3 * found.half[0].harmonics[0].rad())
            << k << " " << s;
      }
    }
  }
}

TEST(Halves, AFloatingGearTakesUpAnAxialShift) {
  for (const int z2 : kWheelsOfHalves) {
    SamplePair p = crowned_half(z2);
    p.place.middle = {12.0, 12.0};
    const Both still(p, 0.0);
    const auto at_rest = analyse_contact(still.a, {32});
    p.place.errors.axial = 1e-4;
    const Both moved(p, 0.0);
    const HalvesContact found = analyse_contact(moved.mesh, {32});
    for (std::size_t i = 0; i < 32; ++i) {
      EXPECT_NEAR(found.whole.positions[i].te.rad(), at_rest.positions[i].te.rad(), 1e-11);
      EXPECT_NEAR(found.float_axial[i], -1e-4, 1e-8);
    }
  }
}

TEST(Halves, TheSpanIsThatOfManyPositions) {
  for (const int z2 : kWheelsOfHalves) {
    SamplePair p = crowned_half(z2);
    p.place.middle = {25.0, 25.0};
    p.place.errors = {.crossing = Angle::degrees(0.02), .intersecting = Angle::degrees(0.01)};
    for (const double s : {0.0, 0.3}) {
      const Both both(p, s);
      const auto span = continuous_span(both.mesh, 64);
      ASSERT_TRUE(span.has_value());
      constexpr int kMany = 2000;
      const double comb = analyse_contact(both.mesh, {kMany}).whole.peak_to_peak.arcsec();
      EXPECT_GE(span->arcsec(), comb - 1e-9);
      EXPECT_LE(span->arcsec(), comb + 2e-3 * comb);
      EXPECT_NEAR(span->arcsec(), continuous_span(both.mesh, 200)->arcsec(), 1e-7);
    }
  }
}

}  // namespace
}  // namespace gearwright
