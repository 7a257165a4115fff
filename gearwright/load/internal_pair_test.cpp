// Laws of a loaded internal pair. The oracles are in tests/oracle.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/gap_places.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/testing/drive.hpp"

namespace gearwright {
namespace {

using testing::Drive;
using testing::kE;
using testing::run;

constexpr int kPositions = 8;
constexpr int kSlices = 12;

// A pinion with 25 teeth and an internal gear with 65 teeth, whose tips are shortened so that they
// do not reach the root of the pinion.
Drive internal_drive(double helix_deg, double face = 30.0, double module = 3.0) {
  const auto spec = [&](int teeth) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = teeth, .module = module, .beta_deg = helix_deg, .face_width = face});
    s.rack = *iso53_rack("ISO53-A");
    return s;
  };
  CylindricalSpec ring = spec(-65);
  ring.tip_diameter = module * (65 / std::cos(helix_deg * M_PI / 180) - 1.6);
  auto cut = cut_by_default(std::move(make_gear(ring)).take());
  EXPECT_TRUE(cut);
  Drive d{std::move(make_gear(spec(25))).take(), *std::move(cut), {}};
  d.mount.center_distance = 0.5 * (d.two.reference_diameter - d.one.reference_diameter);
  return d;
}

LoadRequest request_of(const Drive& d, double e = kE) {
  const double m = d.one.spec.normal_module;
  LoadRequest r;
  r.bodies = {ElasticBody{12 * m, 0.3, e}, ElasticBody{d.two.root_diameter + 5 * m, 0.3, e}};
  r.accuracy = ComplianceAccuracy::draft;
  r.slices = {kSlices, kSlices};
  r.positions = kPositions;
  return r;
}

TEST(LoadedInternalPair, CarriesTheTorque) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = internal_drive(helix);
    LoadRequest r = request_of(d);
    r.torques = {5e4, 2e5};
    const LoadedContact answer = run(d, r);
    EXPECT_FALSE(answer.slices_too_fine);
    EXPECT_EQ(answer.unfinished, 0);
    const double sin_b = std::sin(helix * M_PI / 180) * std::cos(20 * M_PI / 180);
    const double cos_b = std::sqrt(1 - sin_b * sin_b);
    for (const LoadedTorque& t : answer.torques) {
      for (const LoadedPosition& p : t.positions) {
        double force = 0.0;
        for (const LoadedPair& k : p.pairs) force += k.line_load.sum() * 30.0 / kSlices / cos_b;
        EXPECT_NEAR(force * d.one.base_radius() * cos_b, t.torque, 1e-12 * t.torque);
        EXPECT_GT(p.root_stress[0], 0.0);
        EXPECT_GT(p.root_stress[1], 0.0);
      }
    }
  }
}

TEST(LoadedInternalPair, StiffOrIdleTeethAreThoseOfContact) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = internal_drive(helix);
    const auto rigid = analyse_contact(d.pair(), {.positions = kPositions});
    for (const auto& [e, torque] : {std::pair(1e13, 1e5), std::pair(kE, 1e-3)}) {
      LoadRequest r = request_of(d, e);
      r.torques = {torque};
      const LoadedContact answer = run(d, r);
      for (int i = 0; i < kPositions; ++i)
        EXPECT_NEAR(answer.torques[0].positions[i].te.rad(), rigid.positions[i].te.rad(), 1e-10);
    }
  }
}

TEST(LoadedInternalPair, TorqueAndModulusTogetherChangeNothing) {
  const Drive d = internal_drive(0);
  LoadRequest soft = request_of(d);
  LoadRequest hard = request_of(d, 4 * kE);
  soft.torques = {1e5};
  hard.torques = {4e5};
  const LoadedContact a = run(d, soft);
  const LoadedContact b = run(d, hard);
  for (int i = 0; i < kPositions; ++i)
    EXPECT_NEAR(a.torques[0].positions[i].approach, b.torques[0].positions[i].approach, 1e-15);
}

TEST(LoadedInternalPair, ScalesWithLength) {
  const Drive small = internal_drive(0, 30, 3);
  const Drive large = internal_drive(0, 60, 6);
  LoadRequest a = request_of(small);
  LoadRequest b = request_of(large);
  a.torques = {1e5};
  b.torques = {8e5};
  const LoadedContact x = run(small, a);
  const LoadedContact y = run(large, b);
  for (int i = 0; i < kPositions; ++i) {
    const LoadedPosition& p = x.torques[0].positions[i];
    const LoadedPosition& q = y.torques[0].positions[i];
    EXPECT_NEAR(2 * p.approach, q.approach, 1e-10);
    EXPECT_NEAR(p.max_pressure, q.max_pressure, 1e-5);
    for (int g = 0; g < 2; ++g) EXPECT_NEAR(p.root_stress[g], q.root_stress[g], 1e-5);
  }
}

// The opposite hand is the mirror image in the plane of the axes, with its ends exchanged.
TEST(LoadedInternalPair, TheOtherHandIsMirrored) {
  const Drive right = internal_drive(15);
  const Drive left = internal_drive(-15);
  LoadRequest r = request_of(right);
  r.torques = {2e5};
  r.deflection_slope = 0.004;
  const LoadedContact a = run(right, r);
  r.deflection_slope = -0.004;
  const LoadedContact b = run(left, r);
  for (int i = 0; i < kPositions; ++i) {
    const LoadedPosition& p = a.torques[0].positions[i];
    const LoadedPosition& q = b.torques[0].positions[i];
    EXPECT_NEAR(p.approach, q.approach, 1e-7 * p.approach) << i;
    EXPECT_NEAR(p.max_pressure, q.max_pressure, 1e-5 * p.max_pressure) << i;
    for (int g = 0; g < 2; ++g)
      EXPECT_NEAR(p.root_stress[g], q.root_stress[g], 1e-5 * p.root_stress[g]) << i;
  }
}

TEST(LoadedInternalPair, TheOtherDriverLoadsTheOtherFlanks) {
  Drive d = internal_drive(15);
  LoadRequest r = request_of(d);
  r.torques = {2e5};
  const LoadedContact a = run(d, r);
  d.mount.gear2_drives = true;
  const LoadedContact b = run(d, r);
  EXPECT_NEAR(a.torques[0].stiffness.mean, b.torques[0].stiffness.mean,
              1e-3 * a.torques[0].stiffness.mean);
  EXPECT_GT(b.torques[0].positions[0].te.rad(), 0.0);  // gear 2 leads
  EXPECT_LT(a.torques[0].positions[0].te.rad(), 0.0);
}

TEST(LoadedInternalPair, TeethOfARingYieldSymmetricallyAndPositively) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = internal_drive(helix);
    const auto table = tooth_compliance(d.one, d.two, 2, request_of(d));
    ASSERT_TRUE(table) << table.error().message();
    const auto& section = (*table)->section();
    LinePlaces line;
    for (int j = 0; j < kSlices; ++j)
      line.push_back(section.s.front() + (section.s.back() - section.s.front()) * j / kSlices);
    const Eigen::MatrixXd c = (*table)->same_tooth(line);
    EXPECT_LT((c - c.transpose()).cwiseAbs().maxCoeff(), 1e-12 * c.maxCoeff());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(c).eigenvalues().minCoeff(), 0.0);
  }
}

// The reference values were computed with a finer model: twenty waves along the face, ten waves
// along the helix, modes kept to 1e-5, and seven teeth with their exact outline instead of five.
TEST(LoadedInternalPair, OfHelicalTeethIsConverged) {
  const auto spec = [](int teeth, double shift, double face) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = teeth, .module = 2.5, .beta_deg = 20, .x = shift, .face_width = face});
    s.rack = *iso53_rack("ISO53-A");
    return s;
  };
  CylindricalSpec ring = spec(-60, -0.3, 25);
  ring.tip_diameter = 2.5 * (60 / std::cos(20 * M_PI / 180) - 1.0);
  auto cut = cut_by_default(std::move(make_gear(ring)).take());
  ASSERT_TRUE(cut);
  Drive d{std::move(make_gear(spec(17, 0.3, 30))).take(), *std::move(cut), {}};
  d.mount.center_distance = 0.5 * (d.two.reference_diameter - d.one.reference_diameter);
  LoadRequest r = request_of(d);
  r.accuracy = ComplianceAccuracy::full;
  r.bodies[0].bore_diameter = 0.5 * d.one.root_diameter;
  r.slices = {25, 25};
  r.positions = 32;
  r.torques = {100e3};
  const LoadedContact c = run(d, r);
  const LoadedTorque& t = c.torques.front();
  EXPECT_NEAR(t.peak_to_peak.rad() / kRadPerArcsec, 1.2346, 0.005 * 1.2346);
  EXPECT_NEAR(t.stiffness.mean, 22.8933, 0.003 * 22.8933);
  EXPECT_NEAR(t.max_root_stress[0], 150.881, 0.004 * 150.881);
  EXPECT_NEAR(t.max_root_stress[1], 229.847, 0.015 * 229.847);
  EXPECT_NEAR(t.max_pressure, 1214.51, 0.001 * 1214.51);
}

// The default number of slices is never too large, although 32 slices would be.
TEST(LoadedInternalPair, FairSlicesAreWiderThanTheContact) {
  for (const double helix : {0.0, 15.0, 30.0}) {
    const Drive d = internal_drive(helix, 24);
    LoadRequest r = request_of(d);
    r.torques = {300e3};
    r.slices = fair_slices(d.one, d.two, LoadRegime::line);
    EXPECT_FALSE(run(d, r).slices_too_fine) << helix;
    r.slices = {32, 32};
    EXPECT_TRUE(run(d, r).slices_too_fine) << helix;
  }
}

// The sections of both gears turn in the same sense as their flanks, so that the contact line has
// the same length on either gear as in the plane of action.
TEST(LoadedInternalPair, ContactLinesLieOnBothFlanks) {
  for (const double helix : {15.0, -15.0}) {
    const Drive d = internal_drive(helix);
    const LoadRequest r = request_of(d);
    const auto c = pair_compliance(d.one, d.two, r);
    ASSERT_TRUE(c) << c.error().message();
    const double m = d.one.spec.normal_module;
    const double sin_b = std::sin(helix * M_PI / 180) * std::cos(20 * M_PI / 180);
    const std::vector<double> heights{-0.2, 0.2};
    int lines = 0;
    for (const PairPlaces& p : GapSearch(d.pair(), heights).places(0.0)) {
      if (!p.at[0] || !p.at[1] || is_edge(p.at[0]->kind) || is_edge(p.at[1]->kind)) continue;
      ++lines;
      for (int g = 0; g < 2; ++g) {
        const auto& section = c->table[g]->section();
        const double s = section.length_at_radius(p.at[0]->radius[g] / m);
        const double t = section.length_at_radius(p.at[1]->radius[g] / m);
        const auto metric = section.metric(0.5 * (s + t));
        const double ds = t - s;
        const double dz = (heights[1] - heights[0]) / m;
        const double length = std::sqrt(ds * ds + 2 * metric.sz * ds * dz + metric.zz * dz * dz);
        EXPECT_NEAR(length, dz / std::sqrt(1 - sin_b * sin_b), 2e-3 * dz) << helix << ' ' << g;
      }
    }
    EXPECT_GE(lines, 2);
  }
}

}  // namespace
}  // namespace gearwright
