#include "gearwright/cad/mesh_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

MeshPart gear_part(const std::string& name, double beta) {
  ToothedBody body = testing::sample_body({.teeth = 12, .beta = beta, .tip_radius = 0.2});
  body.bore = Bore{8.0, 3.0, 1.4};
  return {name, tessellate(body, {.chord_tolerance_mm = 0.02}).value(), {}};
}

Eigen::Vector3f vector_at(const std::string& bytes, std::size_t offset) {
  Eigen::Vector3f v;
  std::memcpy(v.data(), bytes.data() + offset, 12);
  return v;
}

TEST(Stl, HoldsEveryTriangleWithItsNormal) {
  const MeshPart part = gear_part("gear1", 0.3);
  const std::string bytes = stl_bytes({part});
  const std::size_t count = part.mesh.triangles.size();
  ASSERT_EQ(bytes.size(), 84 + 50 * count);
  std::uint32_t named = 0;
  std::memcpy(&named, bytes.data() + 80, 4);
  EXPECT_EQ(named, count);
  EXPECT_EQ(bytes.substr(0, 33), "Gearwright, binary STL, mm: gear1");
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = 84 + 50 * i;
    const Eigen::Vector3f n = vector_at(bytes, at);
    const Eigen::Vector3f a = vector_at(bytes, at + 12);
    const Eigen::Vector3f b = vector_at(bytes, at + 24);
    const Eigen::Vector3f c = vector_at(bytes, at + 36);
    EXPECT_EQ(a, part.mesh.vertices[part.mesh.triangles[i][0]].cast<float>());
    const Vec3 facet = (b - a).cast<double>().cross((c - a).cast<double>());
    ASSERT_GT(facet.norm(), 0.0) << i;
    EXPECT_LT((facet.normalized() - n.cast<double>()).norm(), 1e-6);
    EXPECT_EQ(bytes[at + 48], 0);
    EXPECT_EQ(bytes[at + 49], 0);
  }
}

TEST(Stl, PutsPartsInTheirPlaces) {
  MeshPart first = gear_part("gear1", 0.3);
  MeshPart second = gear_part("gear2", -0.3);
  second.pose =
      SolidPose(Eigen::Translation3d(30.0, 0.0, 0.0) * Eigen::AngleAxisd(0.5, Vec3(0.0, 0.6, 0.8)));
  const std::string bytes = stl_bytes({first, second});
  const std::size_t ahead = first.mesh.triangles.size();
  ASSERT_EQ(bytes.size(), 84 + 50 * (ahead + second.mesh.triangles.size()));
  const Vec3 corner = second.mesh.vertices[second.mesh.triangles[0][1]];
  EXPECT_EQ(vector_at(bytes, 84 + 50 * ahead + 24),
            (second.pose * Point<SolidFrame>{corner}).r.cast<float>());
}

TEST(Stl, LongNamesStayInTheHeader) {
  const MeshPart part = gear_part(std::string(200, 'x'), 0.0);
  EXPECT_EQ(stl_bytes({part}).size(), 84 + 50 * part.mesh.triangles.size());
}

TEST(Stl, SameInputSameBytes) {
  EXPECT_EQ(stl_bytes({gear_part("a", 0.2)}), stl_bytes({gear_part("a", 0.2)}));
}

}  // namespace
}  // namespace gearwright
