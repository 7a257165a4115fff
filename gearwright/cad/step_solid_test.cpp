#include "gearwright/cad/step_solid.hpp"

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::kPi;
using testing::plain_body;
using testing::sample_body;
using testing::SampleGear;

struct Case {
  std::string name;
  ToothedBody body;
  std::size_t faces;  // pinned: walls × slices, bore walls, two caps
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

ToothedBody with_bore(ToothedBody body, Bore bore) {
  body.bore = bore;
  return body;
}

std::vector<Case> cases() {
  constexpr double kDeg = kPi / 180.0;
  return {
      {"Spur", sample_body({}), 122},
      {"RightHand", sample_body({.beta = 15 * kDeg}), 122},
      {"LeftHand", sample_body({.beta = -15 * kDeg}), 122},
      {"Bore", with_bore(sample_body({.beta = 15 * kDeg}), {20.0}), 123},
      {"Keyway", with_bore(sample_body({.beta = -15 * kDeg}), {20.0, 6.0, 2.8}), 126},
      {"SpurKeyway", with_bore(sample_body({}), {20.0, 6.0, 2.8}), 126},
      {"Pointed", sample_body({.beta = 0.3, .pointed = true}), 102},
      {"FullRadiusRoot", sample_body({.beta = 0.3, .full_radius_root = true}), 102},
      {"NoLands", sample_body({.pointed = true, .full_radius_root = true}), 82},
      {"Chamfer", sample_body({.beta = 0.2, .chamfer = 0.4}), 162},
      // τb = 19.7 rad: seven slices of six walls.
      {"OneTooth",
       sample_body(
           {.teeth = 1, .normal_module = 1, .beta = 80 * kDeg, .face_width = 10, .dedendum = 1.2}),
       44},
      {"OneToothBore",
       with_bore(sample_body({.teeth = 1,
                              .normal_module = 1,
                              .beta = -80 * kDeg,
                              .face_width = 10,
                              .dedendum = 1.2}),
                 {2.0}),
       45},
      // Half a root land of π − 0.4 rad leaves 1.97 rad for the turn of 2: two slices of five
      // walls.
      {"OneThinTooth", plain_body(1, 20.0, 0.4, 25.0, 0.3, 10.0, 0.2), 12},
      {"TwoTeeth",
       sample_body(
           {.teeth = 2, .normal_module = 1, .beta = -70 * kDeg, .face_width = 40, .dedendum = 1.2}),
       146},
      {"Many", with_bore(sample_body({.teeth = 120, .beta = 0.2, .face_width = 40}), {150}), 723},
      {"Ring", with_bore(plain_body(-12, 25.0, 0.2, 20.0, 0.08, 10.0, 0.03), {60.0}), 51},
      // Six walls a tooth where tip and root have no land, τb = 3.4 and 11.5 rad: two and four
      // slices.
      {"TwoTeethRoundedTip", testing::two_teeth(), 26},
      {"OneToothRoundedTip", testing::one_tooth(), 26},
      {"WheelCutByTwoTeeth", testing::cut_wheel(), 362},
      {"RingCutByPinion", testing::cut_ring(), 395},
      {"CircularArcs", testing::arc_pinion(), 74},
      {"DoubleCircularArcs", testing::double_arcs(), 138},
  };
}

class StepSolidOf : public ::testing::TestWithParam<Case> {};

TEST_P(StepSolidOf, IsAValidClosedSolidOfTheExactVolume) {
  const Case& c = GetParam();
  const auto made = make_solid(c.body);
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(made->face_count, c.faces);

  TopTools_IndexedMapOfShape faces, edges, vertices, shells;
  TopExp::MapShapes(made->solid, TopAbs_FACE, faces);
  TopExp::MapShapes(made->solid, TopAbs_EDGE, edges);
  TopExp::MapShapes(made->solid, TopAbs_VERTEX, vertices);
  TopExp::MapShapes(made->solid, TopAbs_SHELL, shells);
  EXPECT_EQ(static_cast<std::size_t>(faces.Extent()), made->face_count);
  EXPECT_EQ(static_cast<std::size_t>(edges.Extent()), made->edge_count);
  ASSERT_EQ(shells.Extent(), 1);
  EXPECT_TRUE(BRep_Tool::IsClosed(shells(1)));
  // Euler: V − E + F, less one for each loop that is a hole in a cap, is 2 − 2·genus.
  const int holes = c.body.bore ? 1 : 0;
  EXPECT_EQ(vertices.Extent() - edges.Extent() + faces.Extent() - 2 * holes, 2 - 2 * holes);

  EXPECT_TRUE(BRepCheck_Analyzer(made->solid).IsValid());
  GProp_GProps properties;
  BRepGProp::VolumeProperties(made->solid, properties, 1e-10);
  const double volume = metal_area(c.body) * c.body.face_width;
  EXPECT_NEAR(properties.Mass() / volume, 1.0, 1e-6);  // positive: the outside is out
  BRepClass3d_SolidClassifier classifier(made->solid);
  classifier.PerformInfinitePoint(1e-6);
  EXPECT_EQ(classifier.State(), TopAbs_OUT);
}

TEST_P(StepSolidOf, UsesEveryEdgeOnceEachWay) {
  const auto made = make_solid(GetParam().body);
  ASSERT_TRUE(made);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(made->solid, TopAbs_EDGE, edges);
  std::vector<std::array<int, 2>> uses(static_cast<std::size_t>(edges.Extent()) + 1, {0, 0});
  // An explorer turns orientations through face and wire; the solid and its shell are FORWARD.
  for (TopExp_Explorer face(made->solid, TopAbs_FACE); face.More(); face.Next()) {
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
      const auto at = static_cast<std::size_t>(edges.FindIndex(edge.Current()));
      ++uses[at][edge.Current().Orientation() == TopAbs_FORWARD ? 0 : 1];
    }
  }
  for (std::size_t i = 1; i < uses.size(); ++i) {
    EXPECT_EQ(uses[i], (std::array<int, 2>{1, 1})) << i;
  }
}

// Distance between an edge's curve and its trace on each face, at equal parameters, is what its
// tolerance claims; so is that between vertices and the ends of edges.
TEST_P(StepSolidOf, KeepsItsTolerances) {
  const auto made = make_solid(GetParam().body);
  ASSERT_TRUE(made);
  double worst = 0.0;
  for (TopExp_Explorer f(made->solid, TopAbs_FACE); f.More(); f.Next()) {
    const TopoDS_Face& face = TopoDS::Face(f.Current());
    EXPECT_EQ(BRep_Tool::Tolerance(face), kStepTolerance_mm);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
      EXPECT_EQ(BRep_Tool::Tolerance(edge), kStepTolerance_mm);
      double first = 0.0, last = 0.0, first2 = 0.0, last2 = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
      const Handle(Geom2d_Curve) trace = BRep_Tool::CurveOnSurface(edge, face, first2, last2);
      ASSERT_EQ(first, first2);
      ASSERT_EQ(last, last2);
      for (int i = 0; i <= 40; ++i) {
        const double t = first + (last - first) * i / 40.0;
        const gp_Pnt2d uv = trace->Value(t);
        worst = std::max(worst, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
      }
      const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
      const gp_Pnt to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
      worst =
          std::max({worst, curve->Value(first).Distance(from), curve->Value(last).Distance(to)});
    }
  }
  EXPECT_LE(worst, kStepTolerance_mm);
}

INSTANTIATE_TEST_SUITE_P(Cases, StepSolidOf, ::testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST(StepSolid, HandChangesNeitherFacesNorPoles) {
  const auto right = make_solid(sample_body({.beta = 0.4}));
  const auto left = make_solid(sample_body({.beta = -0.4}));
  ASSERT_TRUE(right && left);
  EXPECT_EQ(right->edge_count, left->edge_count);
  for (std::size_t i = 0; i < right->faces.size(); ++i) {
    EXPECT_EQ(right->faces[i].poles_u, left->faces[i].poles_u);
    EXPECT_EQ(right->faces[i].poles_v, left->faces[i].poles_v);
    EXPECT_EQ(right->faces[i].max_deviation_mm, left->faces[i].max_deviation_mm);
  }
}

TEST(StepSolid, WorkGrowsWithTheTeethAlone) {
  const auto z20 = make_solid(sample_body({.teeth = 20, .beta = 0.2}));
  const auto z40 = make_solid(sample_body({.teeth = 40, .beta = 0.2}));
  ASSERT_TRUE(z20 && z40);
  EXPECT_EQ(z40->face_count - 2, 2 * (z20->face_count - 2));
  EXPECT_EQ(z40->edge_count, 2 * z20->edge_count);
}

TEST(StepSolid, BoreTooLargeIsAnAnswer) {
  const auto made = make_solid(with_bore(sample_body({}), {80.0}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "bore.diameter");
  EXPECT_EQ(made.error().value, "80");
}

}  // namespace
}  // namespace gearwright
