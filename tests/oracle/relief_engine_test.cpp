// Compares linear and parabolic tip relief with a flank of sampled points. Every point of an
// involute is moved along its true normal by the removal of the relief. For each point, the
// rotation of gear 2 is computed at which the mating involute passes it. The test uses no field and
// no derivative, and it does not replace a removal by a rotation.
//
//   spur pair, gear 1 drives clockwise        a  centre distance      r_b  base radius
//   L  roll length of the sample              C  removed, mm: C_a q or C_a q², q from the start on
//
// The engine turns the flank by C divided by its moment arm [T8.7]. For an involute, this is exact.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright::oracle {
namespace {

using C = std::complex<double>;

double involute_of(double alpha) { return std::tan(alpha) - alpha; }

// Half of the angle of a tooth on the base circle, for x = 0 without allowance.
double base_half_angle(int teeth) {
  const double alpha = std::numbers::pi / 9;
  return std::numbers::pi / (2 * teeth) + involute_of(alpha);
}

struct Sampled {
  double te;        // rad
  double diameter;  // diameter of the sample that touches
};

struct SampledPair {
  int z1, z2;
  double m, a, tip_1, tip_2, form_1, form_2;  // radii
  Relief relief;
  int samples = 20001;

  // Greatest φ2 − φ1 z1/z2 over the samples on all teeth that may touch.
  Sampled touch(double phi1) const {
    const double alpha = std::numbers::pi / 9;
    const double rb1 = z1 * m / 2 * std::cos(alpha);
    const double rb2 = z2 * m / 2 * std::cos(alpha);
    const auto roll = [&](double r) { return std::sqrt(r * r - rb1 * rb1); };
    const double start = roll(*relief.reach / 2);
    const double end = roll(tip_1);
    Sampled best{-1e9, 0};
    for (int k = -2; k <= 2; ++k) {
      // The right flank (y < 0) of the tooth k pitches behind, turned clockwise by φ1.
      const double turn = -phi1 + 2 * std::numbers::pi * k / z1;
      for (int i = 0; i <= samples; ++i) {
        // There is one more sample on the ridge itself.
        const double length =
            i == samples ? start : roll(form_1) + (end - roll(form_1)) * i / (samples - 1);
        const double q = std::max(0.0, (length - start) / (end - start));
        const double taken = relief.amount * (relief.shape == ReliefShape::linear ? q : q * q);
        // The sample is the end of a taut string. The direction of the string is the normal of the
        // flank, and the material lies on the side from which the string comes. C is evaluated on
        // the finished flank, where the string is shorter by C than on the original flank.
        const C string = C(0, 1) * std::polar(1.0, base_half_angle(z1) - (length + taken) / rb1);
        C w = -C(0, 1) * string * rb1 + string * length;
        w = std::conj(w) * std::polar(1.0, turn);  // the right flank, turned
        const C seen = w - a;
        const double rho = std::abs(seen);
        if (rho > tip_2 || rho < form_2) continue;
        const double xi2 = std::sqrt(rho * rho / (rb2 * rb2) - 1);
        const double flank = base_half_angle(z2) - (xi2 - std::atan(xi2));
        // Space 0 is at the mesh. The tooth ahead of the space is half a pitch further, and its
        // flank lies before it.
        const double rest =
            std::numbers::pi + (std::numbers::pi - 2 * std::numbers::pi * k) / z2 - flank;
        const double phi2 = std::arg(seen * std::polar(1.0, -rest - phi1 * z1 / z2));
        if (phi2 > best.te) best = {phi2, 2 * std::abs(w)};
      }
    }
    return best;
  }
};

TEST(ReliefEngine, sampled_flanks) {
  int ridges = 0;
  int relieved = 0;
  for (const ReliefShape shape : {ReliefShape::linear, ReliefShape::parabolic}) {
    testing::SamplePair p = testing::involutes(20, 41, 0);
    const Gear& g1 = p.gears[0];
    const Gear& g2 = p.gears[1];
    // The relief is so long that between the unrelieved parts of successive pairs, only relieved
    // parts carry the load.
    FlankModifications m;
    m.tip_relief = {0.05, 2 * (0.8 * *g1.root_form_radius() + 0.2 * g1.tip_form_radius()), shape};
    p.modify(1, m);
    const SampledPair sampled{20,
                              41,
                              2.0,
                              p.place.center_distance,
                              g1.tip_form_radius(),
                              g2.tip_form_radius(),
                              *g1.root_form_radius(),
                              *g2.root_form_radius(),
                              m.tip_relief};
    const ContactResult r = analyse_contact(p.pair(), {48, 1, 0.006});
    for (const ContactPoint& c : r.positions) {
      const Sampled s = sampled.touch(c.rotation1.rad());
      SCOPED_TRACE(::testing::Message() << (shape == ReliefShape::linear ? "linear " : "parabolic ")
                                        << c.rotation1.deg() << " " << to_string(c.kind));
      // A peak may lie between two samples, which are 0.3 µm apart on flanks with radii of some mm.
      // The resulting error is less than 1e-8 mm. The tip of gear 2 slopes away from its own flank.
      EXPECT_LT(s.te, c.te.rad() + 1e-12);
      EXPECT_GT(s.te, c.te.rad() - (c.kind == TouchKind::tip2 ? 3e-7 : 1e-9));
      const double start = *m.tip_relief.reach;
      if (c.kind == TouchKind::ridge) {
        ++ridges;
        EXPECT_NEAR(s.diameter, start, 2e-3);
      }
      if (c.diameter[0] > start + 0.01 && c.te.arcsec() < -0.01) {
        ++relieved;
        EXPECT_NEAR(c.diameter[0], s.diameter, 0.02);
      }
    }
  }
  EXPECT_GT(ridges, 1);
  EXPECT_GT(relieved, 3);
}

}  // namespace
}  // namespace gearwright::oracle
