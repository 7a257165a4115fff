// Tests of teeth with point contact under load. The Hertz ellipse is compared with a numerical
// integral. Load sharing is compared with another solver. Loaded pairs are compared with unloaded
// contact and with line contact, and their laws are verified.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/point_hertz.hpp"
#include "gearwright/load/point_sharing.hpp"
#include "gearwright/load/testing/drive.hpp"

namespace gearwright {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::SamplePair;

using testing::kE;

TEST(HertzPoint, ABallOnAPlane) {
  const double radius = 12.5;
  const double modulus = 113000.0;
  const HertzEllipse e = HertzPoint({1 / radius, 1 / radius}, modulus).under(350.0);
  const double a = std::cbrt(3 * 350.0 * radius / (4 * modulus));
  EXPECT_NEAR(e.semi_major, a, 1e-12 * a);
  EXPECT_NEAR(e.semi_minor, a, 1e-12 * a);
  EXPECT_NEAR(e.approach, a * a / radius, 1e-12 * e.approach);
  EXPECT_NEAR(e.pressure, 1.5 * 350.0 / (std::numbers::pi * a * a), 1e-9 * e.pressure);
}

// The displacement u(x, y) = 1/(πE*) ∫∫ p/r is integrated along rays from (x, y), where r cancels.
// Under the pressure of the ellipse, it must be δ − ½ (k1 x² + k2 y²).
double pressed(const HertzEllipse& e, double modulus, double x, double y) {
  constexpr int kRays = 4000;
  double sum = 0.0;
  for (int i = 0; i < kRays; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.5) / kRays;
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    // 1 − (x + r c)²/a² − (y + r s)²/b² = q0 − 2 q1 r − q2 r²
    const double a2 = e.semi_major * e.semi_major;
    const double b2 = e.semi_minor * e.semi_minor;
    const double q0 = 1 - x * x / a2 - y * y / b2;
    const double q1 = x * c / a2 + y * s / b2;
    const double q2 = c * c / a2 + s * s / b2;
    const double end = (-q1 + std::sqrt(q1 * q1 + q0 * q2)) / q2;
    // r = end (1 − v²) removes the square root at the rim.
    sum += boost::math::quadrature::gauss<double, 30>::integrate(
        [&](double v) {
          const double r = end * (1 - v * v);
          return std::sqrt(std::max(0.0, q0 - 2 * q1 * r - q2 * r * r)) * 2 * v * end;
        },
        0.0, 1.0);
  }
  return e.pressure * sum * (2 * std::numbers::pi / kRays) / (std::numbers::pi * modulus);
}

TEST(HertzPoint, TheEllipsePressesInWhatTheGapWants) {
  const double modulus = 110000.0;
  for (const auto& k : {std::array{0.02, 0.05}, std::array{0.001, 0.2}, std::array{1e-4, 0.1}}) {
    const HertzEllipse e = HertzPoint(k, modulus).under(800.0);
    const double area = std::numbers::pi * e.semi_major * e.semi_minor;
    EXPECT_NEAR(e.pressure * area * 2 / 3, 800.0, 1e-9 * 800.0);
    for (const auto& [fx, fy] :
         {std::pair(0.0, 0.0), std::pair(0.6, 0.0), std::pair(0.0, 0.7), std::pair(0.5, 0.5)}) {
      const double x = fx * e.semi_major;
      const double y = fy * e.semi_minor;
      const double want = e.approach - 0.5 * (k[0] * x * x + k[1] * y * y);
      EXPECT_NEAR(pressed(e, modulus, x, y), want, 2e-4 * e.approach) << k[0] << ' ' << fx << fy;
    }
  }
}

TEST(HertzPoint, GrowsAsTheory) {
  const HertzPoint point({3e-4, 0.11}, 113000.0);
  const HertzEllipse one = point.under(100.0);
  const HertzEllipse eight = point.under(800.0);
  EXPECT_NEAR(eight.semi_major, 2 * one.semi_major, 1e-12);
  EXPECT_NEAR(eight.pressure, 2 * one.pressure, 1e-9);
  EXPECT_NEAR(eight.approach, 4 * one.approach, 1e-15);
  EXPECT_NEAR(one.approach, point.softness() * std::pow(100.0, 2.0 / 3), 1e-15);
  EXPECT_EQ(point.under(0.0).pressure, 0.0);
}

// Solves the problem by another method: for each Θ the forces are computed one after another, and Θ
// is found by bisection.
VectorXd by_halving(const PointProblem& q, double* approach) {
  const Index n = q.gap.size();
  const auto forces = [&](double turn) {
    VectorXd f = VectorXd::Zero(n);
    for (int sweep = 0; sweep < 4000; ++sweep) {
      double change = 0.0;
      for (Index i = 0; i < n; ++i) {
        const double others = q.yield.row(i).dot(f) - q.yield(i, i) * f[i];
        const double room = turn * q.arm[i] - q.gap[i] - others;
        double lo = 0.0;
        double hi = room > 0.0 ? std::pow(room / q.softness[i], 1.5) : 0.0;
        for (int k = 0; k < 80; ++k) {
          const double f_mid = 0.5 * (lo + hi);
          const double used = q.softness[i] * std::pow(f_mid, 2.0 / 3) + q.yield(i, i) * f_mid;
          (used < room ? lo : hi) = f_mid;
        }
        change = std::max(change, std::abs(lo - f[i]));
        f[i] = lo;
      }
      if (change < 1e-13 * q.moment) break;
    }
    return f;
  };
  double lo = 0.0;
  double hi = 1.0;
  while (forces(hi).dot(q.arm) < q.moment) hi *= 2;
  for (int k = 0; k < 60; ++k) {
    const double mid = 0.5 * (lo + hi);
    (forces(mid).dot(q.arm) < q.moment ? lo : hi) = mid;
  }
  *approach = hi;
  return forces(hi);
}

PointProblem random_problem(std::mt19937& random, Index n) {
  std::uniform_real_distribution<double> u(0.0, 1.0);
  PointProblem q;
  const MatrixXd half = MatrixXd::NullaryExpr(n, n, [&] { return u(random) - 0.3; });
  q.yield = 2e-6 * (half * half.transpose());
  q.gap = VectorXd::NullaryExpr(n, [&] { return 0.02 * u(random); });
  q.gap[0] = 0.0;
  q.arm = VectorXd::NullaryExpr(n, [&] { return 20 + 20 * u(random); });
  q.softness = VectorXd::NullaryExpr(n, [&] { return 1e-5 + 5e-5 * u(random); });
  q.moment = std::pow(10.0, 2 + 4 * u(random));
  return q;
}

TEST(PointSharing, AgreesWithHalving) {
  std::mt19937 random(20);
  for (int i = 0; i < 60; ++i) {
    const PointProblem q = random_problem(random, 1 + i % 4);
    const PointSharing x = share_points(q);
    ASSERT_TRUE(x.found) << i;
    double approach = 0.0;
    const VectorXd want = by_halving(q, &approach);
    EXPECT_NEAR(x.approach, approach, 1e-8 * approach) << i;
    EXPECT_LT((x.force - want).cwiseAbs().maxCoeff(), 1e-6 * want.maxCoeff()) << i;
  }
}

TEST(PointSharing, HoldsItsConditions) {
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    const PointProblem q = random_problem(random, 1 + i % 6);
    const PointSharing x = share_points(q);
    ASSERT_TRUE(x.found) << i;
    EXPECT_NEAR(x.force.dot(q.arm), q.moment, 1e-12 * q.moment);
    const VectorXd bulk = q.yield * x.force;
    for (Index k = 0; k < q.gap.size(); ++k) {
      const double hertz = q.softness[k] * std::pow(x.force[k], 2.0 / 3);
      const double open = hertz + bulk[k] + q.gap[k] - x.approach * q.arm[k];
      const double all = x.approach * q.arm[k];
      EXPECT_GE(open, -1e-9 * all) << i;
      if (x.force[k] > 1e-9 * x.force.maxCoeff()) {
        EXPECT_NEAR(open, 0.0, 1e-9 * all) << i;
      }
    }
    // The tangent is computed from a difference.
    PointProblem more = q;
    more.moment *= 1 + 1e-6;
    const double step = share_points(more).approach - x.approach;
    EXPECT_NEAR(step / (1e-6 * q.moment), x.yield_per_moment, 1e-4 * x.yield_per_moment) << i;
  }
}

SamplePair crossed(double hand = 1.0) {
  SamplePair p{
      {testing::involute_gear(17, hand * 35, 24), testing::involute_gear(23, hand * 20, 24)},
      {},
      {}};
  p.place.axis_angle = Angle::degrees(hand * 55);
  p.place.center_distance = (p.gears[0].reference_diameter + p.gears[1].reference_diameter) / 2;
  return p;
}

LoadRequest request_of(const SamplePair& p, LoadRegime regime = LoadRegime::point) {
  LoadRequest r;
  r.regime = regime;
  for (int g = 0; g < 2; ++g) r.bodies[g] = {0.5 * p.gears[g].root_diameter, 0.3, kE};
  r.accuracy = ComplianceAccuracy::draft;
  r.slices = {20, 20};
  r.positions = 8;
  return r;
}

PairCompliance compliance_of(const SamplePair& p, const LoadRequest& r) {
  return testing::taken(pair_compliance(p.gears[0], p.gears[1], r));
}

// Tables are computed with E = 1, so one set is valid for all moduli.
LoadedContact run(const SamplePair& p, LoadRequest r, const PairCompliance& made, double e = kE) {
  PairCompliance c = made;
  for (int g = 0; g < 2; ++g) c.bodies[g].youngs_modulus = r.bodies[g].youngs_modulus = e;
  LoadedContact found = loaded_contact(p.pair(), p.gears[0], p.gears[1], c, r);
  EXPECT_EQ(found.unfinished, 0);
  return found;
}

void expect_laws(const SamplePair& p) {
  LoadRequest r = request_of(p);
  r.root_stress = false;
  const PairCompliance c = compliance_of(p, r);
  // Rigid teeth, and teeth with a very small load, give the results of unloaded contact.
  const auto rigid = analyse_contact(p.pair(), {.positions = 8});
  for (const auto& [e, torque] : {std::pair(1e15, 1e4), std::pair(kE, 1e-6)}) {
    r.torques = {torque};
    const LoadedContact answer = run(p, r, c, e);
    for (int i = 0; i < 8; ++i)
      EXPECT_NEAR(answer.torques[0].positions[i].te.rad(), rigid.positions[i].te.rad(), 1e-9) << i;
  }
  // If torque and modulus change by the same factor, the result is the same.
  r.torques = {1e5};
  const LoadedContact soft = run(p, r, c, kE);
  r.torques = {3e5};
  const LoadedContact hard = run(p, r, c, 3 * kE);
  for (int i = 0; i < 8; ++i) {
    const double u = soft.torques[0].positions[i].approach;
    EXPECT_NEAR(u, hard.torques[0].positions[i].approach, 1e-9 * u) << i;
  }
}

TEST(PointContact, CrossedTeethKeepTheLaws) { expect_laws(crossed()); }

TEST(PointContact, CircularArcsKeepTheLaws) { expect_laws(testing::arcs()); }

TEST(PointContact, CarriesTheTorqueAndSharesIt) {
  const SamplePair p = crossed();
  LoadRequest r = request_of(p);
  r.torques = {1e3, 2e4};
  const LoadedContact answer = run(p, r, compliance_of(p, r));
  // All points have the same arm, r_b2 cos β_b.
  const double sin_b = std::sin(20 * M_PI / 180) * std::cos(20 * M_PI / 180);
  const double arm = p.gears[1].base_radius() * std::sqrt(1 - sin_b * sin_b);
  int inside = 0;
  for (const LoadedTorque& t : answer.torques) {
    for (const LoadedPosition& q : t.positions) {
      double force = 0.0;
      double share = 0.0;
      for (const LoadedPair& k : q.pairs) {
        force += k.point.force;
        share += k.share;
      }
      EXPECT_GT(q.root_stress[0], 0.0);
      EXPECT_NEAR(share, 1.0, 1e-12);
      EXPECT_NEAR(force, q.force, 1e-12 * force);
      EXPECT_NEAR(q.stiffness, q.force / (q.approach * kUmPerMm), 1e-9 * q.stiffness);
      if (q.edge_carries) continue;  // the normal of an edge is different
      EXPECT_NEAR(force * arm, t.torque * 23 / 17, 1e-9 * t.torque);
      ++inside;
    }
  }
  EXPECT_GT(inside, 4);
}

// Reflection in the plane z = 0 reverses both hands and the sign of the shaft angle.
TEST(PointContact, TheOtherHandIsMirrored) {
  LoadRequest r = request_of(crossed());
  r.torques = {1e4};
  const LoadedContact a = run(crossed(), r, compliance_of(crossed(), r));
  const LoadedContact b = run(crossed(-1), r, compliance_of(crossed(-1), r));
  for (int i = 0; i < 8; ++i) {
    const LoadedPosition& p = a.torques[0].positions[i];
    const LoadedPosition& q = b.torques[0].positions[i];
    EXPECT_NEAR(p.te.rad(), q.te.rad(), 1e-5 * std::abs(p.te.rad())) << i;
    EXPECT_NEAR(p.max_pressure, q.max_pressure, 1e-4 * p.max_pressure) << i;
    // A mode that is nearly at the threshold may be kept for one hand and dropped for the other
    // hand.
    for (int g = 0; g < 2; ++g)
      EXPECT_NEAR(p.root_stress[g], q.root_stress[g], 0.005 * p.root_stress[g]) << i;
    ASSERT_EQ(p.pairs.size(), q.pairs.size());
    for (std::size_t k = 0; k < p.pairs.size(); ++k)
      EXPECT_NEAR(p.pairs[k].point.height[0], -q.pairs[k].point.height[0], 1e-4) << i;
  }
}

// The contact of a crowned spur pair can be computed by both methods. Line contact uses slices with
// the logarithmic term of Hertz and the matrix of the whole line. Point contact uses one ellipse on
// bodies that bend under the load. Its major semi-axis is 1.8 and 3.6 modules under the two
// torques. Without the bending, point contact would be 7 % too soft.
TEST(PointContact, AgreesWithLinesWhereBothHold) {
  SamplePair p{{testing::involute_gear(25, 0, 60), testing::involute_gear(25, 0, 60)}, {}, {}};
  p.place.center_distance = p.gears[0].reference_diameter;
  FlankModifications crown;
  crown.lead_crowning = 0.06;
  p.modify(1, crown);
  LoadRequest line = request_of(p, LoadRegime::line);
  line.slices = {60, 60};
  line.rotations = {Angle()};
  line.torques = {5e3, 3e4};
  LoadRequest point = line;
  point.regime = LoadRegime::point;
  const PairCompliance c = compliance_of(p, line);  // tables for both methods: the faces are equal
  const LoadedContact a = run(p, line, c);
  const LoadedContact b = run(p, point, c);
  for (int k = 0; k < 2; ++k) {
    const LoadedPosition& x = a.torques[k].positions[0];
    const LoadedPosition& y = b.torques[k].positions[0];
    EXPECT_NEAR(x.approach, y.approach, 0.01 * x.approach);
    EXPECT_NEAR(x.max_pressure, y.max_pressure, 0.015 * x.max_pressure);
    EXPECT_NEAR(x.root_stress[0], y.root_stress[0], 0.02 * x.root_stress[0]);
    ASSERT_EQ(x.pairs.size(), y.pairs.size());
    for (std::size_t i = 0; i < x.pairs.size(); ++i)
      EXPECT_NEAR(x.pairs[i].share, y.pairs[i].share, 0.005);
  }
}

}  // namespace
}  // namespace gearwright
