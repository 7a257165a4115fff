#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/testing/stacked_bodies.hpp"
#include "gearwright/cad/testing/step_reader.hpp"

namespace gearwright {
namespace {

using testing::count;
using testing::plain_body;
using testing::read_step;
using testing::ReadStep;
using testing::sample_body;
using testing::stacked;
using testing::volume;

struct Case {
  std::string name;
  ToothedBody body;
  std::size_t faces;  // walls × slices, plus the walls of the bore and two caps
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

ToothedBody with_bore(ToothedBody body, Bore bore) {
  body.bore = bore;
  return body;
}

std::vector<Case> cases() {
  constexpr double kDeg = kPi / 180.0;
  const ToothedBody small = sample_body({.teeth = 14, .beta = -0.4, .face_width = 30});
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
      // τb = 19.7 rad requires seven slices with six walls each.
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
      // Half a root land spans π − 0.4 rad. The remaining 1.97 rad are less than the turn of 2 rad,
      // so two slices with five walls each are needed.
      {"OneThinTooth", plain_body(1, 20.0, 0.4, 25.0, 0.3, 10.0, 0.2), 12},
      {"TwoTeeth",
       sample_body(
           {.teeth = 2, .normal_module = 1, .beta = -70 * kDeg, .face_width = 40, .dedendum = 1.2}),
       146},
      {"Many", with_bore(sample_body({.teeth = 120, .beta = 0.2, .face_width = 40}), {150}), 723},
      {"Ring", with_bore(plain_body(-12, 25.0, 0.2, 20.0, 0.08, 10.0, 0.03), {60.0}), 51},
      // Each tooth has six walls if tip and root have no land. τb = 3.4 and 11.5 rad require two
      // and four slices.
      {"TwoTeethRoundedTip", testing::two_teeth_body(), 26},
      {"OneToothRoundedTip", testing::one_tooth(), 26},
      {"WheelCutByTwoTeeth", testing::cut_wheel(), 362},
      {"RingCutByPinion", testing::cut_ring(), 395},
      {"CircularArcs", testing::arc_pinion(), 74},
      {"DoubleCircularArcs", testing::double_arcs(), 138},
      // 20 and 14 teeth with six walls each, the neck and four planes.
      {"TwoGears", stacked(sample_body({}), small, 4.0, 9.0, 0.7), 209},
      {"TwoGearsBore",
       stacked(with_bore(sample_body({.beta = 0.2}), {10.0, 3.0, 1.4}), small, 4.0, 9.0, 2.0), 213},
      {"ThreeGears",
       stacked(stacked(sample_body({}), small, 4.0, 9.0, 0.7), sample_body({}), 3.0, 8.0, 1.1),
       332},
      // Five teeth with six walls each, one more root land, the back, the ends and the sides.
      {"Rack", testing::rack_bar(5, 0.0), 36},
      // At each end, the teeth extend by 3.64 mm, past the centre line of a tooth, which adds three
      // walls.
      {"RackRightHand", testing::rack_bar(5, 20.0), 42},
      {"RackLeftHand", testing::rack_bar(5, -20.0), 42},
      // With the full radius there is no root land, so the ends begin in fillets.
      {"RackFullRadius", testing::rack_bar(3, 0.0, 0.4), 20},
      // Lines of constant s cross three whole teeth, and the ends lie in the fillets of two more.
      {"RackOfOneTooth", testing::rack_bar(1, 44.0), 26},
  };
}

struct SolidFile {
  StepReport report;
  ReadStep read;
};

// Returns the file of a case as another kernel reads it. The tests of a case share it, because
// reading takes longer than most of them.
const SolidFile& file_of(const Case& c) {
  static std::map<std::string, SolidFile> read;
  const auto [at, added] = read.try_emplace(c.name);
  if (added) {
    const auto made = step_document({c.body}, "gear.step");
    EXPECT_TRUE(made) << made.error().message();
    if (made) at->second = {made->report, read_step(made->text)};
  }
  return at->second;
}

class StepSolidOf : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    ASSERT_EQ(file_.read.refusals, 0);
    ASSERT_EQ(file_.read.solids.size(), 1u);
  }
  const TopoDS_Solid& solid() const { return file_.read.solids.front(); }

  const SolidFile& file_ = file_of(GetParam());
  const StepReport& report_ = file_.report;
};

TEST_P(StepSolidOf, IsAValidClosedSolidOfTheExactVolume) {
  const Case& c = GetParam();
  EXPECT_EQ(report_.face_count, c.faces);
  const int faces = count(solid(), TopAbs_FACE);
  const int edges = count(solid(), TopAbs_EDGE);
  EXPECT_EQ(static_cast<std::size_t>(faces), report_.face_count);
  EXPECT_EQ(static_cast<std::size_t>(edges), report_.edge_count);
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(solid(), TopAbs_SHELL, shells);
  ASSERT_EQ(shells.Extent(), 1);
  EXPECT_TRUE(BRep_Tool::IsClosed(shells(1)));
  // Euler: V − E + F, minus one for each loop that is a hole in a cap, equals 2 − 2·genus.
  const int holes = c.body.bore ? 1 : 0, necks = static_cast<int>(c.body.above.size());
  EXPECT_EQ(count(solid(), TopAbs_VERTEX) - edges + faces - 2 * (holes + necks), 2 - 2 * holes);

  EXPECT_TRUE(BRepCheck_Analyzer(solid()).IsValid());
  const double exact = testing::exact_volume(c.body);
  // A positive volume means that the faces are oriented outwards.
  EXPECT_NEAR(volume(solid()) / exact, 1.0, 1e-6);
  EXPECT_NEAR(report_.volume_mm3 / exact, 1.0, 1e-14);
  BRepClass3d_SolidClassifier classifier(solid());
  classifier.PerformInfinitePoint(1e-6);
  EXPECT_EQ(classifier.State(), TopAbs_OUT);
}

TEST_P(StepSolidOf, UsesEveryEdgeOnceEachWay) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(solid(), TopAbs_EDGE, edges);
  std::vector<std::array<int, 2>> uses(static_cast<std::size_t>(edges.Extent()) + 1, {0, 0});
  // The explorer combines the orientation of a face with the orientation of its wire.
  for (TopExp_Explorer face(solid(), TopAbs_FACE); face.More(); face.Next()) {
    for (TopExp_Explorer edge(face.Current(), TopAbs_EDGE); edge.More(); edge.Next()) {
      const auto at = static_cast<std::size_t>(edges.FindIndex(edge.Current()));
      ++uses[at][edge.Current().Orientation() == TopAbs_FORWARD ? 0 : 1];
    }
  }
  for (std::size_t i = 1; i < uses.size(); ++i) {
    EXPECT_EQ(uses[i], (std::array<int, 2>{1, 1})) << i;
  }
}

// The distance of an edge's curve from its two faces, and the distance of its ends from their
// vertices, do not exceed the uncertainty stated in the file. The first 60 faces are measured.
TEST_P(StepSolidOf, KeepsItsUncertainty) {
  double worst = 0.0;
  int looked = 0;
  for (TopExp_Explorer f(solid(), TopAbs_FACE); f.More() && looked < 60; f.Next(), ++looked) {
    const TopoDS_Face& face = TopoDS::Face(f.Current());
    ShapeAnalysis_Surface surface(BRep_Tool::Surface(face));
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
      double first = 0.0, last = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
      for (int i = 0; i <= 20; ++i) {
        surface.ValueOfUV(curve->Value(first + (last - first) * i / 20.0), 1e-12);
        worst = std::max(worst, surface.Gap());
      }
      const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
      const gp_Pnt to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
      worst =
          std::max({worst, curve->Value(first).Distance(from), curve->Value(last).Distance(to)});
    }
  }
  EXPECT_LE(worst, kBrepUncertainty_mm);
}

INSTANTIATE_TEST_SUITE_P(Cases, StepSolidOf, ::testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST(StepSolid, HandChangesNeitherFacesNorPoles) {
  const auto right = step_document({sample_body({.beta = 0.4})}, "r");
  const auto left = step_document({sample_body({.beta = -0.4})}, "l");
  ASSERT_TRUE(right && left);
  EXPECT_EQ(right->report.edge_count, left->report.edge_count);
  for (std::size_t i = 0; i < right->report.faces.size(); ++i) {
    EXPECT_EQ(right->report.faces[i].poles_u, left->report.faces[i].poles_u);
    EXPECT_EQ(right->report.faces[i].poles_v, left->report.faces[i].poles_v);
    EXPECT_EQ(right->report.faces[i].max_deviation_mm, left->report.faces[i].max_deviation_mm);
  }
}

TEST(StepSolid, WorkGrowsWithTheTeethAlone) {
  const auto z20 = step_document({sample_body({.teeth = 20, .beta = 0.2})}, "a");
  const auto z40 = step_document({sample_body({.teeth = 40, .beta = 0.2})}, "b");
  ASSERT_TRUE(z20 && z40);
  EXPECT_EQ(z40->report.face_count - 2, 2 * (z20->report.face_count - 2));
  EXPECT_EQ(z40->report.edge_count, 2 * z20->report.edge_count);
}

TEST(StepSolid, BoreTooLargeIsAnAnswer) {
  const auto made = step_document({with_bore(sample_body({}), {80.0})}, "c");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "gear.bore.diameter");
  EXPECT_EQ(made.error().value, "80");
}

}  // namespace
}  // namespace gearwright
