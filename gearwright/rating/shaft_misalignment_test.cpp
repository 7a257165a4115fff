// The deviation of the flanks is compared with forces and moments as vectors in the housing frame
// and with bending in the planes of x and y. K_Hβ of a rating with shafts is tested too.
#include "gearwright/rating/distribution.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gearwright/rating/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

Shaft sample_shaft(double lo, double hi, std::vector<double> d, std::vector<double> steps) {
  Shaft s;
  s.bearings = {lo, hi};
  s.diameters = std::move(d);
  s.steps = std::move(steps);
  return s;
}
MeshShafts sample_shafts() {
  MeshShafts m;
  m.of = {sample_shaft(-300, 420, {160, 250, 180}, {-190, 200}),
          sample_shaft(-350, 310, {400, 420}, {10})};
  m.of[1]->torque_from = ShaftSide::right;
  m.hand1 = 1.0;
  return m;
}

std::vector<double> shaft_face_points(double b) {
  std::vector<double> z;
  for (int k = 0; k < kShaftPoints; ++k) z.push_back(b * (k / (kShaftPoints - 1.0) - 0.5));
  return z;
}

// On a right-hand gear, the tooth traces at azimuth 0 run towards (0, tan β_w, 1), and the force on
// gear 2 is normal to them.
TEST(ShaftMisalignment, ForcesAsVectors) {
  const RatedPair pair = testing::helical_24_95();
  const double F_t = 2e5;
  const std::vector<double> z = shaft_face_points(pair.face_width);
  for (const double hand : {1.0, -1.0})
    for (const bool gear2_drives : {false, true}) {
      MeshShafts m = sample_shafts();
      m.hand1 = hand;
      m.gear2_drives = gear2_drives;
      const double r_w1 = pair.center_distance * 24 / (24 + 95);
      const double r_w2 = pair.center_distance - r_w1;
      const double torque = F_t * pair.gears[0].reference_diameter / 2;
      const double tan_w =
          hand * std::tan(pair.beta) * r_w1 / (pair.gears[0].reference_diameter / 2);
      const double y = gear2_drives ? 1.0 : -1.0;
      const Eigen::Vector3d along(std::sin(pair.alpha_wt), y * std::cos(pair.alpha_wt), 0.0);
      Eigen::Vector3d force = along * torque / (r_w1 * std::cos(pair.alpha_wt));
      force.z() = -force.y() * tan_w;
      std::vector<double> f(z.size(), 0.0);
      for (std::size_t i = 0; i < 2; ++i) {
        const Eigen::Vector3d on = i == 0 ? Eigen::Vector3d(-force) : force;
        const Eigen::Vector3d arm(i == 0 ? r_w1 : -r_w2, 0, 0);
        const Eigen::Vector3d moment = arm.cross(on);
        const double lo = -pair.face_width / 2;
        const auto u_x = shaft_deflection(*m.of[i], {on.x(), moment.y(), lo, -lo}, z).w;
        const auto u_y = shaft_deflection(*m.of[i], {on.y(), -moment.x(), lo, -lo}, z).w;
        const auto twist =
            shaft_twist(*m.of[i], std::abs(moment.z()), pair.gears[i].root_diameter, lo, -lo, z);
        for (std::size_t k = 0; k < z.size(); ++k) {
          const double away = (i == 0 ? -1 : 1) * (along.x() * u_x[k] + along.y() * u_y[k]);
          f[k] += 1000 * (away + pair.gears[i].base_diameter / 2 * twist[k]);
        }
      }
      const auto made = shaft_deviation(pair, m, F_t);
      const double size = *std::max_element(f.begin(), f.end());
      for (std::size_t k = 0; k < z.size(); ++k) EXPECT_NEAR(made[k], f[k], 1e-10 * size);
    }
}

// The hand is exchanged, and the shaft is mirrored at the middle of the face.
TEST(ShaftMisalignment, MirroredPair) {
  const RatedPair pair = testing::helical_24_95();
  MeshShafts m = sample_shafts();
  MeshShafts mirrored = m;
  mirrored.hand1 = -1;
  for (auto& shaft : mirrored.of) {
    shaft->bearings = {-shaft->bearings[1], -shaft->bearings[0]};
    std::reverse(shaft->diameters.begin(), shaft->diameters.end());
    std::reverse(shaft->steps.begin(), shaft->steps.end());
    for (double& s : shaft->steps) s = -s;
    shaft->torque_from = shaft->torque_from == ShaftSide::left ? ShaftSide::right : ShaftSide::left;
  }
  const auto f = shaft_deviation(pair, m, 1e5);
  const auto g = shaft_deviation(pair, mirrored, 1e5);
  for (std::size_t k = 0; k < f.size(); ++k) EXPECT_NEAR(f[k], g[f.size() - 1 - k], 1e-10 * f[k]);
}

// A shaft that does not bend leaves the twist  r_b T b/(2 G I_p)  of the solid pinion.
TEST(ShaftMisalignment, TorsionAlone) {
  const RatedPair pair = testing::helical_24_95();
  MeshShafts m;
  m.of[0] = sample_shaft(-300, 420, {1e5}, {});
  const RatedGear& g = pair.gears[0];
  const double b = pair.face_width;
  const double d_f = g.root_diameter;
  const double G = 206000 / 2.6;
  const double F_bt = 1e5 * g.reference_diameter / g.base_diameter;
  const double twist = 1000 * F_bt * std::pow(g.base_diameter / 2, 2) * b / 2 /
                       (G * std::acos(-1.0) * std::pow(d_f, 4) / 32);
  EXPECT_NEAR(shaft_misalignment(pair, m, 1e5), twist, 1e-4 * twist);
}

TEST(ShaftMisalignment, GivesTheFaceLoadFactor) {
  const RatedPair pair = testing::helical_24_95();
  RatingInput in = testing::helical_24_95_load();
  in.face_load_factor.reset();
  EXPECT_TRUE(missing_input(in));
  in.misalignment = 20;
  MeshShafts m;
  m.of[0] = sample_shaft(-300, 420, {1e5}, {});
  m.hand1 = 1.0;
  in.shafts = m;
  EXPECT_FALSE(missing_input(in));
  const auto rigid = rate(pair, in);
  ASSERT_TRUE(rigid);
  const double twist = rigid->face.f_sh->value;  // twist of the pinion body
  EXPECT_NEAR(rigid->face.F_betax->value, 1.33 * twist + 20.0, 1e-9);
  in.shafts = sample_shafts();
  const auto soft = rate(pair, in);
  ASSERT_TRUE(soft);
  const double f_sh = soft->face.f_sh->value;
  const double F_m = soft->F_t.value * 1.25 * soft->K_v.value;
  EXPECT_NEAR(f_sh, shaft_misalignment(pair, *in.shafts, F_m), 1e-9 * f_sh);
  EXPECT_NEAR(soft->face.F_betax->value, 1.33 * f_sh + 20, 1e-9 * f_sh);
  EXPECT_GT(soft->face.K_Hbeta.value, rigid->face.K_Hbeta.value);
  EXPECT_LT(soft->S_H[0].value, rigid->S_H[0].value);
  in.face_load_factor = 1.15;  // a given factor has priority
  EXPECT_EQ(rate(pair, in)->face.K_Hbeta.value, 1.15);
  EXPECT_FALSE(rate(pair, in)->face.f_sh);
}

}  // namespace
}  // namespace gearwright
