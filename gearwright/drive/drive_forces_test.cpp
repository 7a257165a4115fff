// Laws: (1) closed forms of a helical planet between sun and ring; (2) the forces on the planets
// act on the carrier with the torque of the power flow; (3) axial forces of all bodies add up to 0;
// (4) closed forms of both places of an idler.
#include "gearwright/drive/drive_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

PlanetarySpec helical_set(double beta_deg, double efficiency) {
  PlanetarySpec set;
  set.z(M::sun) = 21;
  set.z(M::planet) = 24;
  set.z(M::ring) = 69;
  set.planets = 3;
  set.normal_module = 2.0;
  set.helix_deg.all = beta_deg;
  set.torque_Nm = 50.0;
  set.efficiency.all = efficiency;
  return set;
}

Drive drive_of(const PlanetarySpec& set) {
  return testing::taken(make_drive({testing::taken(graph_of(set)), {}}));
}

std::size_t body_named(const Drive& drive, const std::string& name) {
  for (std::size_t b = 0; b < drive.graph.bodies.size(); ++b)
    if (drive.graph.bodies[b].name == name) return b;
  ADD_FAILURE() << name;
  return 0;
}

TEST(DriveForces, OfASetHaveTheClosedForms) {
  const Drive drive = drive_of(helical_set(18.0, 1.0));
  const auto& pair = *drive.geometry.pairs[0]->involute();
  const auto& side = pair.mesh.rack.sides;
  // The torque 50 N m on the sun is balanced by 3 planets.
  const double F_t = 50e3 / 3 / side[0].pitch_radius;
  const auto forces = mesh_forces(drive, 0);
  ASSERT_TRUE(forces);
  EXPECT_NEAR(std::abs(forces->tangential), F_t, 1e-9);
  // The teeth resist the input, which turns the sun counter-clockwise.
  EXPECT_LT(forces->tangential, 0.0);
  EXPECT_NEAR(forces->separating, F_t * std::tan(pair.mesh.rack.sides[0].transverse_angle), 1e-9);
  // The sun has a right hand.
  EXPECT_NEAR(forces->axial, F_t * side[0].tan_helix, 1e-9);
  EXPECT_GT(forces->axial, 0.0);

  const auto planet = body_forces(drive, body_named(drive, "planet"));
  ASSERT_TRUE(planet);
  EXPECT_NEAR(planet->axial, 0.0, 1e-9);
  EXPECT_NEAR(planet->radial, 2 * F_t, 1e-9);
  const double r_ring = drive.geometry.pairs[1]->involute()->mesh.rack.sides[0].pitch_radius;
  EXPECT_NEAR(planet->tilting, F_t * side[0].tan_helix * (side[1].pitch_radius + r_ring), 1e-6);
  const auto sun = body_forces(drive, body_named(drive, "sun"));
  EXPECT_NEAR(sun->radial, 0.0, 1e-9);
  EXPECT_NEAR(sun->tilting, 0.0, 1e-6);
  EXPECT_NEAR(sun->axial, 3 * forces->axial, 1e-9);
  EXPECT_FALSE(body_forces(drive, body_named(drive, "carrier")));
}

TEST(DriveForces, BalanceTheTorquesOfThePowerFlow) {
  for (const double beta : {0.0, 12.0, -25.0}) {
    const Drive drive = drive_of(helical_set(beta, 1.0));
    const double torque = drive.flow->torque[body_named(drive, "carrier")] * 50e3;
    const auto planet = body_forces(drive, body_named(drive, "planet"));
    // The radial parts of both meshes cancel, so the whole force acts along the path of the pin.
    EXPECT_NEAR(3 * planet->radial * *drive.geometry.distance[0], std::abs(torque), 1e-6);
    const auto sun = body_forces(drive, body_named(drive, "sun"));
    const auto ring = body_forces(drive, body_named(drive, "ring"));
    EXPECT_NEAR(sun->axial + 3 * planet->axial + ring->axial, 0.0, 1e-9);
  }
  // A loss in the mesh of sun and planet reduces the force at the ring.
  const Drive lossy = drive_of(helical_set(18.0, 0.98));
  EXPECT_NEAR(std::abs(mesh_forces(lossy, 1)->tangential / mesh_forces(lossy, 0)->tangential), 0.98,
              1e-12);
}

// Law (4). r_1 and r_2 point from the axis of the idler to the axes of the sun and of the planet.
// The sun turns counter-clockwise and pushes the idler by −F_t z × r_1 − F_r r_1, and the planet
// resists with F_t z × r_2 − F_r r_2. Both sums are parallel to r_1 + r_2. They have the same sense
// if r_2 is counter-clockwise from r_1, which is so if the idler is counter-clockwise from the
// planet.
TEST(DriveForces, OfAnIdlerDependOnItsSide) {
  PlanetarySpec set = helical_set(0.0, 1.0);
  set.z(M::sun) = 26;
  set.z(M::idler) = 17;
  set.z(M::planet) = 17;
  set.z(M::ring) = 80;
  set.profile_shift.all = 0.0;
  const Drive left = drive_of(set);
  set.idler_side = IdlerSide::clockwise;
  const Drive right = drive_of(set);
  const auto& a = left.geometry.distance;  // sun and idler, idler and planet, planet and ring
  ASSERT_EQ(left.graph.meshes[2].name, "planet_ring");
  const double cosine = (*a[0] * *a[0] + *a[1] * *a[1] - *a[2] * *a[2]) / (2 * *a[0] * *a[1]);
  const double half = std::acos(cosine) / 2;
  const double F_t = 50e3 / 3 / 26.0;  // m z/2 = 26 mm
  const double along = F_t * 2 * std::sin(half);
  const double across = F_t * std::tan(Angle::degrees(20).rad()) * 2 * std::cos(half);
  const std::size_t idler = body_named(left, "idler");
  EXPECT_NEAR(body_forces(left, idler)->radial, along + across, 1e-6);
  EXPECT_NEAR(body_forces(right, idler)->radial, along - across, 1e-6);
  for (const Drive* drive : {&left, &right})
    EXPECT_EQ(mesh_forces(*drive, 0)->tangential, mesh_forces(left, 0)->tangential);
}

TEST(DriveForces, NeedATorqueAndTeeth) {
  PlanetarySpec set = helical_set(18.0, 0.98);
  set.torque_Nm = std::nullopt;
  EXPECT_FALSE(mesh_forces(drive_of(set), 0));
  set = helical_set(0.0, 0.98);
  set.normal_module = std::nullopt;
  EXPECT_FALSE(mesh_forces(drive_of(set), 0));
}

}  // namespace
}  // namespace gearwright
