#include "gearwright/cad/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/mesh_topology.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/testing/stacked_bodies.hpp"

namespace gearwright {
namespace {

using testing::exact_volume;
using testing::few_tooth_body;
using testing::ring_body;
using testing::sample_body;
using testing::Topology;
using testing::topology;
using testing::undercut_body;

struct MeshCase {
  std::string name;
  ToothedBody body;
};

std::vector<MeshCase> mesh_cases() {
  std::vector<MeshCase> all;
  all.push_back({"spur 20", sample_body({})});
  all.push_back({"helical right", sample_body({.teeth = 24, .beta = 0.3})});
  all.push_back({"helical left", sample_body({.teeth = 24, .beta = -0.5, .face_width = 60})});
  all.push_back({"pointed", sample_body({.teeth = 25, .beta = 0.3, .pointed = true})});
  all.push_back({"full radius", sample_body({.teeth = 31, .full_radius_root = true})});
  all.push_back({"chamfer", sample_body({.teeth = 40, .beta = 0.2, .chamfer = 0.3})});
  all.push_back({"undercut 9", undercut_body(9, 2, 1.25, 0.8, 0.01, 12)});
  all.push_back({"undercut 5", undercut_body(5, 2, 1.1, 0.5, -0.02, 12)});
  all.push_back({"undercut 6 deep", undercut_body(6, 2, 1.4, 0.6, 0.0, 12)});
  for (const int z : {1, 2, 3}) {
    all.push_back({"few spur " + std::to_string(z), few_tooth_body(z, 4, 0.0, 10)});
    all.push_back({"few screw " + std::to_string(z), few_tooth_body(z, 4, 0.15, 30)});
  }
  all.push_back({"ring spur", ring_body(40, 2, 0.0, 15, 95)});
  all.push_back({"ring helical", ring_body(36, 2, 0.012, 15, 85)});
  all.push_back({"two teeth, rounded tips", testing::two_teeth_body()});
  all.push_back({"one tooth, rounded tip", testing::one_tooth()});
  all.push_back({"wheel cut by two teeth", testing::cut_wheel()});
  all.push_back({"ring cut by a pinion", testing::cut_ring()});
  all.push_back({"circular arcs", testing::arc_pinion()});
  all.push_back({"double circular arcs", testing::double_arcs()});
  for (const double gap : {0.0, 4.0}) {
    const std::string name = gap > 0.0 ? ", gap" : "";
    all.push_back({"herringbone" + name, testing::herringbone(gap)});
    all.push_back({"herringbone ring" + name, testing::herringbone_ring(gap)});
  }
  all.push_back({"staggered", testing::herringbone(4.0, 0.5)});
  all.push_back({"staggered ring", testing::herringbone_ring(4.0, 0.5)});
  const std::size_t solid = all.size();
  for (std::size_t i = 0; i < solid; ++i) {
    if (all[i].body.outline.teeth < 0) continue;
    MeshCase bored = all[i];
    const double root = bored.body.limit_within(bored.body.outline.arcs.front().begin_point.norm());
    bored.name += " bore";
    bored.body.bore = Bore{1.3 * root};
    all.push_back(bored);
    bored.name += " keyway";
    bored.body.bore = Bore{1.1 * root, 0.4 * root, 0.2 * root};
    all.push_back(bored);
    bored.name += " thin";  // only 0.003 mm of material remains at the corners of the keyway
    const double room = root - 0.003;
    bored.body.bore = Bore{2 * (std::sqrt(room * room - 0.04 * root * root) - 0.1 * root),
                           0.4 * root, 0.1 * root};
    all.push_back(bored);
  }
  return all;
}

TriangleMesh mesh_of(const ToothedBody& body, double tolerance = 0.005) {
  auto mesh = tessellate(body, {.chord_tolerance_mm = tolerance});
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message());
  return mesh ? std::move(mesh).take() : TriangleMesh{};
}

double perimeter(const Outline& outline) {
  double sum = 0.0;
  for (const Arc& arc : outline.arcs) {
    for (int i = 0; i < 200; ++i) sum += (arc.point((i + 1) / 200.0) - arc.point(i / 200.0)).norm();
  }
  return 2.0 * sum * std::abs(outline.teeth);
}

// Returns the angle by which the section is turned at the height z.
double turn_at(const ToothedBody& body, double z) {
  if (!body.two_helices) return body.twist * z;
  return body.twist * std::abs(z) + (z < 0.0 ? body.two_helices->stagger : 0.0);
}

TEST(Mesh, IsAClosedOrientedManifoldOfOnePart) {
  for (const auto& [name, body] : mesh_cases()) {
    const TriangleMesh mesh = mesh_of(body);
    const Topology found = topology(mesh);
    EXPECT_TRUE(found.closed) << name;
    EXPECT_EQ(found.parts, 1) << name;
    EXPECT_EQ(found.unused, 0u) << name;
    EXPECT_EQ(found.euler, body.bore ? 0 : 2) << name;  // torus or ball
  }
}

TEST(Mesh, EnclosesSectionAreaTimesFaceWidth) {
  for (const auto& [name, body] : mesh_cases()) {
    for (const double tolerance : {0.02, 0.005, 0.0005}) {
      const double exact = exact_volume(body);
      double walls = perimeter(body.outline);
      if (body.bore) walls += kPi * body.bore->diameter;
      // The surface deviates by less than the tolerance everywhere.
      EXPECT_NEAR(mesh_volume(mesh_of(body, tolerance)), exact, tolerance * walls * body.face_width)
          << name;
    }
  }
}

TEST(Mesh, VolumeConvergesAsTheTolerance) {
  // The chord errors are proportional to the tolerance, because the step is proportional to its
  // square root. The error of the volume therefore decreases by a factor of about 100 with a
  // tolerance 100 times smaller.
  const ToothedBody body = sample_body({.teeth = 24, .beta = 0.3});
  const double exact = metal_area(body) * body.face_width;
  const double coarse = std::abs(mesh_volume(mesh_of(body, 0.01)) / exact - 1.0);
  const double fine = std::abs(mesh_volume(mesh_of(body, 0.0001)) / exact - 1.0);
  EXPECT_GT(coarse, 1e-5);
  EXPECT_GT(coarse / fine, 50.0);
  EXPECT_LT(coarse / fine, 200.0);
}

// Greatest distance of the wall triangles from the exact section, measured in the plane of the
// section after the triangles are turned back by the screw motion. It is not less than the distance
// from the exact surface. Tooth 0 and the adjacent halves of both spaces are measured.
double wall_deviation(const ToothedBody& body, const TriangleMesh& mesh) {
  constexpr int kPoints = 600;  // per arc; a chord deviates from an arc of 5 mm radius by 1e-7 mm
  // Plain numbers, because the tests are compiled without optimisation: (x, y) + s (dx, dy),
  // 0 ≤ s ≤ 1.
  struct Segment {
    double x, y, dx, dy, square;
  };
  std::vector<Segment> segments;
  for (const Arc& arc : body.outline.arcs) {
    const std::vector<Vec2> points = sample(arc, kPoints);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec2 d = points[i + 1] - points[i];
      segments.push_back({points[i].x(), points[i].y(), d.x(), d.y(), d.squaredNorm()});
    }
  }
  const double pitch_half = kPi / std::abs(body.outline.teeth);
  const double rim = body.outline.teeth < 0 ? body.bore->diameter / 2.0 : 1e300;
  const double bore = body.bore && body.outline.teeth > 0
                          ? std::hypot(body.bore->keyway_width / 2.0,
                                       body.bore->diameter / 2.0 + body.bore->keyway_depth)
                          : 0.0;
  const double end = body.face_width / 2.0;
  const double groove = body.grooved() ? body.two_helices->groove_radius : -1.0;
  double worst = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if (a.z() == b.z() && b.z() == c.z()) continue;  // a cap
    if (std::abs(a.head<2>().norm() - groove) < 1e-9 * end) continue;
    if (a.head<2>().norm() < bore * (1 + 1e-9)) continue;
    // The screw motion maps each level to the next, so the lowest quarter of the face represents
    // the whole face.
    if (std::min({a.z(), b.z(), c.z()}) > -end / 2.0) continue;
    const bool on_rim = std::abs(a.head<2>().norm() - rim) < 1e-9 * rim;
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; i + j <= 4; ++j) {
        const Vec3 p = (i * a + j * b + (4 - i - j) * c) / 4.0;
        const double back = -turn_at(body, p.z());
        Vec2 q(std::cos(back) * p.x() - std::sin(back) * p.y(),
               std::sin(back) * p.x() + std::cos(back) * p.y());
        if (std::abs(std::atan2(q.y(), q.x())) > pitch_half) continue;
        if (on_rim) {
          worst = std::max(worst, std::abs(q.norm() - rim));
          continue;
        }
        q.y() = std::abs(q.y());
        const double qx = q.x(), qy = q.y();
        double nearest = 1e300;
        for (const Segment *part = segments.data(), *end_part = part + segments.size();
             part != end_part; ++part) {
          const double x = qx - part->x, y = qy - part->y;
          double s = (x * part->dx + y * part->dy) / part->square;
          s = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
          const double ex = x - s * part->dx, ey = y - s * part->dy;
          const double square = ex * ex + ey * ey;
          if (square < nearest) nearest = square;
        }
        worst = std::max(worst, std::sqrt(nearest));
      }
    }
  }
  return worst;
}

TEST(Mesh, StaysWithinTheChordToleranceAndUsesIt) {
  for (const auto& [name, body] : mesh_cases()) {
    // The walls of the teeth are the same as without a bore.
    if (name.find("bore") != std::string::npos) continue;
    const double tolerance = body.twist == 0.0 ? 0.005 : 0.02;
    const double deviation = wall_deviation(body, mesh_of(body, tolerance));
    EXPECT_LE(deviation, tolerance) << name;
    // The mesh is also not finer than necessary. On helical walls, the bound holds for either
    // diagonal, and the mesh uses the better one, so its deviation is smaller.
    EXPECT_GE(deviation, 0.25 * tolerance) << name;
  }
}

TEST(Mesh, BoreKeepsItsTolerance) {
  const ToothedBody body = [] {
    ToothedBody b = sample_body({});
    b.bore = Bore{20.0, 6.0, 2.8};
    return b;
  }();
  const TriangleMesh mesh = mesh_of(body);
  double lowest = 1e300;
  double highest = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 a = mesh.vertices[t[i]].head<2>();
      const Vec2 b = mesh.vertices[t[(i + 1) % 3]].head<2>();
      if (std::abs(a.norm() - 10.0) > 1e-9 || std::abs(b.norm() - 10.0) > 1e-9) continue;
      lowest = std::min(lowest, (0.5 * (a + b)).norm());
    }
    for (const std::uint32_t i : t) {
      const Vec2 p = mesh.vertices[i].head<2>();
      if (std::abs(p.x()) == 3.0) highest = std::max(highest, p.y());
    }
  }
  EXPECT_GE(lowest, 10.0 - 0.005);
  EXPECT_LT(lowest, 10.0 - 0.002);
  EXPECT_EQ(highest, 12.8);  // height of the keyway floor, reached only at its corners
}

TEST(Mesh, ToothKIsToothZeroTurned) {
  const ToothedBody body = sample_body({.teeth = 23, .beta = 0.3});
  const TriangleMesh mesh = mesh_of(body);
  std::size_t ring = 0;
  while (mesh.vertices[ring].z() == mesh.vertices[0].z()) ++ring;
  ASSERT_EQ(ring % 23, 0u);
  const std::size_t run = ring / 23;
  for (int k = 0; k < 23; ++k) {
    const auto [s, c] = sincos_turn(k, 23);
    for (std::size_t i = 0; i < run; ++i) {
      const Vec3& p = mesh.vertices[i];
      const Vec3& q = mesh.vertices[static_cast<std::size_t>(k) * run + i];
      ASSERT_EQ(q, Vec3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z())) << k << " " << i;
    }
  }
}

TEST(Mesh, GrowsInProportionToTheTeeth) {
  // The same half tooth occurs 20 and 40 times. A tooth has 2 n columns of the wall, and a column
  // has 2 triangles.
  const auto counts = [](int copies) {
    ToothedBody body = few_tooth_body(3, 4, 0.0, 10);
    Outline& o = body.outline;
    const double r = 20.0;
    const auto circle = std::make_shared<testing::SampleCircle>(r);
    o = {copies, {}};
    testing::append(o, ArcName::root_land, circle, kPi / copies, 0.0);
    return mesh_of(body, 0.005);
  };
  EXPECT_EQ(mesh_of(sample_body({.teeth = 20})).triangles.size() % 40, 0u);
  // The number of points of a plain cylinder follows from the step √(8ε/κ) = √(8·0.9·0.005·20) =
  // 0.8485 mm on the circumference 2π·20 mm.
  for (const int copies : {20, 40}) {
    const std::size_t n = static_cast<std::size_t>(std::ceil(kPi * 20 / copies / 0.848528));
    const std::size_t z = static_cast<std::size_t>(copies);
    const TriangleMesh mesh = counts(copies);
    const std::size_t walls = 2 * 2 * n * z;
    // triangles of a cap between the outline and the 2z points of the hub circle
    const std::size_t ring = 2 * n * z + 2 * z;
    const std::size_t fan = 2 * z;
    EXPECT_EQ(mesh.triangles.size(), walls + 2 * (ring + fan)) << copies;
  }
  // For a whole gear, the mesh size per tooth does not increase with the number of teeth.
  const auto per_tooth = [](int z) {
    return static_cast<double>(mesh_of(sample_body({.teeth = z, .beta = 0.2})).triangles.size()) /
           z;
  };
  EXPECT_LE(per_tooth(400), 1.6 * per_tooth(40));
}

TEST(Mesh, MirroredHandMirrorsTheMesh) {
  const ToothedBody right = sample_body({.teeth = 24, .beta = 0.3});
  ToothedBody left = right;
  left.twist = -right.twist;
  const TriangleMesh a = mesh_of(right);
  const TriangleMesh b = mesh_of(left);
  EXPECT_EQ(a.triangles.size(), b.triangles.size());
  EXPECT_NEAR(mesh_volume(a), mesh_volume(b), 1e-11 * mesh_volume(a));
}

TEST(Mesh, ShadedTwinHasTheExactNormals) {
  for (const auto& [name, body] : mesh_cases()) {
    const TriangleMesh mesh = mesh_of(body);
    ASSERT_EQ(mesh.triangles.size(), mesh.shaded_triangles.size()) << name;
    ASSERT_EQ(mesh.normals.size(), mesh.shaded_vertices.size()) << name;
    const testing::Shading found = testing::shading(mesh);
    EXPECT_TRUE(found.same_corners) << name;
    EXPECT_LT(found.length_error, 1e-12) << name;
    // The normal of a facet and the surface normals at its corners differ at most by the change of
    // direction across the facet. This change is at most 0.26 rad along the section and 0.26 rad
    // between two levels.
    EXPECT_GT(found.least_cosine, std::cos(2 * 0.26)) << name;
  }
}

TEST(Mesh, SameInputSameMesh) {
  const ToothedBody body = sample_body({.teeth = 24, .beta = 0.3});
  const TriangleMesh a = mesh_of(body);
  const TriangleMesh b = mesh_of(body);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace gearwright
