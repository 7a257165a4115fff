#include "gearwright/report/path_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

// A path of so many base pitches; the rest of the mesh is not looked at.
ParallelMesh<double> mesh_of_ratio(double ratio) {
  constexpr double p = 3.0;
  ParallelMesh<double> mesh{};
  mesh.rho1_A = 1.5;
  mesh.rho1_E = mesh.rho1_A + ratio * p;
  mesh.rho1_B = mesh.rho1_E - p;
  mesh.rho1_D = mesh.rho1_A + p;
  mesh.path_length = mesh.rho1_E - mesh.rho1_A;
  mesh.transverse_contact_ratio = ratio;
  return mesh;
}

TEST(ContactZones, LawsHold) {
  for (const double ratio : {0.4, 0.999, 1.0, 1.0001, 1.5, 1.9999, 2.0, 2.3, 3.7}) {
    const auto zones = contact_zones(mesh_of_ratio(ratio));
    double at = 1.5;
    double pairs_times_length = 0.0;
    for (const ContactZone& zone : zones) {
      EXPECT_NEAR(zone.rho1_begin, at, 1e-8);  // (1)
      EXPECT_LT(zone.rho1_begin, zone.rho1_end);
      EXPECT_GE(zone.pairs, static_cast<int>(std::floor(ratio))) << ratio;  // (2)
      EXPECT_LE(zone.pairs, static_cast<int>(std::ceil(ratio))) << ratio;
      at = zone.rho1_end;
    }
    // Along one pitch from A, the pairs average to the contact ratio.
    for (const ContactZone& zone : zones) {
      const double end = std::min(zone.rho1_end, 1.5 + 3.0);
      pairs_times_length += zone.pairs * std::max(0.0, end - zone.rho1_begin);
    }
    EXPECT_NEAR(pairs_times_length / 3.0, ratio, 1e-8);
  }
}

TEST(ContactZones, OrdinaryPathHasThree) {
  const auto zones = contact_zones(mesh_of_ratio(1.6));
  ASSERT_EQ(zones.size(), 3u);
  EXPECT_EQ(zones[0].pairs, 2);
  EXPECT_EQ(zones[1].pairs, 1);
  EXPECT_EQ(zones[2].pairs, 2);
}

TEST(PathFigures, SaysWhereTheInvoluteEnds) {
  EXPECT_NE(path_figures(testing::undercut_pair()).find("no involute"), std::string::npos);
  EXPECT_EQ(path_figures(testing::helical_pair()).find("no involute"), std::string::npos);
}

}  // namespace
}  // namespace gearwright
