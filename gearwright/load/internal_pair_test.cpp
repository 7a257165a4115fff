// Tests of loaded pairs with an internal gear. loaded_contact_test.cpp tests the laws that they
// share with external pairs, and the oracles are in tests/oracle.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/gap_places.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/testing/drive.hpp"

namespace gearwright {
namespace {

using testing::Drive;
using testing::run;

constexpr int kSlices = 12;

Drive internal_drive(double helix_deg, double face = 30.0) {
  return testing::steel_drive(-65, helix_deg, face);
}

TEST(LoadedInternalPair, TeethOfARingYieldSymmetricallyAndPositively) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = internal_drive(helix);
    const auto table = tooth_compliance(d.one, d.two, 2, testing::steel_request(d));
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
  LoadRequest r = testing::steel_request(d);
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
    LoadRequest r = testing::steel_request(d);
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
    const LoadRequest r = testing::steel_request(d);
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
