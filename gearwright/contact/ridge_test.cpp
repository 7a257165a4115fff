// Contact on the ridge of a linear relief: when a touch is on a ridge, and how the gap opens around
// it. The gap is compared with the field itself, sampled on both sides of the touch.
#include "gearwright/contact/contact_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using testing::SamplePair;

enum class Where { tip1, root1, tip2, end1 };

// A pair with 20 and 41 teeth. A relief of 30 µm begins in the middle of the flank, so that the
// ridge is in contact. A little crowning makes the flanks touch at points.
SamplePair relieved(Where where, ReliefShape shape, bool gear2_drives = false) {
  SamplePair p = testing::involutes(20, 41, 12);
  FlankModifications m;
  m.lead_crowning = 0.01;
  const int gear = where == Where::tip2 ? 2 : 1;
  const Gear& g = p.gears[gear - 1];
  const double lo = 2 * *g.root_form_radius();
  const double hi = 2 * g.tip_form_radius();
  const auto at = [&](double t) { return lo + t * (hi - lo); };
  if (where == Where::root1) {
    m.root_relief = {0.03, at(0.65), shape};
  } else if (where == Where::end1) {
    m.end_relief = {0.03, 8.0, shape};
  } else {
    m.tip_relief = {0.03, at(0.4), shape};
  }
  p.modify(gear, m);
  p.place.gear2_drives = gear2_drives;
  if (where == Where::end1) p.place.errors.crossing = Angle::degrees(gear2_drives ? -0.08 : 0.08);
  return p;
}

int ridges(const ContactResult& r) {
  int n = 0;
  for (const ContactPoint& p : r.positions) {
    EXPECT_EQ(p.ridge.has_value(), p.kind == TouchKind::ridge);
    n += p.kind == TouchKind::ridge;
  }
  return n;
}

TEST(Ridge, begins_where_the_relief_does) {
  for (const Where where : {Where::tip1, Where::root1, Where::tip2, Where::end1}) {
    for (const bool gear2_drives : {false, true}) {
      SCOPED_TRACE(static_cast<int>(where) * 10 + gear2_drives);
      const SamplePair p = relieved(where, ReliefShape::linear, gear2_drives);
      const ContactPair pair = p.pair();
      const ContactResult r = analyse_contact(pair, {96, 1, 0.006});
      EXPECT_GT(ridges(r), 2);
      const int gear = where == Where::tip2 ? 2 : 1;
      const RemovalField& field = *p.removal[gear - 1];
      for (const ContactPoint& c : r.positions) {
        if (c.kind != TouchKind::ridge) continue;
        EXPECT_TRUE(is_sharp(c.kind) && !is_edge(c.kind));
        EXPECT_EQ(c.ridge->gear, gear);
        EXPECT_FALSE(c.gap_curvature || c.ellipse);
        const std::size_t g = gear - 1;
        if (where == Where::end1) {
          EXPECT_NEAR(std::abs(c.height[g]), 2.0, 1e-9);
        } else {
          EXPECT_NEAR(std::log(c.diameter[g] / 2), field.kinks_u()[0], 1e-9);
        }
        EXPECT_GE(c.ridge->along, 0.0);
        // The sum of both slopes is the slope of the relief.
        const double bend = c.ridge->side[0].slope + c.ridge->side[1].slope;
        EXPECT_GT(bend, 0.0);
        for (const auto& side : c.ridge->side) {
          EXPECT_GE(side.slope, 0.0);
          EXPECT_LE(side.curvature[0], side.curvature[1]);
        }
      }
    }
  }
}

// The sum of both slopes is the angle of the ridge, 1 in 267 for an end relief of 30 µm over 8 mm.
TEST(Ridge, slopes_are_the_angle_of_the_relief) {
  const SamplePair p = relieved(Where::end1, ReliefShape::linear);
  const ContactPair pair = p.pair();
  int compared = 0;
  for (const ContactPoint& c : analyse_contact(pair, {32, 1, 0.006}).positions) {
    if (c.kind != TouchKind::ridge) continue;
    EXPECT_NEAR(c.ridge->side[0].slope + c.ridge->side[1].slope, 0.03 / 8, 2e-2 * 0.03 / 8);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST(Ridge, a_parabolic_relief_has_none) {
  for (const Where where : {Where::tip1, Where::root1, Where::tip2, Where::end1})
    EXPECT_EQ(
        ridges(analyse_contact(relieved(where, ReliefShape::parabolic).pair(), {96, 1, 0.006})), 0);
}

TEST(Ridge, a_relief_of_nothing_has_none) {
  SamplePair p = testing::involutes(20, 41, 12);
  FlankModifications m;
  m.lead_crowning = 0.01;
  m.tip_relief = {0.0, p.gears[0].reference_diameter, ReliefShape::linear};
  p.modify(1, m);
  const ContactPair pair = p.pair();
  EXPECT_EQ(pair.patches(1).size(), 2u);
  EXPECT_EQ(ridges(analyse_contact(pair, {96, 1, 0.006})), 0);
}

// The gap around the touch is computed only from the fields of both sides. It is a parabola along
// the ridge and linear across it. The second-order terms on each side follow from the relative
// curvature K.
TEST(Ridge, curvatures_are_those_of_the_sampled_gap) {
  int seen = 0;
  for (const Where where : {Where::tip1, Where::tip2, Where::root1, Where::end1}) {
    const SamplePair p = relieved(where, ReliefShape::linear);
    const ContactPair pair = p.pair();
    Transmission transmission(pair);
    int of_this = 0;
    for (const PairTouch& t : transmission.over_a_pitch(-0.5 * pair.pitch(), 96)) {
      const ContactPoint c = describe(transmission, t, Angle::radians(t.phi), 0.006);
      if (c.kind != TouchKind::ridge || ++of_this % 4 != 1) continue;
      ++seen;
      SCOPED_TRACE(::testing::Message() << static_cast<int>(where) << " at " << t.phi);
      const GapJet j = transmission.jet_at(t, t.touch.s, t.touch.z);
      const auto place = [&](double s, double z) {
        const GapJet at = transmission.jet_at(t, s, z);
        return Vec3(at.w1.real(), at.w1.imag(), z);
      };
      const Vec3 here = place(t.touch.s, t.touch.z);
      const auto gap = [&](double s, double z) {
        return (t.te() - transmission.jet_at(t, s, z).t.v) * GapField::arm(j);
      };
      // Two points on the ridge. Along a ridge of gear 1, s is constant, or z if the relief is an
      // end relief. Along a ridge of gear 2, u is constant.
      const double h = 0.05;  // mm
      double sum = 0.0;
      for (const double away : {-h, h}) {
        double s = t.touch.s;
        double z = t.touch.z;
        if (where == Where::end1) {
          s += away / std::abs(j.w1_s);
        } else {
          z += away;
        }
        if (where == Where::tip2) {
          for (int i = 0; i < 20; ++i) {
            const GapJet at = transmission.jet_at(t, s, z);
            s -= (at.u.v - j.u.v) / at.u.s;
          }
        }
        sum += gap(s, z) / (place(s, z) - here).squaredNorm();
      }
      EXPECT_NEAR(c.ridge->along, sum, 1e-3 * sum + 1e-7);
      // On the side of the touch, the trace of K is computed from the gaps at four points around
      // the touch, at equal distances in the tangent plane.
      const Vec3 r_s(j.w1_s.real(), j.w1_s.imag(), 0);
      const Vec3 r_z(j.w1_z.real(), j.w1_z.imag(), 1);
      const Vec3 normal = r_s.cross(r_z).normalized();
      const Vec3 e[] = {r_z.normalized(), normal.cross(r_z.normalized())};
      double trace = 0.0;
      Vec2 slope(0, 0);
      constexpr double kStep = 0.002;  // mm
      for (int k : {0, 1}) {
        double at[2];
        for (int side : {0, 1}) {
          const Vec3 target = (side ? kStep : -kStep) * e[k];
          double s = t.touch.s;
          double z = t.touch.z;
          for (int i = 0; i < 20; ++i) {  // finds the point whose projection is `target`
            const GapJet q = transmission.jet_at(t, s, z);
            const Vec3 off = Vec3(q.w1.real(), q.w1.imag(), z) - here - target;
            Eigen::Matrix2d jac;
            const Vec3 q_s(q.w1_s.real(), q.w1_s.imag(), 0);
            const Vec3 q_z(q.w1_z.real(), q.w1_z.imag(), 1);
            jac << q_s.dot(e[0]), q_z.dot(e[0]), q_s.dot(e[1]), q_z.dot(e[1]);
            const Eigen::Vector2d d = jac.inverse() * Eigen::Vector2d(off.dot(e[0]), off.dot(e[1]));
            s -= d[0];
            z -= d[1];
          }
          at[side] = gap(s, z);
        }
        trace += (at[0] + at[1]) / (kStep * kStep);
        slope[k] = (at[1] - at[0]) / (2 * kStep);
      }
      const auto matches = [&](const ContactRidge::Side& side) {
        const double k = side.curvature[0] + side.curvature[1];
        return std::abs(k - trace) < 2e-3 * std::abs(trace) &&
               std::abs(side.slope - slope.norm()) < 1e-3 * slope.norm() + 1e-9;
      };
      EXPECT_TRUE(matches(c.ridge->side[0]) || matches(c.ridge->side[1]))
          << trace << " " << c.ridge->side[0].curvature[0] + c.ridge->side[0].curvature[1] << " "
          << c.ridge->side[1].curvature[0] + c.ridge->side[1].curvature[1] << " slopes "
          << slope.norm() << " " << c.ridge->side[0].slope << " " << c.ridge->side[1].slope;
    }
  }
  EXPECT_GT(seen, 3);
}

}  // namespace
}  // namespace gearwright
