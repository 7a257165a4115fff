// Compares the faces with the exact screw surface at points that the fit did not use. Another CAD
// kernel reads the surfaces from the STEP file.

#include <gtest/gtest.h>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/outline_distance.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/testing/step_reader.hpp"

namespace gearwright {
namespace {

using testing::C;

// Turns a point back by the twist, and by whole pitches to tooth 0.
Vec2 in_section(const gp_Pnt& p, const ToothedBody& body) {
  const C w = C(p.X(), p.Y()) * std::polar(1.0, -body.twist * p.Z());
  const double pitch = 2.0 * kPi / body.outline.teeth;
  return testing::vec(w * std::polar(1.0, -pitch * std::round(std::arg(w) / pitch)));
}

struct Worst {
  double distance = 0.0;  // mm, over all measured B-spline faces
  int faces = 0;
};

// 100 × 100 points are measured on each of the first `most` B-spline faces, which include both
// halves of teeth. The distance within the section is an upper bound of the normal distance in
// space.
Worst look(const ToothedBody& body, const TopoDS_Shape& shape, int most) {
  const testing::OutlineDistance distance(body.outline);
  Worst worst;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More() && worst.faces < most; f.Next()) {
    const auto surface =
        Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(f.Current())));
    if (surface.IsNull()) continue;
    ++worst.faces;
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    for (int i = 0; i < 100; ++i) {
      for (int j = 0; j < 100; ++j) {
        const gp_Pnt p =
            surface->Value(u0 + (u1 - u0) * (i + 0.382) / 100, v0 + (v1 - v0) * (j + 0.618) / 100);
        worst.distance = std::max(worst.distance, distance(in_section(p, body)));
      }
    }
  }
  return worst;
}

void expect_near(const ToothedBody& body, int most) {
  const auto made = step_document({body}, "gear.step");
  ASSERT_TRUE(made);
  const Worst worst = look(body, testing::read_step(made->text).shape, most);
  EXPECT_EQ(worst.faces, most);
  EXPECT_LE(worst.distance, 1e-4);
  EXPECT_LE(worst.distance, 1.06 * made->report.max_deviation_mm + 1e-10);
}

TEST(StepSurface, HelicalTeethLieOnTheScrewSurface) {
  expect_near(testing::sample_body({.beta = 15 * kPi / 180, .chamfer = 0.3}), 8);
}

TEST(StepSurface, LeftHandedToo) { expect_near(testing::sample_body({.beta = -0.5}), 6); }

TEST(StepSurface, LargeSpurGear) {
  expect_near(testing::sample_body({.teeth = 90, .normal_module = 10, .face_width = 100}), 4);
}

TEST(StepSurface, OneToothThatTurnsThreeTimes) {
  expect_near(testing::sample_body({.teeth = 1,
                                    .normal_module = 1,
                                    .beta = 80 * kPi / 180,
                                    .face_width = 10,
                                    .dedendum = 1.2}),
              8);
}

// The test covers every face of the first tooth: circular fillets, an involute, and the flanks that
// a pinion cutter generates on an external and on an internal gear.
TEST(StepSurface, TeethOfFewAndTeethCutByTeeth) {
  expect_near(testing::two_teeth_body(), 6);
  expect_near(testing::one_tooth(), 6);
  expect_near(testing::cut_wheel(), 6);
  expect_near(testing::cut_ring(), 6);
}

TEST(StepSurface, CircularArcTeeth) {
  expect_near(testing::arc_pinion(), 4);
  expect_near(testing::double_arcs(), 8);
}

TEST(StepSurface, LandsAreTrueCylindersOfTheirRadii) {
  const auto body = testing::sample_body({.beta = 0.3});
  const auto made = step_document({body}, "gear.step");
  ASSERT_TRUE(made);
  const TopoDS_Shape shape = testing::read_step(made->text).shape;
  const double root = body.outline.arcs.front().begin_point.norm();
  const double tip = body.outline.arcs.back().end_point.norm();
  int roots = 0, tips = 0;
  for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
    const auto cylinder =
        Handle(Geom_CylindricalSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(f.Current())));
    if (cylinder.IsNull()) continue;
    roots += std::abs(cylinder->Radius() - root) < 1e-12 ? 1 : 0;
    tips += std::abs(cylinder->Radius() - tip) < 1e-12 ? 1 : 0;
  }
  EXPECT_EQ(roots, 20);
  EXPECT_EQ(tips, 20);
}

}  // namespace
}  // namespace gearwright
