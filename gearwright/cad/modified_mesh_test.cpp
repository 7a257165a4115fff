#include "gearwright/cad/modified_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/mesh_topology.hpp"
#include "gearwright/cad/testing/modified_bodies.hpp"

namespace gearwright {
namespace {

using testing::external;
using testing::FlankReading;
using testing::internal;
using testing::modified;
using testing::modified_gears;
using testing::ModifiedGear;
using testing::read_flank;

constexpr double kMeshTolerance_mm = 0.005;

TriangleMesh tessellated(const ToothedBody& body, double tolerance = kMeshTolerance_mm) {
  auto mesh = tessellate(body, {.chord_tolerance_mm = tolerance});
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message());
  return mesh ? std::move(mesh).take() : TriangleMesh{};
}

// True if the foot of the normal through a wall point lies on the flank, away from its two ends.
bool on_flank(const ModifiedGear& g, const Vec3& p, const FlankReading& at) {
  const double tip = g.gear.tip_diameter / 2;
  return at.foot > 0.01 && at.foot < 1.0 && std::abs(p.head<2>().norm() - tip) > 1e-6 &&
         std::abs(at.depth) < 0.5;
}

TEST(ModifiedMesh, vertices_lie_on_the_modified_flank) {
  for (const double size : {1.0, 6.0}) {
    for (const ModifiedGear& g : modified_gears(size)) {
      const TriangleMesh mesh = tessellated(g.body);
      std::array<int, 2> seen{};
      for (const Vec3& p : mesh.vertices) {
        const FlankReading at = read_flank(g, p);
        if (!on_flank(g, p, at)) continue;
        ++seen[at.left ? 1 : 0];
        EXPECT_NEAR(at.error, 0.0, 1e-9) << g.name << " " << p.transpose();
      }
      EXPECT_GT(seen[0], 1000) << g.name;
      EXPECT_GT(seen[1], 1000) << g.name;
    }
  }
}

TEST(ModifiedMesh, both_halves_of_a_double_helical_gear_are_modified) {
  for (const ModifiedGear& g : testing::modified_double_helical_gears()) {
    const TriangleMesh mesh = tessellated(g.body);
    std::array<std::array<int, 2>, 2> seen{};
    for (const Vec3& p : mesh.vertices) {
      const Vec3 q = testing::in_half(g, p);
      if (std::abs(q.z()) > g.gear.spec.face_width / 2 + 1e-9) continue;  // in the groove
      const FlankReading at = read_flank(g, q);
      if (!on_flank(g, q, at)) continue;
      ++seen[at.left ? 1 : 0][p.z() < 0 ? 1 : 0];
      EXPECT_NEAR(at.error, 0.0, 1e-9) << g.name << " " << p.transpose();
    }
    for (const auto& side : seen)
      for (const int count : side) EXPECT_GT(count, 1000) << g.name;
    const testing::Topology shape = testing::topology(mesh);
    EXPECT_TRUE(shape.closed) << g.name;
    EXPECT_EQ(shape.parts, 1) << g.name;
    EXPECT_EQ(shape.euler, g.body.bore ? 0 : 2) << g.name;
    EXPECT_EQ(shape.unused, 0u) << g.name;
    ToothedBody plain = g.body;
    plain.modified = nullptr;
    const double removed =
        mesh_volume(tessellated(plain, 5e-4)) - mesh_volume(tessellated(g.body, 5e-4));
    EXPECT_NEAR(removed / (2 * g.body.modified->removed_volume(g.gear.spec.face_width)), 1.0, 0.02)
        << g.name;
  }
}

TEST(ModifiedMesh, facets_stay_within_the_tolerance) {
  for (const ModifiedGear& g : modified_gears(3.0)) {
    const TriangleMesh mesh = tessellated(g.body);
    const double end = g.body.face_width / 2;
    double worst = 0.0;
    for (const Triangle& t : mesh.triangles) {
      const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      if (std::abs(a.z()) == end && a.z() == b.z() && b.z() == c.z()) continue;  // a cap
      if (!on_flank(g, a, read_flank(g, a)) || !on_flank(g, b, read_flank(g, b)) ||
          !on_flank(g, c, read_flank(g, c)))
        continue;
      for (const Vec3& p : {Vec3((a + b + c) / 3), Vec3((a + b) / 2), Vec3((b + c) / 2)})
        worst = std::max(worst, std::abs(read_flank(g, p).error));
    }
    EXPECT_GT(worst, 0.1 * kMeshTolerance_mm) << g.name;
    EXPECT_LE(worst, kMeshTolerance_mm) << g.name;
  }
}

TEST(ModifiedMesh, is_closed) {
  for (const ModifiedGear& g : modified_gears(6.0)) {
    const TriangleMesh mesh = tessellated(g.body);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& t : mesh.triangles)
      for (std::size_t i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, n] : uses) {
      EXPECT_EQ(n, 1) << g.name;
      EXPECT_EQ(uses.count({edge.second, edge.first}), 1u) << g.name;
    }
    ASSERT_EQ(mesh.shaded_triangles.size(), mesh.triangles.size());
    ASSERT_EQ(mesh.normals.size(), mesh.shaded_vertices.size());
  }
}

// The normals for shading point out of their triangles. They differ from the normals of the
// triangles by at most 0.26 rad, the permitted change over a facet, plus half of 0.075 rad, the
// angle at the edge where an end relief begins. On this edge, the normal is the mean of both sides.
TEST(ModifiedMesh, normals_are_those_of_the_surface) {
  for (const ModifiedGear& g : modified_gears(6.0)) {
    const TriangleMesh mesh = tessellated(g.body, 0.001);
    double least = 1.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle &t = mesh.triangles[i], &s = mesh.shaded_triangles[i];
      const Vec3& a = mesh.vertices[t[0]];
      const Vec3 n = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
      if (n.norm() < 1e-6) continue;  // in a sliver, rounding of the corners turns the normal
      for (const std::uint32_t corner : s)
        least = std::min(least, mesh.normals[corner].dot(n.normalized()));
    }
    EXPECT_GT(least, std::cos(0.26 + 0.0375)) << g.name;
  }
}

// Computes ∫ c dA over both flanks of all teeth, with dA = L dξ dz/cos β_b.
double removed_from_flanks(const ModifiedGear& g) {
  const auto& ref = g.gear.reference();
  const double r_b = ref.base_diameter / 2, b = g.gear.spec.face_width;
  const auto roll = [&](double rho) { return std::sqrt(rho * rho - r_b * r_b); };
  const double L_f = roll(*g.gear.root_form_radius()), L_a = roll(g.gear.tip_form_radius());
  constexpr int kSteps = 400;
  double sum = 0.0;
  for (const bool left : {false, true})
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < kSteps; ++j) {
        const double L = L_f + (L_a - L_f) * (i + 0.5) / kSteps, z = b * ((j + 0.5) / kSteps - 0.5);
        sum += testing::defined_removal(g, left, L, z) * L;
      }
  const double cell = std::abs(L_a - L_f) / kSteps * b / kSteps;
  return std::abs(g.gear.spec.teeth) * sum * cell / (r_b * std::cos(ref.base_helix_angle));
}

// A tip relief does not change the fillet, so only the flanks contribute. The modified flank does
// not end at the unmodified tip edge. It continues beyond it by c sin α to the tip cylinder. The
// integral does not include this part, which is 0.6 % here.
TEST(ModifiedMesh, removes_the_integral_of_the_modification) {
  for (Gear gear : {external(17, 0.0), external(21, 20.0), external(17, -15.0)}) {
    const double root = *gear.root_form_radius(), tip = gear.tip_form_radius();
    FlankModifications m;
    m.tip_relief = {0.03, 2 * (root + 0.4 * (tip - root)), ReliefShape::linear};
    const ModifiedGear g = modified("relieved", std::move(gear), {m, m});
    ToothedBody plain = g.body;
    plain.modified = nullptr;
    const double removed =
        mesh_volume(tessellated(plain, 1e-4)) - mesh_volume(tessellated(g.body, 1e-4));
    const double wanted = removed_from_flanks(g);
    EXPECT_GT(wanted, 0.0);
    EXPECT_NEAR(removed / wanted, 1.0, 0.01);
    EXPECT_NEAR(g.body.modified->removed_volume(g.body.face_width) / wanted, 1.0, 0.01);
  }
}

// Crowning also moves the fillets. More is therefore removed than from the flanks alone, but less
// than if the flanks reached down to the root.
TEST(ModifiedMesh, crowning_removes_at_the_faces) {
  for (Gear gear : {external(17, 0.0), external(21, -20.0), internal(0.0), internal(20.0)}) {
    const bool ring = gear.spec.teeth < 0;
    FlankModifications m;
    m.lead_crowning = 0.02;
    const ModifiedGear g = modified("crowned", std::move(gear), {m, m},
                                    ring ? std::optional(Bore{118.0}) : std::nullopt);
    const double flanks = removed_from_flanks(g);
    const double removed = g.body.modified->removed_volume(g.body.face_width);
    EXPECT_GT(removed, flanks);
    EXPECT_LT(removed, 1.5 * flanks);
    ToothedBody plain = g.body;
    plain.modified = nullptr;
    EXPECT_NEAR(
        (mesh_volume(tessellated(plain, 1e-4)) - mesh_volume(tessellated(g.body, 1e-4))) / removed,
        1.0, 0.01);
    for (const Vec3& p : tessellated(g.body).vertices) {
      const FlankReading at = read_flank(g, p);
      if (!on_flank(g, p, at)) continue;
      EXPECT_GT(at.depth, -1e-12);
      const bool face = std::abs(p.z()) == g.body.face_width / 2;
      EXPECT_NEAR(face ? at.depth : 0.02, 0.02, 1e-4);
    }
  }
}

TEST(ModifiedMesh, a_crowning_below_the_tolerance_is_there) {
  FlankModifications m;
  m.lead_crowning = 0.003;
  const ModifiedGear g = modified("crowned", external(17, 0.0), {m, m});
  const TriangleMesh mesh = tessellated(g.body);
  double least = 1.0, greatest = 0.0;
  for (const Vec3& p : mesh.vertices) {
    const FlankReading at = read_flank(g, p);
    if (!on_flank(g, p, at)) continue;
    least = std::min(least, at.depth);
    greatest = std::max(greatest, at.depth);
  }
  EXPECT_NEAR(least, 0.0, 2e-4);
  EXPECT_NEAR(greatest, 0.003, 1e-9);
}

TEST(ModifiedMesh, lands_stay_as_cut) {
  for (const ModifiedGear& g : modified_gears(6.0)) {
    double inner = 1e9, outer = 0.0;
    for (const Vec3& p : tessellated(g.body).vertices) {
      if (read_flank(g, p).foot < -10) continue;
      const double rho = p.head<2>().norm();
      const bool ring = g.gear.spec.teeth < 0;
      if (ring && rho > g.gear.root_diameter / 2 + 1) continue;  // the rim
      inner = std::min(inner, rho);
      outer = std::max(outer, rho);
    }
    const double tip = g.body.outline.arcs.back().end_point.norm();
    EXPECT_NEAR(g.gear.spec.teeth < 0 ? inner : outer, tip, 1e-9) << g.name;
  }
}

// Where a linear relief begins, the flank has an edge. Its vertices have one normal for each side,
// and the two differ by the slope of the relief.
TEST(ModifiedMesh, a_relief_begins_at_a_crease) {
  Gear gear = external(21, 20.0);
  const double root = *gear.root_form_radius(), tip = gear.tip_form_radius();
  const double start = root + 0.5 * (tip - root);
  FlankModifications m;
  m.tip_relief = {0.05, 2 * start, ReliefShape::linear};
  const ModifiedGear g = modified("relieved", std::move(gear), {m, m});
  const TriangleMesh mesh = tessellated(g.body);
  std::map<std::uint32_t, std::vector<Vec3>> normals;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    normals[mesh.shaded_vertices[i]].push_back(mesh.normals[i]);
  // Slope of c along the involute. L is the roll length, and dL/ds = r_b/L for the arc length s.
  const double r_b = g.gear.reference().base_diameter / 2;
  const auto roll = [&](double rho) { return std::sqrt(rho * rho - r_b * r_b); };
  const double slope = 0.05 / (roll(tip) - roll(start)) * r_b / roll(start);
  int creases = 0;
  for (const auto& [vertex, at] : normals) {
    const Vec3& p = mesh.vertices[vertex];
    if (std::abs(p.z()) == g.body.face_width / 2 || std::abs(p.head<2>().norm() - start) > 1e-9)
      continue;
    ASSERT_EQ(at.size(), 2u);
    const double turn = std::acos(std::min(1.0, at[0].dot(at[1])));
    EXPECT_NEAR(turn / slope, 1.0, 0.1);
    ++creases;
  }
  EXPECT_GE(creases, 2 * 21);
}

// Returns a tip relief of the given amount that covers most of the flank.
FlankModifications relief(const Gear& gear, double amount) {
  const double root = *gear.root_form_radius(), tip = gear.tip_form_radius();
  FlankModifications m;
  m.tip_relief = {amount, 2 * (root + 0.2 * (tip - root)), ReliefShape::linear};
  return m;
}

// Returns the reason why teeth remain as cut, or an empty string if they have their modifications.
std::string reason(const CylindricalSpec& spec, double amount) {
  const Gear gear = make_gear(spec).value();
  const FlankModifications m = relief(gear, amount);
  ToothedBody body = gear_body(gear, "gear").value();
  EXPECT_FALSE(modify(body, gear, {m, m}));
  EXPECT_EQ(body.modified == nullptr, !body.unmodified.empty());
  return body.unmodified;
}

TEST(ModifiedMesh, teeth_that_cannot_be_modified_say_why) {
  const auto shifted = [](double x) {
    return testing::plain_spec({.teeth = 12, .module = 2.5, .x = x, .face_width = 10.0});
  };
  EXPECT_EQ(reason(shifted(0.9), 0.001), "the teeth are pointed");
  EXPECT_EQ(reason(shifted(0.8), 0.1), "the modified flanks of a tooth would cross each other");
  EXPECT_EQ(reason(shifted(0.8), 0.001), "");
  // The tip rounding is shorter than the displacement that it would have to follow.
  CylindricalSpec rounded = testing::plain_spec({.teeth = 25, .module = 2.5, .face_width = 10.0});
  rounded.tip_fillet = TipFilletSpec{TipFilletSpec::By::corner, 0.1};
  EXPECT_EQ(reason(rounded, 0.2), "the modification folds the surface beside the flank");
  EXPECT_EQ(reason(rounded, 0.05), "");
  EXPECT_EQ(reason(testing::plain_spec(
                       {.teeth = 1, .module = 2.0, .beta_deg = 60.0, .x = 0.9, .face_width = 10.0}),
                   0.001),
            "a land of the single tooth spans more than half a turn");

  const Gear gear = external(17, 0.0);
  FlankModifications off = relief(gear, 0.02);
  off.tip_relief.reach = gear.tip_diameter + 1;
  ToothedBody body = gear_body(gear, "gear").value();
  const auto error = modify(body, gear, {off, relief(gear, 0.02)});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->field, "modifications.right.tip_relief.reach");
}

}  // namespace
}  // namespace gearwright
