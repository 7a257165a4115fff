// Loaded contact is compared with two finite-element gears in contact, and its laws are tested.
#include "gearwright/load/loaded_contact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>

#include "gearwright/base/units.hpp"
#include "gearwright/load/testing/drive.hpp"

namespace gearwright {
namespace {

using testing::Drive;
using testing::kE;
using testing::run;
using testing::steel_drive;

// An aggregate would accept values for only some of its members and set the others to 0.
static_assert(!std::is_constructible_v<LoadedContact, std::vector<LoadedTorque>>);

// Numbers of teeth of gear 2, for the laws that hold for external and internal pairs; −65 is an
// internal gear.
constexpr std::array kWheels{25, -65};

Drive external_drive(double helix_deg, double face) {
  return testing::steel_drive(25, helix_deg, face);
}

LoadRequest request_of(const Drive& d, double e = kE) { return testing::steel_request(d, e); }

double moment_of(const LoadedPosition& p, double length, double arm) {
  double sum = 0.0;
  for (const LoadedPair& k : p.pairs) sum += k.line_load.sum() * length * arm;
  return sum;
}

// The reference PAIR2D-25 is a contact computation of two gears with a fine finite-element mesh in
// plane strain, with node-to-node contact and without a Hertz formula, for E = 206 000 MPa,
// m = 3 mm and 100 N/mm. A face of 120 modules is nearly in plane strain, but its ends make it
// softer by 0.12 %.
TEST(LoadedContact, AgreesWithTwoGearsOfFiniteElements) {
  const double face = 360.0;
  const Drive m = external_drive(0, face);
  LoadRequest r = request_of(m);
  r.accuracy = ComplianceAccuracy::full;
  r.slices = {24, 24};
  const double rb = m.one.base_radius();
  r.torques = {100 * face * rb};
  const double u0 = 1.8963 * 3;
  const double pb = 2 * M_PI * rb / 25;
  r.rotations = {Angle()};
  auto c = pair_compliance(m.one, m.two, r);
  ASSERT_TRUE(c);
  const LoadedContact start = loaded_contact(m.pair(), m.one, m.two, *c, r);
  const LoadedPair& at = start.torques[0].positions[0].pairs.back();
  const double u = std::sqrt(at.radius[12][0] * at.radius[12][0] - rb * rb);
  const double phase[7] = {0.05, 0.15, 0.3, 0.5, 0.75, 0.8, 0.95};
  const double approach[7] = {5.0349, 4.9662, 4.9286, 4.9852, 7.365, 7.3547, 7.4242};
  const double share[7] = {0.4248, 0.455, 0.499, 0.5577, 1, 1, 1};
  r.rotations.clear();
  for (const double q : phase)
    r.rotations.push_back(Angle::radians((u0 + q * pb - u - at.pair * pb) / rb));
  const LoadedContact answer = loaded_contact(m.pair(), m.one, m.two, *c, r);
  for (int i = 0; i < 7; ++i) {
    const LoadedPosition& p = answer.torques[0].positions[i];
    EXPECT_NEAR(p.approach * 1e3, approach[i], 0.007 * approach[i]) << phase[i];
    EXPECT_NEAR(p.pairs.front().share, share[i], 0.003) << phase[i];
  }
}

TEST(LoadedContact, CarriesTheTorque) {
  for (const int z_2 : kWheels) {
    for (const double helix : {0.0, 15.0}) {
      const Drive d = steel_drive(z_2, helix);
      LoadRequest r = request_of(d);
      r.torques = {5e4, 3e5};
      const LoadedContact answer = run(d, r);
      EXPECT_FALSE(answer.slices_too_fine);
      EXPECT_EQ(answer.unfinished, 0);
      const double sin_b = std::sin(helix * M_PI / 180) * std::cos(20 * M_PI / 180);
      const double cos_b = std::sqrt(1 - sin_b * sin_b);
      for (const LoadedTorque& t : answer.torques) {
        for (const LoadedPosition& p : t.positions) {
          EXPECT_NEAR(moment_of(p, 30.0 / 12 / cos_b, d.one.base_radius() * cos_b), t.torque,
                      (z_2 < 0 ? 1e-12 : 1e-11) * t.torque);
          double sum = 0.0;
          for (const LoadedPair& k : p.pairs) sum += k.share;
          EXPECT_NEAR(sum, 1.0, 1e-14);
          for (const double stress : p.root_stress) EXPECT_GT(stress, 0.0);
        }
      }
    }
  }
}

// As in the web page, the tables are reused, and positions are computed one at a time in any order.
TEST(LoadedContact, InPiecesIsTheSameToTheLastBit) {
  const Drive m = external_drive(12, 30);
  LoadRequest r = request_of(m);
  r.torques = {2e5};
  r.deflection_slope = 0.004;
  const LoadedContact whole = run(m, r);
  const auto one = tooth_compliance(m.one, m.two, 1, r);
  const auto two = tooth_compliance(m.one, m.two, 2, r);
  ASSERT_TRUE(one && two);
  const auto c = pair_compliance(m.one, m.two, r, {*one, *two});
  ASSERT_TRUE(c);
  EXPECT_EQ(c->table[0], *one);
  const ContactPair pair = m.pair();
  LoadedTurn turn(pair, m.one, m.two, *c, r);
  for (std::size_t i = turn.positions(); i-- > 0;) turn.solve(i, i + 1);
  const LoadedContact pieces = turn.result();
  const LoadedTorque& a = whole.torques[0];
  const LoadedTorque& b = pieces.torques[0];
  ASSERT_EQ(a.positions.size(), b.positions.size());
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    EXPECT_EQ(a.positions[i].te, b.positions[i].te) << i;
    EXPECT_EQ(a.positions[i].max_pressure, b.positions[i].max_pressure) << i;
    EXPECT_EQ(a.positions[i].root_stress, b.positions[i].root_stress) << i;
  }
  EXPECT_EQ(a.face_load_factor, b.face_load_factor);
  EXPECT_EQ(a.root_stress, b.root_stress);
  EXPECT_EQ(a.stiffness.mean, b.stiffness.mean);
  double stiffest = 0.0;
  for (const LoadedPosition& p : b.positions) stiffest = std::max(stiffest, p.stiffness);
  EXPECT_EQ(stiffest, b.stiffness.max);
}

TEST(LoadedContact, TablesAreThoseOfTheTeethAlone) {
  const Drive m = external_drive(12, 30);
  const LoadRequest r = request_of(m);
  const std::array<const Gear*, 2> gears{&m.one, &m.two};
  LoadRequest other = r;
  other.torques = {1e6};
  other.deflection_bow = 0.01;
  other.bodies[0].youngs_modulus = 1e5;
  EXPECT_TRUE(same_compliance(gears, r, gears, other, 1));
  other.bodies[0].bore_diameter = 20;
  EXPECT_FALSE(same_compliance(gears, r, gears, other, 1));
  EXPECT_TRUE(same_compliance(gears, r, gears, other, 2));
  other.slices = {14, 14};
  EXPECT_FALSE(same_compliance(gears, r, gears, other, 2));
  const Drive wider = external_drive(12, 31);
  EXPECT_FALSE(same_compliance(gears, r, {&wider.one, &wider.two}, r, 1));
  const Drive steeper = external_drive(13, 30);
  EXPECT_FALSE(same_compliance(gears, r, {&steeper.one, &steeper.two}, r, 2));
}

// Rigid teeth, and teeth with a very small load, give the results of unloaded contact.
TEST(LoadedContact, StiffOrIdleTeethAreThoseOfContact) {
  for (const int z_2 : kWheels) {
    for (const double helix : {0.0, 15.0}) {
      const Drive d = steel_drive(z_2, helix);
      const auto rigid = analyse_contact(d.pair(), {.positions = 8});
      for (const auto& [e, torque] : {std::pair(1e13, 1e5), std::pair(kE, 1e-3)}) {
        LoadRequest r = request_of(d, e);
        r.torques = {torque};
        const LoadedContact answer = run(d, r);
        for (int i = 0; i < 8; ++i)
          EXPECT_NEAR(answer.torques[0].positions[i].te.rad(), rigid.positions[i].te.rad(), 1e-10);
      }
    }
  }
}

TEST(LoadedContact, TorqueAndModulusTogetherChangeNothing) {
  for (const int z_2 : kWheels) {
    const Drive d = steel_drive(z_2, 0);
    LoadRequest soft = request_of(d);
    LoadRequest hard = request_of(d, 4 * kE);
    soft.torques = {1e5};
    hard.torques = {4e5};
    const LoadedContact a = run(d, soft);
    const LoadedContact b = run(d, hard);
    for (int i = 0; i < 8; ++i)
      EXPECT_NEAR(a.torques[0].positions[i].approach, b.torques[0].positions[i].approach, 1e-15);
  }
}

TEST(LoadedContact, ScalesWithLength) {
  for (const int z_2 : kWheels) {
    const Drive small = steel_drive(z_2, 0, 30, 3);
    const Drive large = steel_drive(z_2, 0, 60, 6);
    LoadRequest a = request_of(small);
    LoadRequest b = request_of(large);
    a.torques = {1e5};
    b.torques = {8e5};
    const LoadedContact x = run(small, a);
    const LoadedContact y = run(large, b);
    for (int i = 0; i < 8; ++i) {
      const LoadedPosition& p = x.torques[0].positions[i];
      const LoadedPosition& q = y.torques[0].positions[i];
      EXPECT_NEAR(2 * p.approach, q.approach, 1e-10);
      EXPECT_NEAR(p.max_pressure, q.max_pressure, 1e-5);
      for (int g = 0; g < 2; ++g) EXPECT_NEAR(p.root_stress[g], q.root_stress[g], 1e-5);
    }
  }
}

// The opposite hand is the mirror image in the plane of the axes, with its ends exchanged.
TEST(LoadedContact, TheOtherHandIsMirrored) {
  for (const int z_2 : kWheels) {
    const Drive right = steel_drive(z_2, 15);
    const Drive left = steel_drive(z_2, -15);
    LoadRequest r = request_of(right);
    r.torques = {2e5};
    r.deflection_slope = 0.004;
    const LoadedContact a = run(right, r);
    r.deflection_slope = -0.004;
    const LoadedContact b = run(left, r);
    for (int i = 0; i < 8; ++i) {
      const LoadedPosition& p = a.torques[0].positions[i];
      const LoadedPosition& q = b.torques[0].positions[i];
      EXPECT_NEAR(p.approach, q.approach, 1e-7 * p.approach) << i;
      EXPECT_NEAR(p.max_pressure, q.max_pressure, 1e-5 * p.max_pressure) << i;
      for (int g = 0; g < 2; ++g)
        EXPECT_NEAR(p.root_stress[g], q.root_stress[g], 1e-5 * p.root_stress[g]) << i;
    }
  }
}

TEST(LoadedContact, TheOtherDriverLoadsTheOtherFlanks) {
  for (const int z_2 : kWheels) {
    Drive d = steel_drive(z_2, 15);
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
}

// The reference FE2D-ROOT, a converged mesh of triangles with the load at the outer point of single
// contact, gives σ_F b m_n/F_t = 2.797 for two gears with 25 teeth. The ends of a real face are
// free, but its middle is in plane strain.
TEST(LoadedContact, RootStressAgreesWithTriangles) {
  const double face = 180.0;
  const Drive m = external_drive(0, face);
  LoadRequest r = request_of(m);
  r.accuracy = ComplianceAccuracy::full;
  r.slices = {12, 12};
  r.positions = 96;
  const double rb = m.one.base_radius();
  r.torques = {100 * face * rb};
  const LoadedContact answer = run(m, r);
  const double tangential = 100 * std::cos(20 * M_PI / 180);  // N/mm at the reference circle
  for (const double stress : answer.torques[0].max_root_stress)
    EXPECT_NEAR(stress * 3.0 / tangential, 2.797, 0.04 * 2.797);
}

TEST(LoadedContact, ACornerCarriesWhenTheTorqueIsSmall) {
  const Drive m = external_drive(0, 30);
  LoadRequest r = request_of(m);
  r.torques = {10.0, 1e5};
  r.deflection_slope = 0.03;
  const LoadedContact answer = run(m, r);
  const auto carrying = [](const LoadedPosition& p) {
    long n = 0;
    for (const LoadedPair& k : p.pairs) n += (k.line_load.array() > 0.0).count();
    return n;
  };
  EXPECT_LE(carrying(answer.torques[0].positions[0]), 2);
  EXPECT_GT(carrying(answer.torques[1].positions[0]), 2);
  EXPECT_GT(answer.torques[1].face_load_factor, 1.3);
}

// The reference values were computed with a finer model: twenty waves along the face, ten waves
// along the helix, modes kept to 1e-5, and seven teeth with their exact outline instead of five.
// The bores are half of the root diameters. If coupling ended at the neighbouring teeth, the peak
// to peak would be 2.85". Without the waves along the helix, the root stress would be 257 MPa.
TEST(LoadedContact, OfHelicalTeethIsConverged) {
  const auto gear = [](int teeth, double face, double helix) {
    CylindricalSpec s =
        testing::plain_spec({.teeth = teeth, .module = 2.5, .beta_deg = helix, .face_width = face});
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  };
  Drive m{gear(17, 30, 20), gear(43, 25, -20), {}};
  m.mount.center_distance = 0.5 * (m.one.reference_diameter + m.two.reference_diameter);
  LoadRequest r;
  r.bodies = {ElasticBody{0.5 * m.one.root_diameter, 0.3, kE},
              ElasticBody{0.5 * m.two.root_diameter, 0.3, kE}};
  r.torques = {100e3};
  const LoadedContact c = run(m, r);
  const LoadedTorque& t = c.torques.front();
  EXPECT_NEAR(t.peak_to_peak.rad() / kRadPerArcsec, 2.1706, 0.003 * 2.1706);
  EXPECT_NEAR(t.stiffness.mean, 16.337, 0.012 * 16.337);
  EXPECT_NEAR(t.max_root_stress[0], 157.94, 0.003 * 157.94);
  EXPECT_NEAR(t.max_root_stress[1], 220.69, 0.015 * 220.69);
  EXPECT_NEAR(t.max_pressure, 2290.06, 0.003 * 2290.06);
}

// A deflection that closes the gap at one end of the face increases the load at this end. This is
// tested for both pairs of flanks.
TEST(LoadedContact, SlicesCountFromOneEndForBothDrivers) {
  Drive m = external_drive(0, 30);
  LoadRequest r = request_of(m);
  r.torques = {1e5};
  r.deflection_slope = 0.02;
  auto c = pair_compliance(m.one, m.two, r);
  ASSERT_TRUE(c) << c.error().message();
  Eigen::VectorXd along[2];
  for (const bool second : {false, true}) {
    m.mount.gear2_drives = second;
    along[second] = loaded_contact(m.pair(), m.one, m.two, *c, r).torques[0].face_load;
  }
  EXPECT_GT(along[0][11], 2 * along[0][0]);
  EXPECT_LT((along[0] - along[1]).cwiseAbs().maxCoeff(), 1e-9 * along[0].maxCoeff());
}

// The greatest fraction of the load that a single tooth pair carries, computed from the line loads.
double greatest_share(const LoadedTorque& t) {
  double greatest = 0.0;
  for (const LoadedPosition& p : t.positions) {
    double all = 0.0;
    double most = 0.0;
    for (const LoadedPair& k : p.pairs) {
      double load = 0.0;
      for (const double q : k.line_load) load += q;
      all += load;
      most = std::max(most, load);
    }
    greatest = std::max(greatest, most / all);
  }
  return greatest;
}

TEST(LoadedContact, TransverseLoadFactorComparesWithThePairWithoutErrors) {
  Drive m = external_drive(15, 30);
  LoadRequest r = request_of(m);
  r.torques = {1e5, 3e5};
  const auto c = pair_compliance(m.one, m.two, r);
  ASSERT_TRUE(c);
  const ContactPair perfect = m.pair();
  const LoadedContact without = loaded_contact(perfect, m.one, m.two, *c, r);
  const LoadedContact itself = loaded_contact(perfect, m.one, m.two, *c, r, &perfect);
  m.mount.errors.crossing = Angle::degrees(0.03);
  r.deflection_bow = 0.004;
  const ContactPair crossed = m.pair();
  const LoadedContact with = loaded_contact(crossed, m.one, m.two, *c, r, &perfect);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(without.torques[i].transverse_load_factor, 1.0);
    EXPECT_DOUBLE_EQ(itself.torques[i].transverse_load_factor, 1.0);
    const double slow = greatest_share(with.torques[i]) / greatest_share(without.torques[i]);
    EXPECT_NEAR(with.torques[i].transverse_load_factor, slow, 1e-13);
    EXPECT_GT(slow, 1.02);
  }
}

// If one pair carries the whole load at some position, both with errors and without errors, K_Hα is
// 1.
TEST(LoadedContact, TransverseLoadFactorOfSingleContactIsOne) {
  Drive m = external_drive(0, 30);
  LoadRequest r = request_of(m);
  r.torques = {1e5};
  const auto c = pair_compliance(m.one, m.two, r);
  ASSERT_TRUE(c);
  const ContactPair perfect = m.pair();
  m.mount.errors.crossing = Angle::degrees(0.01);
  const ContactPair crossed = m.pair();
  const LoadedContact with = loaded_contact(crossed, m.one, m.two, *c, r, &perfect);
  EXPECT_DOUBLE_EQ(with.torques[0].transverse_load_factor, 1.0);
}

// While the neighbouring teeth carry the load, a fillet is compressed. The compression is less than
// the tension in the fillet while its own tooth carries the load.
TEST(LoadedContact, NeighboursThatBearPressTheFillet) {
  for (const double helix : {0.0, 15.0}) {
    const Drive m = external_drive(helix, 30);
    LoadRequest r = request_of(m);
    r.torques = {2e5, 4e5};
    const LoadedContact answer = run(m, r);
    for (const LoadedTorque& t : answer.torques) {
      for (std::size_t g = 0; g < 2; ++g) {
        EXPECT_LT(t.least_at_max[g], -0.02 * t.max_root_stress[g]);
        EXPECT_GT(t.least_at_max[g], -0.6 * t.max_root_stress[g]);
        EXPECT_LE(t.least_root_stress[g].maxCoeff(), 0.0);
        EXPECT_DOUBLE_EQ(t.root_stress[g].maxCoeff(), t.max_root_stress[g]);
      }
    }
  }
}

TEST(LoadedContact, GoesWithoutRootStressWhereNobodyWantsIt) {
  const Drive m = external_drive(0, 30);
  LoadRequest r = request_of(m);
  r.torques = {1e5};
  const LoadedContact with = run(m, r);
  r.root_stress = false;
  const LoadedContact without = run(m, r);
  EXPECT_EQ(without.torques[0].peak_to_peak, with.torques[0].peak_to_peak);
  EXPECT_EQ(without.torques[0].max_pressure, with.torques[0].max_pressure);
  EXPECT_EQ(without.torques[0].root_stress[0].size(), 0);
  EXPECT_GT(with.torques[0].root_stress[0].maxCoeff(), 0.0);
}

TEST(LoadedContact, NarrowFacesHaveFewerSlices) {
  const auto found = [](const Drive& m, int slices) {
    LoadRequest r = request_of(m);
    r.torques = {2e4};
    r.slices = {slices, slices};
    return run(m, r);
  };
  for (const double helix : {0.0, 15.0, 35.0}) {
    const Drive m = external_drive(helix, 15.0);
    EXPECT_FALSE(found(m, fair_slices(m.one, m.two, LoadRegime::line)[0]).slices_too_fine) << helix;
    EXPECT_TRUE(found(m, 32).slices_too_fine) << helix;
  }
}

}  // namespace
}  // namespace gearwright
