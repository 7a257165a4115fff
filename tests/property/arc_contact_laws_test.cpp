// Tests laws of the contact of circular arcs over seeded pairs.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/property/contact_pairs.hpp"

namespace gearwright::property {
namespace {

// If the arc radii of both racks increase by e, the racks cut parallel flanks. The motion does not
// change, and the point of contact moves along the normal.
TEST(ArcContactLaws, parallel_flanks) {
  for (const double crossing : {0.0, 2e-4, -3e-4}) {
    tca::ArcPair wider = some_arcs(crossing, 0.02);
    const tca::Real e = 0.3L;
    wider.f.rho += e, wider.p.rho += e;
    const auto a = over_a_pitch(contact_set(some_arcs(crossing, 0.02)).pair(), 16);
    const auto b = over_a_pitch(contact_set(wider).pair(), 16);
    int inside = 0;
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
      const ContactPoint &p = a.positions[i], &q = b.positions[i];
      if (p.kind != TouchKind::interior || q.kind != TouchKind::interior) continue;
      if (p.pair != q.pair) continue;
      ++inside;
      EXPECT_NEAR(p.te.rad(), q.te.rad(), 1e-14);
      EXPECT_LT((q.point - p.point - 0.3 * p.normal).norm(), 1e-9);
    }
    EXPECT_GE(inside, 8);
  }
}

// If both arcs are moved along their pitch lines by d, the motion is the same but occurs d/(r sin
// λ) earlier.
TEST(ArcContactLaws, racks_moved_along_the_pitch_line) {
  const double crossing = 2e-4;
  tca::ArcPair moved = some_arcs(crossing);
  const double d = 0.4;
  moved.f.a += d, moved.p.a += d;
  const double by = d / static_cast<double>(moved.pitch_radius_1 * std::sin(moved.lead_angle_f));
  std::vector<Angle> rotations, earlier;
  for (int i = -4; i < 4; ++i) {
    rotations.push_back(Angle::radians(0.05 * i));
    earlier.push_back(Angle::radians(0.05 * i - by));
  }
  const auto a = at_rotations(contact_set(moved).pair(), rotations);
  const auto b = at_rotations(contact_set(some_arcs(crossing)).pair(), earlier);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    EXPECT_NEAR(a.positions[i].te.rad(), b.positions[i].te.rad(), 1e-14);
    EXPECT_EQ(a.positions[i].kind, b.positions[i].kind);
  }
}

// If only the centre distance is wrong, the transmission error is constant, and the point of
// contact moves along a straight line parallel to the axes. Its position follows exactly from one
// equation of dC.
TEST(ArcContactLaws, centre_distance_alone) {
  for (const double d_center : {-0.05, 0.01, 0.08}) {
    const tca::ArcPair pair = some_arcs(0.0, d_center);
    const auto r = over_a_pitch(contact_set(pair).pair(), 32);
    const ContactPoint& first = r.positions[0];
    for (const ContactPoint& p : r.positions) {
      ASSERT_EQ(p.kind, TouchKind::interior);
      EXPECT_NEAR(p.te.rad(), first.te.rad(), 1e-14);
      EXPECT_LT((p.point - first.point).head<2>().norm(), 1e-10);
    }
    EXPECT_LT(r.peak_to_peak.rad(), 2e-14);
    EXPECT_NEAR(r.mean_slope, 0.0, 1e-13);
    const double tau = first.rack_angle->rad(),
                 c_0 = static_cast<double>(pair.mounting.center_distance);
    const double w = static_cast<double>(pair.f.rho - pair.p.rho) * std::sin(tau) -
                     static_cast<double>(pair.f.b - pair.p.b);
    const double across = w / std::tan(tau) * static_cast<double>(std::sin(pair.lead_angle_f));
    EXPECT_NEAR(std::hypot(c_0 + w, across), c_0 + d_center, 1e-11);
  }
}

}  // namespace
}  // namespace gearwright::property
