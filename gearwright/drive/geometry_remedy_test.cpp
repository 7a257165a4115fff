// Laws: (1) both ends of a stated range make a drive without faults, and a value slightly outside
// the range does not; (2) the faults of a drive state the range; (3) a backlash is possible up to
// the stated limit, and not 0.002 mm beyond it.
#include "gearwright/drive/geometry_remedy.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/drive.hpp"
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

Drive with_backlash_in(DriveGraph graph, const std::vector<double>& backlash) {
  for (std::size_t m = 0; m < backlash.size(); ++m) graph.meshes[m].backlash = backlash[m];
  return testing::taken(make_drive({.graph = graph, .remedies = true}));
}

// Reads the limit of each fault, which must have these words and name its mesh. The mesh runs with
// the limit as backlash, but not with a backlash that exceeds the limit by `beyond`.
void expect_limits(const DriveGraph& graph, const std::vector<double>& backlash,
                   const std::vector<std::size_t>& at_fault, const std::string& words,
                   double beyond) {
  const Drive drive = with_backlash_in(graph, backlash);
  const auto& faults = drive.geometry.faults;
  ASSERT_EQ(faults.size(), at_fault.size());
  for (std::size_t i = 0; i < at_fault.size(); ++i) {
    const std::size_t m = at_fault[i];
    const std::string& text = faults[i].message;
    EXPECT_FALSE(drive.geometry.touches(m));
    EXPECT_TRUE(
        text.starts_with("The mesh " + graph.meshes[m].name + " cannot have a backlash of "))
        << text;
    EXPECT_EQ(text.find("gear1."), std::string::npos) << text;
    EXPECT_EQ(text.find("gear2."), std::string::npos) << text;
    const std::size_t at = text.find(words);
    ASSERT_NE(at, std::string::npos) << text;
    const double limit = std::strtod(text.c_str() + at + words.size(), nullptr);
    std::vector<double> changed = backlash;
    changed[m] = limit;
    const Drive good = with_backlash_in(graph, changed);
    ASSERT_TRUE(good.geometry.touches(m)) << text;
    EXPECT_NEAR(good.geometry.stated_backlash(m)->normal, limit, 1e-9);
    changed[m] = limit + beyond;
    EXPECT_FALSE(with_backlash_in(graph, changed).geometry.touches(m)) << text;
  }
}

DriveGraph rack_graph(double dedendum = 1.25) {
  CylindricalSpec spec;
  spec.normal_module = 2.0;
  StraightRack rack;
  rack.dedendum = dedendum;
  rack.root_fillet_radius = 0.25;
  spec.rack = rack;
  DriveGraph graph;
  graph.bodies = {{"s", {}, 1, {}}, {"bar", {}, 1, {}}};
  graph.gears = {{"p", 0, 20, {}, spec, {}}, {"r", 1, 0, RackBar{}, {}, {}}};
  graph.meshes = {{"p_r", {0, 1}, {}, {}}};
  graph.inputs = {0};
  graph.output = 1;
  return graph;
}

TEST(GeometryRemedy, ABacklashThatIsTooGreatNamesItsMesh) {
  const std::string most = " At most ";
  DriveGraph pair = rack_graph();
  pair.gears[1] = {"w", 1, 58, {}, pair.gears[0].spec, {}};
  for (const double backlash : {4.0, 9.0})
    expect_limits(rack_graph(), {backlash}, {0}, most, 0.002);
  for (const double backlash : {7.0, 30.0}) expect_limits(pair, {backlash}, {0}, most, 0.002);
  expect_limits(set_of(20, 25, 70), {9.0, 9.0}, {0, 1}, most, 0.002);
  // Only the mesh with the sun is at fault.
  expect_limits(set_of(20, 25, 70), {9.0, 0.1}, {0}, most, 0.002);
  EXPECT_TRUE(with_backlash_in(set_of(20, 25, 70), {0.1, 0.2}).geometry.faults.empty());
}

TEST(GeometryRemedy, TheMessageNamesTheMeanOfABand) {
  DriveGraph graph = rack_graph();
  graph.meshes.front().backlash_is_mean = true;
  const Drive drive = with_backlash_in(graph, {5.0});
  ASSERT_EQ(drive.geometry.faults.size(), 1u);
  EXPECT_TRUE(drive.geometry.faults[0].message.starts_with(
      "The mesh p_r cannot have a mean backlash of 5 mm"))
      << drive.geometry.faults[0].message;
}

// At too great a centre distance, the teeth would have to be so thick that the spaces close.
TEST(GeometryRemedy, ABacklashThatIsTooSmallNamesItsMesh) {
  DriveGraph deep = rack_graph(1.6);
  deep.meshes.front().center_distance = 23.2;
  expect_limits(deep, {0.0}, {0}, " At least ", -0.002);
}

}  // namespace
}  // namespace gearwright
