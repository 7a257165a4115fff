// Compares the trimming of internal gears in radial infeed with a cutter that rolls at many centre
// distances up to the generating distance.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright {
namespace {

struct Shaped {
  Gear cutter, ring;
};

Shaped shaped_ring(int z_0, int z, double tip_diameter, double rounding = 0.0) {
  CylindricalSpec c = testing::plain_spec({.teeth = z_0, .module = 2.0, .face_width = 20.0});
  c.straight_rack().dedendum = 1.4;
  c.straight_rack().addendum = 1.25;
  c.straight_rack().tip_fillet_radius = rounding;
  const Gear cutter = testing::made(c);
  const double e = testing::taken(generating_distance(cutter, -z, 0.0));
  return {cutter, testing::taken(make_pinion_cut_gear(cutter, {-z, e, 20.0, tip_diameter}))};
}

// The arc, mm, that the rolling cutter removes from the ring beside the given point of its outline.
// Rotations of one tooth of the cutter from −0.2 to 1.4 rad and centre distances e from 0 to E are
// tried, each in `steps` steps. A point is removed if it lies inside the polygon of this tooth.
double swept(const Shaped& s, const Vec2& tip, int steps) {
  const double q = s.cutter.spec.teeth / -static_cast<double>(s.ring.spec.teeth);
  std::vector<Vec2> side;
  for (const Arc& arc : s.cutter.tooth->outline.arcs) {
    if (arc.name == ArcName::tip_land || arc.name == ArcName::root_land) continue;
    for (const Vec2& p : sample(arc, 200)) side.push_back(p);
  }
  const auto half_angle = [&](double rho) {
    std::size_t i = 1;
    while (i + 1 < side.size() && side[i].norm() < rho) ++i;
    const double a = side[i - 1].norm(), b = side[i].norm();
    const double u = b > a ? (rho - a) / (b - a) : 0.0;
    const Vec2 p = (1 - u) * side[i - 1] + u * side[i];
    return std::atan2(p.y(), p.x());
  };
  const double r = tip.norm(), E = s.ring.cut_by->distance;
  const double space = kPi / -s.ring.spec.teeth - std::atan2(tip.y(), tip.x());
  constexpr double kStep = 1e-5;  // rad
  double most = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double turn = -0.2 + 1.6 * i / steps;
    for (int k = 0; k <= steps; ++k) {
      const double e = E * k / steps;
      const auto removed = [&](double beyond) {
        const double a = space + beyond + q * turn;
        const Vec2 p(r * std::cos(a) - e, r * std::sin(a));
        const double rho = p.norm();
        if (rho > side.back().norm() || rho < side.front().norm()) return false;
        return std::abs(std::atan2(p.y(), p.x()) - turn) < half_angle(rho);
      };
      while (removed(most + kStep)) most += kStep;
    }
  }
  return most * r;
}

// With steps of E/400 and 0.004 rad, the sweep finds the greatest arc with an error of less than
// 0.01 mm. A cutter that removes no material at the tip of the flank also removes none below the
// tip.
TEST(Infeed, trims_as_much_as_a_cutter_that_rolls_at_all_distances) {
  struct Case {
    int z_0, z;
    double tip, rounding;
    bool trims;
  };
  for (const Case& c : {Case{50, 60, 116, 0.0, true}, Case{50, 60, 116, 0.2, true},
                        Case{24, 30, 57, 0.0, true}, Case{40, 50, 97, 0.3, true},
                        Case{25, 54, 104.2, 0.0, false}, Case{50, 70, 136, 0.2, false}}) {
    SCOPED_TRACE(::testing::Message() << c.z_0 << "/" << c.z << " " << c.rounding);
    const Shaped s = shaped_ring(c.z_0, c.z, c.tip, c.rounding);
    const auto cut = infeed_cut(*s.cutter.tooth, *s.ring.tooth, s.ring.cut_by->distance);
    const Arc& flank = *s.ring.tooth->outline.find(ArcName::flank);
    const double by_sweep = swept(s, flank.end_point, 400);
    EXPECT_EQ(by_sweep > 0.0, c.trims);
    EXPECT_EQ(cut && cut->arc > 0.0, c.trims);
    EXPECT_EQ(warns(s.ring, WarningCode::trimming), c.trims);
    if (c.trims) {
      EXPECT_NEAR(cut->arc, by_sweep, 0.01);
      EXPECT_GE(cut->arc, by_sweep);
    } else {
      for (const double u : {0.2, 0.5, 0.8, 0.95}) EXPECT_LT(swept(s, flank.point(u), 200), 0.01);
    }
  }
}

TEST(Infeed, names_the_largest_similar_cutter_that_does_not_trim) {
  const Shaped s = shaped_ring(50, 60, 116);
  std::string message;
  for (const Warning& w : s.ring.warnings)
    if (w.code == WarningCode::trimming) message = w.message;
  EXPECT_NE(message.find("Give a similar cutter with 42 teeth, which removes nothing"),
            std::string::npos)
      << message;
  EXPECT_FALSE(warns(shaped_ring(42, 60, 116).ring, WarningCode::trimming));
  for (int z_0 = 43; z_0 <= 50; ++z_0)
    EXPECT_TRUE(warns(shaped_ring(z_0, 60, 116).ring, WarningCode::trimming)) << z_0;
}

}  // namespace
}  // namespace gearwright
