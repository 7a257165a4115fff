#include "gearwright/cad/step.hpp"

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/testing/scratch_folder.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;
using testing::kPi;
using testing::sample_body;

class Step : public ::testing::Test {
 protected:
  testing::ScratchFolder scratch_;
  fs::path folder_ = scratch_.path();
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

struct ReadBack {
  std::vector<std::string> names;  // of the free shape, then of its components
  std::vector<double> volumes;     // of the solids
  std::vector<gp_Pnt> centres;     // of mass, of the solids
  bool valid = true;
};

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  return TCollection_AsciiString(name->Get()).ToCString();
}

ReadBack read(const fs::path& path) {
  const Handle(XCAFApp_Application) application = XCAFApp_Application::GetApplication();
  Handle(TDocStd_Document) document;
  application->NewDocument("BinXCAF", document);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  EXPECT_EQ(reader.ReadFile(path.c_str()), IFSelect_RetDone);
  EXPECT_TRUE(reader.Transfer(document));
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  TDF_LabelSequence free;
  shapes->GetFreeShapes(free);
  ReadBack result;
  EXPECT_EQ(free.Length(), 1);
  result.names.push_back(name_of(free.Value(1)));
  TDF_LabelSequence components;
  XCAFDoc_ShapeTool::GetComponents(free.Value(1), components);
  for (int i = 1; i <= components.Length(); ++i) {
    TDF_Label part;
    EXPECT_TRUE(XCAFDoc_ShapeTool::GetReferredShape(components.Value(i), part));
    result.names.push_back(name_of(part));
  }
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(free.Value(1));
  result.valid = BRepCheck_Analyzer(shape).IsValid();
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(solid.Current(), properties, 1e-10);
    result.volumes.push_back(properties.Mass());
    result.centres.push_back(properties.CentreOfMass());
  }
  application->Close(document);
  return result;
}

void expect_same_back(const ToothedBody& body, const fs::path& path) {
  const auto report = write_step({body}, path);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_TRUE(report->checked);
  EXPECT_LE(report->max_deviation_mm, 1e-4);
  EXPECT_EQ(report->volume_mm3, metal_area(body) * body.face_width);
  const ReadBack back = read(path);
  EXPECT_TRUE(back.valid);
  EXPECT_EQ(back.names, std::vector<std::string>{body.name});
  ASSERT_EQ(back.volumes.size(), 1u);
  EXPECT_NEAR(back.volumes[0] / report->volume_mm3, 1.0, 1e-6);
}

TEST_F(Step, PartsReadBackAsTheyWere) {
  auto body = sample_body({.beta = 15 * kPi / 180});
  body.name = "gear1";
  body.bore = Bore{20.0, 6.0, 2.8};
  expect_same_back(body, folder_ / "keyway.step");
  body.bore = Bore{20.0};
  body.twist = -body.twist;
  expect_same_back(body, folder_ / "left.step");
  expect_same_back(sample_body({.pointed = true, .full_radius_root = true}), folder_ / "spur.step");
  expect_same_back(sample_body({.teeth = 1,
                                .normal_module = 1,
                                .beta = 80 * kPi / 180,
                                .face_width = 10,
                                .dedendum = 1.2}),
                   folder_ / "one.step");
  auto ring = testing::plain_body(-12, 25.0, 0.2, 20.0, 0.08, 10.0, 0.03);
  ring.bore = Bore{60.0};
  expect_same_back(ring, folder_ / "ring.step");
}

TEST_F(Step, FewTeethReadBackAsTheyWere) {
  expect_same_back(testing::two_teeth(), folder_ / "two_teeth.step");
  expect_same_back(testing::one_tooth(), folder_ / "one_tooth.step");
}

TEST_F(Step, CutWheelReadsBackAsItWas) {
  expect_same_back(testing::cut_wheel(), folder_ / "wheel.step");
}

TEST_F(Step, CutRingReadsBackAsItWas) {
  expect_same_back(testing::cut_ring(), folder_ / "ring.step");
}

TEST_F(Step, HeaderSaysWhatAndWho) {
  const auto document = step_document({sample_body({})}, "pinion.step");
  ASSERT_TRUE(document);
  std::string header = document->text.substr(0, document->text.find("ENDSEC"));
  std::erase_if(header, [](char c) { return c == ' ' || c == '\n'; });  // lines break anywhere
  EXPECT_NE(header.find("AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"), std::string::npos);
  EXPECT_NE(header.find("FILE_NAME('pinion.step','1970-01-01T00:00:00',('Gearwright'),"
                        "('Gearwright')"),
            std::string::npos)
      << header;
  EXPECT_EQ(header.find("OpenCASCADEModel"), std::string::npos);
  EXPECT_NE(document->text.find("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07)"),
            std::string::npos);
  EXPECT_NE(document->text.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
}

TEST_F(Step, SameBodiesSameBytes) {
  const auto gear = testing::plain_body(5, 20.0, 0.5, 25.0, 0.2, 10.0, 0.05);
  auto mate = testing::plain_body(7, 20.0, 0.3, 25.0, 0.1, 10.0, -0.05);
  mate.pose.translation() = Eigen::Vector3d(53.0, 0.0, 0.0);
  const auto first = step_document({gear, mate}, "pair.step");
  const auto other = step_document({mate}, "other.step");
  const auto again = step_document({gear, mate}, "pair.step");
  ASSERT_TRUE(first && other && again);
  EXPECT_TRUE(first->text == again->text);
  ASSERT_TRUE(write_step({gear, mate}, folder_ / "pair.step"));
  EXPECT_TRUE(text_of(folder_ / "pair.step") == first->text);
}

TEST_F(Step, PairIsAnAssemblyOfPlacedParts) {
  auto gear1 = sample_body({.beta = 0.3});
  gear1.name = "gear1";
  auto gear2 = sample_body({.teeth = 31, .beta = -0.3, .face_width = 15});
  gear2.name = "gear2";
  // A shaft across: turned by 30° about x, moved.
  gear2.pose =
      Eigen::Translation3d(53.0, 4.0, -2.0) * Eigen::AngleAxisd(kPi / 6, Eigen::Vector3d::UnitX());
  const auto report = write_step({gear1, gear2}, folder_ / "pair.step");
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->checked);
  EXPECT_EQ(report->faces.size(), 8u);
  EXPECT_EQ(report->faces[3].body, 0u);
  EXPECT_EQ(report->faces[4].body, 1u);
  EXPECT_EQ(report->face_count, 6u * (20 + 31) + 4);

  const ReadBack back = read(folder_ / "pair.step");
  EXPECT_TRUE(back.valid);
  EXPECT_EQ(back.names, (std::vector<std::string>{"pair", "gear1", "gear2"}));
  ASSERT_EQ(back.volumes.size(), 2u);
  EXPECT_NEAR(back.volumes[0] / (metal_area(gear1) * 20), 1.0, 1e-6);
  EXPECT_NEAR(back.volumes[1] / (metal_area(gear2) * 15), 1.0, 1e-6);
  // Both bodies are symmetric about their origins, which the poses move. 1e-5 mm: what surfaces
  // within 2e-5 mm can move a centre.
  EXPECT_LE(back.centres[0].Distance(gp_Pnt(0, 0, 0)), 1e-5);
  EXPECT_LE(back.centres[1].Distance(gp_Pnt(53, 4, -2)), 1e-5);
}

TEST_F(Step, PlacedKeywayPointsWhereThePoseTurnsIt) {
  auto body = testing::plain_body(12, 20.0, 0.2, 25.0, 0.08);
  body.bore = Bore{20.0, 6.0, 2.8};
  body.pose = Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitZ());  // +y to +x
  ASSERT_TRUE(write_step({body}, folder_ / "turned.step"));
  const ReadBack back = read(folder_ / "turned.step");
  ASSERT_EQ(back.centres.size(), 1u);
  // The slot's metal is missing on the side +x; its moment about y is −∫ x dA b of the slot:
  // ∫ over |y| ≤ 3 of (12.8² − (100 − y²))/2 dy = 3·(163.84 − 100) + 9.
  const double moment = -(3.0 * 63.84 + 9.0);
  EXPECT_NEAR(back.centres[0].X(), moment / metal_area(body), 1e-6);
  EXPECT_NEAR(back.centres[0].Y(), 0.0, 1e-6);
}

TEST_F(Step, BoreTooLargeIsAnErrorAndLeavesNoFile) {
  auto body = sample_body({});
  body.name = "gear2";
  body.bore = Bore{70.0};
  const auto report = write_step({sample_body({}), body}, folder_ / "none.step");
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().field, "gear2.bore.diameter");
  EXPECT_EQ(report.error().value, "70");
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Step, WorldThatFailsIsAnIoError) {
  const fs::path nowhere = folder_ / "no such folder" / "gear.step";
  EXPECT_THROW(static_cast<void>(write_step({sample_body({})}, nowhere)), IoError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Step, WritesNothingToStdout) {
  ::testing::internal::CaptureStdout();
  const auto report = write_step({sample_body({})}, folder_ / "quiet.step");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_TRUE(report);
}

}  // namespace
}  // namespace gearwright
