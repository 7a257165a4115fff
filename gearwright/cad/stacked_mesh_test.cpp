// Laws of the meshes of solids with several gears: (1) the mesh is one closed oriented part, (2) it
// encloses the volume of its gears and of the cylinders between them, (3) every gear has the same
// vertices as its own mesh, raised and turned.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/mesh_topology.hpp"
#include "gearwright/cad/testing/modified_bodies.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/testing/stacked_bodies.hpp"

namespace gearwright {
namespace {

using testing::exact_volume;
using testing::herringbone;
using testing::sample_body;
using testing::stacked;

struct StackCase {
  std::string name;
  ToothedBody body;
};

std::vector<StackCase> stack_cases() {
  const ToothedBody spur = sample_body({});
  const ToothedBody helical = sample_body({.teeth = 24, .beta = 0.3});
  const ToothedBody small = sample_body({.teeth = 14, .beta = -0.4, .face_width = 30});
  ToothedBody bored = helical;
  bored.bore = Bore{10.0};
  ToothedBody keyed = helical;
  keyed.bore = Bore{9.0, 3.0, 1.4};
  const ToothedBody grooved = herringbone(4.0, 0.5);
  const double groove = grooved.two_helices->groove_radius;
  const ToothedBody big = sample_body({.teeth = 40});
  const ToothedBody relieved = testing::modified_gears(4.0).front().body;
  return {{"spur and helical", stacked(spur, small, 4.0, 9.0, 0.7)},
          {"wider above", stacked(small, helical, 0.5, 9.0, -0.3)},
          {"bore", stacked(bored, small, 4.0, 9.0, 0.7)},
          {"keyway", stacked(keyed, small, 4.0, 9.0, 2.0)},
          {"thin neck", stacked(bored, small, 4.0, 5.01, 0.7)},
          {"three gears", stacked(stacked(spur, small, 4.0, 9.0, 0.7), helical, 3.0, 8.0, 1.1)},
          {"double-helical", stacked(herringbone(4.0, 0.5), small, 2.0, 9.0, 0.2)},
          {"neck of the groove's radius", stacked(grooved, big, 2.0, groove, 0.2)},
          {"double-helical above", stacked(small, grooved, 2.0, 9.0, 0.2)},
          {"modified", stacked(small, relieved, 2.0, 9.0, 0.4)}};
}

TriangleMesh stacked_mesh(const ToothedBody& body) {
  auto mesh = tessellate(body, {.chord_tolerance_mm = 0.005});
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message());
  return mesh ? std::move(mesh).take() : TriangleMesh{};
}

TEST(StackedMesh, IsAClosedOrientedManifoldOfOnePart) {
  for (const auto& [name, body] : stack_cases()) {
    const testing::Topology found = testing::topology(stacked_mesh(body));
    EXPECT_TRUE(found.closed) << name;
    EXPECT_EQ(found.parts, 1) << name;
    EXPECT_EQ(found.unused, 0u) << name;
    EXPECT_EQ(found.euler, body.bore ? 0 : 2) << name;
  }
}

TEST(StackedMesh, EnclosesItsGearsAndNecks) {
  for (const auto& [name, body] : stack_cases()) {
    if (name == "modified") continue;  // its volume is smaller by the removed material
    const double height = body.gears().back().top() - body.gears().front().bottom();
    double walls = 0.0;
    for (const SolidGear& gear : body.gears()) {
      // The outline is shorter than its tip circle and twice the height of all flanks. The neck and
      // the bore are narrower.
      const double tip = gear.body->outline.arcs.back().end_point.norm();
      const double root = gear.body->outline.arcs.front().begin_point.norm();
      walls += (4 * kPi * tip + 4 * (tip - root) * gear.body->outline.teeth) * height;
    }
    const double exact = exact_volume(body);
    EXPECT_NEAR(metal_volume(body) / exact, 1.0, 1e-14) << name;
    EXPECT_NEAR(mesh_volume(stacked_mesh(body)), exact, 0.005 * walls) << name;
  }
}

TEST(StackedMesh, HasEveryGearInItsPlace) {
  for (const auto& [name, body] : stack_cases()) {
    const TriangleMesh whole = stacked_mesh(body);
    const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
    std::vector<std::array<double, 3>> all;
    for (const Vec3& p : whole.vertices) all.push_back(key(p));
    std::sort(all.begin(), all.end());
    for (const SolidGear& gear : body.gears()) {
      ToothedBody one = *gear.body;
      one.above.clear();
      const TriangleMesh alone = stacked_mesh(one);
      const double root = gear.body->outline.arcs.front().begin_point.norm();
      const Eigen::Isometry3d place =
          Eigen::Translation3d(0.0, 0.0, gear.height) * Eigen::AngleAxisd(gear.turn, Vec3::UnitZ());
      int compared = 0;
      for (const Vec3& p : alone.vertices) {
        if (p.head<2>().norm() < root - 1e-6) continue;  // a point of a cap or of the bore
        const Vec3 at = place * p;
        constexpr double kRounding_mm = 1e-9;
        auto it = std::lower_bound(all.begin(), all.end(),
                                   std::array<double, 3>{at.x() - kRounding_mm, -1e300, -1e300});
        bool found = false;
        for (; it != all.end() && (*it)[0] <= at.x() + kRounding_mm && !found; ++it)
          found = (Vec3((*it)[0], (*it)[1], (*it)[2]) - at).norm() < 2 * kRounding_mm;
        ASSERT_TRUE(found) << name << " " << at.transpose();
        ++compared;
      }
      EXPECT_GT(compared, 1000) << name;
    }
  }
}

}  // namespace
}  // namespace gearwright
