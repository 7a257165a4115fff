// The deflection of a shaft is compared with textbook beams and with finite elements that share no
// code with the product: Hermite elements for bending alone, and linear elements with reduced
// integration for bending with shear, extrapolated from two meshes.
#include "gearwright/compliance/shaft.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace gearwright {
namespace {

using Eigen::Index;
// The oracle uses `long double`, because short elements between close neighbours reduce the
// accuracy.
using BeamScalar = long double;
using BeamMatrix4 = Eigen::Matrix<BeamScalar, 4, 4>;
using BeamVector4 = Eigen::Matrix<BeamScalar, 4, 1>;
using BeamMatrix = Eigen::Matrix<BeamScalar, Eigen::Dynamic, Eigen::Dynamic>;
using BeamVector = Eigen::Matrix<BeamScalar, Eigen::Dynamic, 1>;

Shaft plain_shaft(double from, double to, double diameter) {
  Shaft s;
  s.bearings = {from, to};
  s.diameters = {diameter};
  return s;
}
double second_moment(double d) { return std::numbers::pi * std::pow(d, 4) / 64; }

constexpr double kBeamRounding = 1e-11;  // relative rounding error of polynomials of degree 4

TEST(Shaft, UniformLoadOverTheSpan) {
  Shaft s = plain_shaft(-50, 50, 30);
  s.shear = false;
  const double EI = s.youngs_modulus * second_moment(30);
  const auto w = shaft_deflection(s, {2000, 0, -50, 50}, {-50, 0, 50}).w;
  EXPECT_NEAR(w[1] / (5 * 20 * std::pow(100.0, 4) / (384 * EI)), 1.0, kBeamRounding);
  EXPECT_NEAR(w[0], 0.0, 1e-17);
  EXPECT_NEAR(w[2], 0.0, 1e-14);
}

// A load distributed over the length e differs from a point load by O(e²).
TEST(Shaft, PointLoadInTheMiddleAndOverhung) {
  constexpr double e = 1e-3;
  constexpr double kSpread = 1e-8;
  constexpr double F = 1000, L = 120, a = 35;
  Shaft s = plain_shaft(-L / 2, L / 2, 25);
  const double EI = s.youngs_modulus * second_moment(25);
  const double GA = 6 * 1.3 / 8.8 * s.youngs_modulus / 2.6 * std::numbers::pi * 25 * 25 / 4;
  const double bent = F * L * L * L / (48 * EI);
  EXPECT_NEAR(shaft_deflection(s, {F, 0, -e, e}, {0}).w[0] / (bent + F * L / (4 * GA)), 1.0, 1e-5);
  s.shear = false;
  EXPECT_NEAR(shaft_deflection(s, {F, 0, -e, e}, {0}).w[0] / bent, 1.0, kSpread);
  s.bearings = {-a - L, -a};
  EXPECT_NEAR(shaft_deflection(s, {F, 0, -e, e}, {0}).w[0] / (F * a * a * (L + a) / (3 * EI)), 1.0,
              kSpread);
}

TEST(Shaft, BearingsYieldByTheirReactions) {
  Shaft s = plain_shaft(-30, 70, 1e4);  // practically rigid
  s.bearing_stiffness = {2e5, 1e5};
  const ShaftLoad load{1000, 0, -10, 10};
  const auto R = bearing_reactions(s, load);
  EXPECT_NEAR(R[0], -700, 1e-9);
  EXPECT_NEAR(R[1], -300, 1e-9);
  const auto w = shaft_deflection(s, load, {-30, 20, 70}).w;
  EXPECT_NEAR(w[0], 700 / 2e5, 1e-12);
  EXPECT_NEAR(w[2], 300 / 1e5, 1e-12);
  EXPECT_NEAR(w[1], (w[0] + w[2]) / 2, 1e-6);
}

struct RandomShaft {
  Shaft shaft;
  ShaftLoad load;
  std::vector<double> ends;  ///< section and load are constant between neighbouring values
};

RandomShaft random_shaft(std::mt19937& random) {
  const auto in = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  RandomShaft r;
  const bool overhung = in(0, 1) < 0.3;
  r.shaft.bearings = {in(-90, -60), overhung ? in(-45, -35) : in(35, 80)};
  r.shaft.diameters = {in(20, 50)};
  double z = -70;
  while ((z += in(10, 50)) < 60) {
    r.shaft.steps.push_back(z);
    r.shaft.diameters.push_back(in(20, 50));
  }
  if (in(0, 1) < 0.5) r.shaft.bearing_stiffness = {in(5e4, 5e5), in(5e4, 5e5)};
  r.load = {in(-5000, 5000), in(-1e5, 1e5), in(-30, -10), in(5, 30)};
  r.ends = {-100, 100, r.shaft.bearings[0], r.shaft.bearings[1], r.load.lo, r.load.hi};
  r.ends.insert(r.ends.end(), r.shaft.steps.begin(), r.shaft.steps.end());
  std::sort(r.ends.begin(), r.ends.end());
  return r;
}

// Nodes of a mesh with `parts` elements in each interval between ends, and the deflection w at the
// nodes.
struct BeamMesh {
  std::vector<double> z, w;
};

BeamMesh finite_elements(const RandomShaft& r, int parts, bool shear) {
  BeamMesh mesh;
  for (std::size_t i = 0; i + 1 < r.ends.size(); ++i)
    for (int k = 0; k < parts; ++k)
      mesh.z.push_back(r.ends[i] + (r.ends[i + 1] - r.ends[i]) * k / parts);
  mesh.z.push_back(r.ends.back());
  const auto n = static_cast<Index>(mesh.z.size());
  BeamMatrix K = BeamMatrix::Zero(2 * n, 2 * n);
  BeamVector f = BeamVector::Zero(2 * n);
  const double E = r.shaft.youngs_modulus;
  const double G = E / 2.6;
  for (Index e = 0; e + 1 < n; ++e) {
    const double middle = (mesh.z[e] + mesh.z[e + 1]) / 2;
    const BeamScalar h = BeamScalar(mesh.z[e + 1]) - mesh.z[e];
    std::size_t section = 0;
    while (section < r.shaft.steps.size() && r.shaft.steps[section] < middle) ++section;
    const double d = r.shaft.diameters[section];
    const double EI = E * second_moment(d);
    const double b = r.load.hi - r.load.lo;
    const bool loaded = middle > r.load.lo && middle < r.load.hi;
    const double q = loaded ? r.load.force / b : 0.0;
    const double m = loaded ? r.load.moment / b : 0.0;
    BeamMatrix4 k;
    BeamVector4 p;
    if (shear) {
      const BeamVector4 strain(-1 / h, -0.5, 1 / h, -0.5);
      const BeamVector4 bend(0, -1 / h, 0, 1 / h);
      const double kappa = 6 * 1.3 / (7 + 6 * 0.3);
      k = h * (BeamScalar(kappa * G * std::numbers::pi * d * d / 4) * strain * strain.transpose() +
               BeamScalar(EI) * bend * bend.transpose());
      p << q * h / 2, m * h / 2, q * h / 2, m * h / 2;
    } else {
      k << 12, 6 * h, -12, 6 * h, 6 * h, 4 * h * h, -6 * h, 2 * h * h, -12, -6 * h, 12, -6 * h,
          6 * h, 2 * h * h, -6 * h, 4 * h * h;
      k *= EI / (h * h * h);
      p << q * h / 2 - m, q * h * h / 12, q * h / 2 + m, -q * h * h / 12;
    }
    K.block<4, 4>(2 * e, 2 * e) += k;
    f.segment<4>(2 * e) += p;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto node =
        2 * (std::find(mesh.z.begin(), mesh.z.end(), r.shaft.bearings[i]) - mesh.z.begin());
    if (r.shaft.bearing_stiffness) {
      K(node, node) += (*r.shaft.bearing_stiffness)[i];
    } else {
      K.row(node).setZero();
      K.col(node).setZero();
      K(node, node) = E;
      f(node) = 0;
    }
  }
  const BeamVector u = K.ldlt().solve(f);
  for (Index i = 0; i < n; ++i) mesh.w.push_back(static_cast<double>(u(2 * i)));
  return mesh;
}

double largest_deflection(const std::vector<double>& w) {
  double most = 0.0;
  for (const double x : w) most = std::max(most, std::abs(x));
  return most;
}

// Hermite elements are exact at their nodes if section and load are constant within each element.
TEST(Shaft, BendingAgreesWithHermiteElements) {
  constexpr double kConditioned = 1e-8;  // rounding of the stiffness matrix in `long double`
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    RandomShaft r = random_shaft(random);
    r.shaft.shear = false;
    const BeamMesh mesh = finite_elements(r, 3, false);
    const auto w = shaft_deflection(r.shaft, r.load, mesh.z).w;
    const double size = largest_deflection(mesh.w);
    for (std::size_t k = 0; k < w.size(); ++k) EXPECT_NEAR(w[k], mesh.w[k], kConditioned * size);
  }
}

// The error of linear elements is a series in even powers of h. Combining two meshes removes the
// term in h².
TEST(Shaft, ShearAgreesWithLinearElements) {
  constexpr int kParts = 12;
  std::mt19937 random(11);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const RandomShaft r = random_shaft(random);
    const BeamMesh coarse = finite_elements(r, kParts, true);
    const BeamMesh fine = finite_elements(r, 2 * kParts, true);
    const auto w = shaft_deflection(r.shaft, r.load, coarse.z).w;
    const double size = largest_deflection(fine.w);
    for (std::size_t k = 0; k < w.size(); ++k) {
      const double limit = fine.w[2 * k] + (fine.w[2 * k] - coarse.w[k]) / 3;
      EXPECT_NEAR(w[k], limit, 1e-6 * size);
    }
  }
}

TEST(Shaft, LawsOfScale) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    RandomShaft r = random_shaft(random);
    r.shaft.bearing_stiffness.reset();
    r.load.moment = 0.0;
    const double one = shaft_deflection(r.shaft, r.load, {0}).w[0];
    ShaftLoad twice = r.load;
    twice.force *= 2;
    EXPECT_DOUBLE_EQ(shaft_deflection(r.shaft, twice, {0}).w[0], 2 * one);  // (1)
    for (auto* list : {&r.shaft.diameters, &r.shaft.steps})
      for (double& x : *list) x *= 2;
    for (double& x : r.shaft.bearings) x *= 2;
    r.load.lo *= 2;
    r.load.hi *= 2;
    EXPECT_DOUBLE_EQ(shaft_deflection(r.shaft, r.load, {0}).w[0], one / 2);  // (2)
  }
}

// The twist is compared with a sum over thin discs, for both sides of the torque.
TEST(Shaft, TwistOfThinDiscs) {
  Shaft s = plain_shaft(-60, 60, 40);
  constexpr double T = 2e5, b = 40, body = 55;
  constexpr int kDiscs = 4000;
  const double GI = s.youngs_modulus / 2.6 * 2 * second_moment(body);
  const std::vector<double> at{-20, -3, 7.5, 20};
  for (const ShaftSide side : {ShaftSide::left, ShaftSide::right}) {
    s.torque_from = side;
    const bool left = side == ShaftSide::left;
    const auto twist = shaft_twist(s, T, body, -b / 2, b / 2, at);
    for (std::size_t k = 0; k < at.size(); ++k) {
      double sum = 0.0;
      for (int i = 0; i < kDiscs; ++i) {  // disc boundaries coincide with all of these positions
        const double z = -b / 2 + b * (i + 0.5) / kDiscs;
        if (left ? z > at[k] : z < at[k]) continue;
        sum += T * (left ? b / 2 - z : z + b / 2) / b / GI * b / kDiscs;
      }
      EXPECT_NEAR(twist[k], sum, 1e-12 * T * b / GI);
    }
  }
}

TEST(Shaft, ImpossibleOnes) {
  EXPECT_TRUE(plain_shaft(-1, 1, 2).possible());
  EXPECT_FALSE(plain_shaft(1, 1, 2).possible());
  EXPECT_FALSE(plain_shaft(-1, 1, 0).possible());
  Shaft s = plain_shaft(-1, 1, 2);
  s.steps = {0};
  EXPECT_FALSE(s.possible());
  s.diameters = {2, 3};
  EXPECT_TRUE(s.possible());
}

}  // namespace
}  // namespace gearwright
