// Laws: (1) both ends of a stated range make a drive without faults, and the next value does not;
// (2) the faults of a drive state the range.
#include "gearwright/drive/geometry_remedy.hpp"

#include <gtest/gtest.h>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

using M = SetMember;

DriveGraph set_of(int sun, int planet, int ring, std::optional<double> distance = {}) {
  PlanetarySpec set;
  set.z(M::sun) = sun;
  set.z(M::planet) = planet;
  set.z(M::ring) = ring;
  set.planets = 3;
  set.normal_module = 2.0;
  set.center_distance.all = distance;
  return testing::taken(graph_of(set));
}

bool runs(const DriveGraph& graph) {
  const DriveGeometry made = drive_geometry(graph);
  bool runs = made.faults.empty();
  for (const auto& pair : made.pairs) {
    runs = runs && pair && pair->contact_ratio_true() > 0.0;
    if (!runs) break;
    for (const Warning& w : pair->warnings()) runs = runs && severity_of(w) != Severity::problem;
  }
  return runs;
}

std::string first_fault(const DriveGraph& graph) {
  DriveGeometry made = drive_geometry(graph);
  add_remedy(graph, made);
  return made.faults.empty() ? "" : made.faults.front().message;
}

TEST(GeometryRemedy, TheRangeOfCentreDistancesIsPossible) {
  for (const auto& [sun, planet] : {std::pair{20, 25}, {12, 40}, {33, 18}}) {
    const int ring = sun + 2 * planet;
    const auto range = possible_distances(set_of(sun, planet, ring, 200.0), 0);
    ASSERT_TRUE(range);
    const auto [least, greatest] = *range;
    EXPECT_LT(least, sun + planet);
    EXPECT_GT(greatest, sun + planet);
    EXPECT_TRUE(runs(set_of(sun, planet, ring, least)));
    EXPECT_TRUE(runs(set_of(sun, planet, ring, greatest)));
    for (double a = sun + planet; a < greatest; a += 0.05)
      EXPECT_TRUE(runs(set_of(sun, planet, ring, a)));
    for (double a = sun + planet; a > least; a -= 0.05)
      EXPECT_TRUE(runs(set_of(sun, planet, ring, a)));
    EXPECT_FALSE(runs(set_of(sun, planet, ring, least - 0.002)));
    EXPECT_FALSE(runs(set_of(sun, planet, ring, greatest + 0.002)));
  }
}

TEST(GeometryRemedy, TheRangeOfRingsIsPossible) {
  for (const int ring : {30, 76, 400}) {
    const auto teeth = possible_teeth(set_of(20, 25, ring), 1);
    ASSERT_TRUE(teeth) << ring;
    EXPECT_EQ(teeth->nominal, 70);
    for (int z = teeth->least; z <= teeth->greatest; ++z) EXPECT_TRUE(runs(set_of(20, 25, z))) << z;
    EXPECT_FALSE(runs(set_of(20, 25, teeth->least - 1)));
    EXPECT_FALSE(runs(set_of(20, 25, teeth->greatest + 1)));
    EXPECT_NE(first_fault(set_of(20, 25, ring)).find("sun + 2 planet = 70; ring = "),
              std::string::npos);
  }
}

TEST(GeometryRemedy, TheFaultOfADistanceStatesTheRange) {
  const std::string fault = first_fault(set_of(20, 25, 70, 60.0));
  EXPECT_NE(fault.find("No teeth are possible for the mesh sun_planet"), std::string::npos);
  EXPECT_NE(fault.find("A centre distance from 44."), std::string::npos) << fault;
  EXPECT_EQ(first_fault(set_of(20, 25, 70, 46.0)), "");
  EXPECT_EQ(first_fault(set_of(20, 25, 70)), "");
}

}  // namespace
}  // namespace gearwright
