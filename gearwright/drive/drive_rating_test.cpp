// Laws: (1) torque and speed of a mesh by the closed forms of a simple set; (2) the rating of a
// gear in a drive equals the rating of its pair with N times the life and alternating bending.
#include "gearwright/drive/drive_rating.hpp"

#include <gtest/gtest.h>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

Drive planetary(int planets) {
  PlanetarySpec set;
  set.z(M::sun) = 20;
  set.z(M::planet) = 25;
  set.z(M::ring) = 70;
  set.planets = planets;
  set.normal_module = 2.0;
  set.face_width.all = 20.0;
  set.efficiency.each = {{"sun_planet", 0.985}, {"planet_ring", 0.993}};
  return testing::taken(make_drive({testing::taken(graph_of(set)), {}}));
}

DriveLoad load() {
  DriveLoad load;
  load.torque = 90.0;
  load.speed = 1500.0;
  load.common.application_factor = 1.25;
  load.common.mesh_load_factor = 1.1;
  load.common.life_h = 20.0;  // the life is limited, so the number of cycles has an effect
  load.common.viscosity = 220.0;
  load.common.quality = {6, 6};
  load.common.face_load_factor = 1.2;
  return load;
}

Result<Material> steel(std::size_t) { return *material_named("17CrNiMo6"); }

TEST(DriveRating, TorqueAndSpeedHaveTheClosedForms) {
  const Drive drive = planetary(3);
  const RatingInput sun = mesh_load(drive, 0, load());
  EXPECT_NEAR(sun.torque, 30.0, 1e-12);
  EXPECT_NEAR(*sun.speed, 1500.0 * (1 - 20.0 / 90.0), 1e-9);
  EXPECT_EQ(sun.mesh_load_factor, 1.1);
  const RatingInput ring = mesh_load(drive, 1, load());
  EXPECT_NEAR(ring.torque, 30.0 * 25 / 20 * 0.985, 1e-12);
  EXPECT_NEAR(*ring.speed, 1500.0 * (1 - 20.0 / 90.0) * 20 / 25, 1e-9);
  EXPECT_EQ(mesh_load(planetary(1), 0, load()).mesh_load_factor, 1.0);
}

TEST(DriveRating, GearsHaveTheirUse) {
  const Drive drive = planetary(3);
  const auto ratings = rate_meshes(drive, load(), steel);
  ASSERT_TRUE(ratings) << ratings.error().message();
  const MeshRating& sun = *(*ratings)[0];
  EXPECT_EQ(sun.engagements, (std::array<int, 2>{3, 1}));
  EXPECT_NEAR(sun.rating.N_L[0]->value, 60 * 20.0 * *sun.input.speed * 3, 1e-6);
  EXPECT_NEAR(sun.rating.N_L[1]->value, 60 * 20.0 * *sun.input.speed * 20 / 25, 1e-6);
  EXPECT_EQ(sun.rating.Y_M[0].value, 1.0);
  EXPECT_EQ(sun.rating.Y_M[1].value, 0.7);
  const MeshRating& ring = *(*ratings)[1];
  EXPECT_EQ(ring.engagements, (std::array<int, 2>{1, 3}));
  EXPECT_EQ(ring.rating.Y_M[0].value, 0.7);
  EXPECT_EQ(ring.rating.Y_M[1].value, 1.0);

  RatingInput by_hand = sun.input;
  *by_hand.life_h *= 3;
  const auto pair = rated_pair(*drive.geometry.pairs[0]);
  ASSERT_TRUE(pair);
  const auto expected = rate(*pair, by_hand);
  ASSERT_TRUE(expected);
  EXPECT_EQ(sun.rating.S_F[0].value, expected->S_F[0].value);
  EXPECT_EQ(sun.rating.S_H[0].value, expected->S_H[0].value);
  EXPECT_EQ(sun.rating.sigma_H[1].value, expected->sigma_H[1].value);
  // In the range of limited life, more cycles reduce the permissible load.
  EXPECT_LT(sun.rating.S_H[0].value, rate(*pair, sun.input)->S_H[0].value);
}

TEST(DriveRating, SteppedPlanetsBendOneWay) {
  PlanetarySpec set;
  set.z(M::sun) = 21;
  set.z(M::planet) = 27;
  set.z(M::planet2) = 15;
  set.z(M::ring2) = 63;
  set.planets = 3;
  set.normal_module = 2.0;
  set.efficiency.all = 0.99;
  const auto graph = graph_of(set);
  ASSERT_TRUE(graph);
  const auto drive = make_drive({*graph, {}});
  ASSERT_TRUE(drive) << drive.error().message();
  const auto ratings = rate_meshes(*drive, load(), steel);
  ASSERT_TRUE(ratings) << ratings.error().message();
  for (const auto& r : *ratings)
    for (const std::size_t i : {0, 1}) EXPECT_EQ(r->rating.Y_M[i].value, 1.0);
}

}  // namespace
}  // namespace gearwright
