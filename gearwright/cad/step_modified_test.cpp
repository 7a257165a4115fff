#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/modified_bodies.hpp"
#include "gearwright/cad/testing/stacked_bodies.hpp"
#include "gearwright/cad/testing/step_reader.hpp"

namespace gearwright {
namespace {

using testing::FlankReading;
using testing::modified_gears;
using testing::ModifiedGear;
using testing::read_flank;

struct Read {
  StepReport report;
  testing::ReadStep step;
};

Read read(const ModifiedGear& g) {
  const auto made = step_document({g.body}, "gear.step");
  EXPECT_TRUE(made) << made.error().message();
  return {made->report, testing::read_step(made->text)};
}

// 40 × 40 points of every B-spline face are computed. Those away from the ends of the flank are
// measured.
TEST(StepModified, flanks_lie_on_the_modified_surface) {
  std::vector<ModifiedGear> gears = modified_gears(3.0);
  gears.push_back(testing::modified_double_helical_gears()[2]);
  for (const ModifiedGear& g : gears) {
    const Read r = read(g);
    EXPECT_LE(r.report.max_deviation_mm, 2.2e-5) << g.name;
    double worst = 0.0;
    std::array<int, 2> seen{};
    for (TopExp_Explorer f(r.step.shape, TopAbs_FACE); f.More(); f.Next()) {
      const auto surface =
          Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(f.Current())));
      if (surface.IsNull()) continue;
      double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
      surface->Bounds(u0, u1, v0, v1);
      // Faces that are not flanks are skipped: their middle lies beyond a form diameter. The teeth
      // are turned copies of each other, so only those near the x axis are measured.
      const gp_Pnt m = surface->Value((u0 + u1) / 2, (v0 + v1) / 2);
      const auto in_gear = [&](const gp_Pnt& at) {
        const Vec3 p(at.X(), at.Y(), at.Z());
        return g.body.two_helices ? testing::in_half(g, p) : p;
      };
      const double foot = read_flank(g, in_gear(m)).foot;
      if (foot < 0.0 || foot > 1.0 || std::abs(std::atan2(m.Y(), m.X())) > 0.4) continue;
      for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
          const gp_Pnt p =
              surface->Value(u0 + (u1 - u0) * (i + 0.382) / 40, v0 + (v1 - v0) * (j + 0.618) / 40);
          const FlankReading at = read_flank(g, in_gear(p));
          ++seen[at.left ? 1 : 0];
          worst = std::max(worst, std::abs(at.error));
        }
      }
    }
    EXPECT_GT(seen[0], 10000) << g.name;
    EXPECT_GT(seen[1], 10000) << g.name;
    EXPECT_LE(worst, 1.06 * r.report.max_deviation_mm + 1e-9) << g.name;
  }
}

struct Solid {
  ModifiedGear gear;
  Read read;
};

// Only one spur, one helical and one internal gear and two double-helical gears, because a kernel
// needs seconds to read and to check each of them.
const std::vector<Solid>& solids() {
  static const std::vector<Solid> read_once = [] {
    std::vector<ModifiedGear> gears = modified_gears(4.0);
    gears.erase(gears.begin() + 2, gears.begin() + 4);
    std::vector<ModifiedGear> halves = testing::modified_double_helical_gears();
    gears.push_back(std::move(halves[0]));
    gears.push_back(std::move(halves[1]));
    std::vector<Solid> all;
    for (ModifiedGear& g : gears) {
      Read r = read(g);
      all.push_back({std::move(g), std::move(r)});
    }
    return all;
  }();
  return read_once;
}

TEST(StepModified, solids_are_valid_closed_and_of_the_computed_volume) {
  for (const auto& [g, r] : solids()) {
    ASSERT_EQ(r.step.refusals, 0) << g.name;
    ASSERT_EQ(r.step.solids.size(), 1u) << g.name;
    const TopoDS_Solid& solid = r.step.solids.front();
    EXPECT_EQ(static_cast<std::size_t>(testing::count(solid, TopAbs_FACE)), r.report.face_count);
    EXPECT_EQ(static_cast<std::size_t>(testing::count(solid, TopAbs_EDGE)), r.report.edge_count);
    EXPECT_TRUE(BRepCheck_Analyzer(solid).IsValid()) << g.name;
    const double cut = metal_volume(g.body);
    EXPECT_NEAR(testing::volume(solid) / r.report.volume_mm3, 1.0, 1e-6) << g.name;
    EXPECT_LT(r.report.volume_mm3, cut * (1 - 1e-5)) << g.name;

    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(solid, TopAbs_EDGE, edges);
    std::vector<std::array<int, 2>> uses(static_cast<std::size_t>(edges.Extent()) + 1, {0, 0});
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
      for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
        const auto at = static_cast<std::size_t>(edges.FindIndex(edge.Current()));
        ++uses[at][edge.Current().Orientation() == TopAbs_FORWARD ? 0 : 1];
      }
    }
    for (std::size_t i = 1; i < uses.size(); ++i)
      EXPECT_EQ(uses[i], (std::array<int, 2>{1, 1})) << g.name << i;
  }
}

TEST(StepModified, gears_of_one_solid_keep_their_modifications) {
  const ModifiedGear gear = modified_gears(4.0)[1];
  const double root = gear.body.outline.arcs.front().begin_point.norm();
  const ToothedBody solid = testing::stacked(gear.body, gear.body, 5.0, 0.8 * root, 0.7);
  const auto made = step_document({solid}, "two.step");
  ASSERT_TRUE(made) << made.error().message();
  const testing::ReadStep step = testing::read_step(made->text);
  ASSERT_EQ(step.refusals, 0);
  ASSERT_EQ(step.solids.size(), 1u);
  EXPECT_TRUE(BRepCheck_Analyzer(step.solids.front()).IsValid());
  EXPECT_NEAR(testing::volume(step.solids.front()) / made->report.volume_mm3, 1.0, 1e-6);
  const double neck = 5.0 * (kPi * 0.64 * root * root - bore_area(*gear.body.bore));
  const auto alone = step_document({gear.body}, "one.step");
  ASSERT_TRUE(alone);
  EXPECT_NEAR(made->report.volume_mm3, 2 * alone->report.volume_mm3 + neck,
              1e-9 * made->report.volume_mm3);
}

TEST(StepModified, edges_lie_on_their_faces) {
  for (const auto& [g, r] : solids()) {
    double worst = 0.0;
    int looked = 0;
    for (TopExp_Explorer f(r.step.shape, TopAbs_FACE); f.More() && looked < 60;
         f.Next(), ++looked) {
      const TopoDS_Face& face = TopoDS::Face(f.Current());
      ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
      for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
        double first = 0.0, last = 0.0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(e.Current()), first, last);
        for (int i = 0; i <= 20; ++i) {
          surface.ValueOfUV(curve->Value(first + (last - first) * i / 20.0), 1e-12);
          worst = std::max(worst, surface.Gap());
        }
      }
    }
    EXPECT_LE(worst, kBrepUncertainty_mm) << g.name;
  }
}

}  // namespace
}  // namespace gearwright
