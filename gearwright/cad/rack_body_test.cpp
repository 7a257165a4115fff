// (1) The contour is a closed chain. Its straight pieces and the chords of the fillets enclose the
//     expected area.
// (2) The mesh is closed and every edge occurs twice. Its volume is the area times the width,
//     except for the chords of the fillets. Every vertex lies on the teeth, and the whole bar is
//     inside its box.
// (3) A drawing shows the bar with its teeth towards +x, and the bar moves with its pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/cad/contour.hpp"
#include "gearwright/cad/dxf.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/svg_outline.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"

namespace gearwright {
namespace {

using testing::rack_bar;

std::vector<ToothedBody> racks() {
  return {rack_bar(5, 0.0),  rack_bar(5, 20.0),      rack_bar(4, -20.0),
          rack_bar(1, 45.0), rack_bar(3, 10.0, 0.4), rack_bar(2, -0.001)};
}

// Height of the teeth of rack_bar() at s. It is computed from the values of ISO 53-A for module 2,
// without the outline.
double height_of(double s, int teeth, double beta_deg, double allowance) {
  const double beta = beta_deg * std::numbers::pi / 180, tangent = std::tan(std::numbers::pi / 9);
  const double pitch = 2 * std::numbers::pi;
  const double along = s * std::cos(beta) + (teeth - 1) * pitch / 2;
  const double n = std::abs(std::remainder(along, pitch));
  const double flank = ((pitch / 2 + allowance) / 2 - n) / tangent;
  // The circle of the fillet touches the land and the flank. A sharp corner would lie at −2.5.
  const double sine = std::sin(std::numbers::pi / 9), cosine = std::cos(std::numbers::pi / 9);
  const double space = (pitch / 2 - allowance) / 2 - 2.5 * tangent;
  const double rho = std::min(0.76, space * cosine / (1 - sine));
  const double center = pitch / 2 - space + rho * (1 - sine) / cosine;
  if (n >= center) return -2.5;
  if (n > center - rho * cosine)
    return -2.5 + rho - std::sqrt(rho * rho - (n - center) * (n - center));
  return std::min(2.0, flank);
}

TEST(RackBody, contour_is_closed_and_encloses_the_area) {  // (1)
  for (const ToothedBody& body : racks()) {
    const Contour contour = rack_contour(body.outline, *body.rack);
    double area = 0.0;
    for (std::size_t i = 0; i < contour.pieces.size(); ++i) {
      const ContourPiece& piece = contour.pieces[i];
      EXPECT_EQ(piece.end, contour.pieces[(i + 1) % contour.pieces.size()].begin);
      std::vector<Vec2> points{piece.begin, piece.end};
      if (!piece.land) points = placed(contour, piece, sample(body.outline.arcs[piece.arc], 400));
      for (std::size_t j = 0; j + 1 < points.size(); ++j)
        area += 0.5 * (points[j].x() * points[j + 1].y() - points[j].y() * points[j + 1].x());
    }
    // The chord of each fillet adds ρ² Δ³/12 in the normal section, with Δ = (π/2 − α)/399.
    const double turn = 7 * std::numbers::pi / 18, rho = body.rack->fillet_radius;
    const double chords = 2 * body.outline.teeth * std::hypot(1.0, body.rack->slope) * rho * rho *
                          std::pow(turn, 3) / (12 * 399.0 * 399.0);
    EXPECT_NEAR(area - metal_area(body), chords, 1e-3 * chords);
    // Coarse check of metal_area(): the teeth above the datum line have nearly the area of the
    // spaces below it, so the bar has nearly the area of a rectangle up to the datum line.
    const double sharp = body.outline.teeth * body.rack->pitch * 12.0;
    EXPECT_NEAR(metal_area(body) / sharp, 1.0, 0.1);
  }
}

TEST(RackBody, mesh_is_closed_and_on_the_teeth) {  // (2)
  const std::vector<std::array<double, 3>> numbers{{5, 0, 0},  {5, 20, 0},   {4, -20, 0},
                                                   {1, 45, 0}, {3, 10, 0.4}, {2, -0.001, 0}};
  const auto bodies = racks();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const ToothedBody& body = bodies[i];
    const auto mesh = tessellate(body, {.chord_tolerance_mm = 0.002});
    ASSERT_TRUE(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& t : mesh->triangles)
      for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, times] : uses) {
      EXPECT_EQ(times, 1);
      EXPECT_TRUE(uses.contains({edge.second, edge.first})) << i;
    }
    EXPECT_EQ(mesh->vertices.size() + mesh->triangles.size(), uses.size() / 2 + 2) << i;
    const double exact = metal_area(body) * 20.0;
    // The chords of the fillets add material. The fillets are shorter than 1.1 mm on each side of a
    // tooth.
    const double most = 0.002 * 2.2 * body.outline.teeth * 20.0 * std::hypot(1.0, body.rack->slope);
    EXPECT_GE(mesh_volume(*mesh), exact * (1 - 1e-12)) << i;
    EXPECT_LE(mesh_volume(*mesh), exact + most) << i;
    const double end = body.outline.teeth * body.rack->pitch / 2;
    for (const Vec3& p : mesh->vertices) {
      EXPECT_LE(std::abs(p.y()), end);
      EXPECT_LE(std::abs(p.z()), 10.0);
      if (p.x() == -12.0) continue;
      const double s = p.y() - p.z() * body.rack->slope;
      // Vertices within a fillet facet lie on its chord. Their distance from the circle is at most
      // the tolerance.
      const double x = height_of(s, static_cast<int>(numbers[i][0]), numbers[i][1], numbers[i][2]);
      EXPECT_NEAR(p.x(), x + 0.001, 0.0011 + 0.001) << i << " " << s;
    }
    for (std::size_t k = 0; k < mesh->triangles.size(); ++k) {
      const Triangle &t = mesh->triangles[k], &shaded = mesh->shaded_triangles[k];
      const Vec3 a = mesh->vertices[t[0]], b = mesh->vertices[t[1]], c = mesh->vertices[t[2]];
      const Vec3 out = (b - a).cross(c - a).normalized();
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(mesh->shaded_vertices[shaded[j]], t[j]);
        // The direction changes by at most 0.26 rad over a facet of a fillet.
        EXPECT_GT(mesh->normals[shaded[j]].dot(out), std::cos(0.26)) << i;
      }
    }
  }
}

TEST(RackBody, drawings_contain_the_bar) {  // (3)
  for (const ToothedBody& body : racks()) {
    const auto svg = svg_drawing(body);
    ASSERT_TRUE(svg);
    EXPECT_LE(svg->deviation_mm, kSvgTolerance_mm);
    for (const auto style : {ContourOptions::Style::biarcs, ContourOptions::Style::splines}) {
      const auto dxf = dxf_drawing(body, {style, {}});
      ASSERT_TRUE(dxf);
      EXPECT_LE(dxf->deviation_mm, dxf->tolerance_mm);
    }
  }
}

TEST(RackBody, has_a_default_size) {
  const auto pair = mount_rack(
      make_gear(testing::plain_spec({.teeth = 20, .module = 2, .face_width = 20})).value(), {});
  ASSERT_TRUE(pair);
  const RackGeometry& rack = pair->rack;
  EXPECT_EQ(rack.teeth, 21);
  EXPECT_EQ(rack.height, 2 * (1.25 + 3));
  EXPECT_FALSE(rack.length());
  ASSERT_EQ(pair->warnings.size(), 2u);
  EXPECT_TRUE(rack_body(rack, "rack"));
}

}  // namespace
}  // namespace gearwright
