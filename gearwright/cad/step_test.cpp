#include "gearwright/cad/step.hpp"

#include <gtest/gtest.h>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <gp_Pnt.hxx>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/testing/scratch_folder.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/testing/step_reader.hpp"

namespace gearwright {
namespace {

namespace fs = std::filesystem;
using testing::read_step;
using testing::ReadStep;
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

gp_Pnt centre_of_mass(const TopoDS_Shape& solid) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(solid, properties, 1e-10);
  return properties.CentreOfMass();
}

void expect_same_back(const ToothedBody& body) {
  const auto made = step_document({body}, "part.step");
  ASSERT_TRUE(made) << made.error().message();
  const StepReport& report = made->report;
  EXPECT_LE(report.max_deviation_mm, 1e-4);
  EXPECT_EQ(report.volume_mm3, metal_volume(body));
  const ReadStep back = read_step(made->text);
  EXPECT_EQ(back.refusals, 0);
  EXPECT_EQ(back.free_shapes, 1);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape).IsValid());
  EXPECT_EQ(back.names, std::vector<std::string>{body.name});
  ASSERT_EQ(back.solids.size(), 1u);
  EXPECT_NEAR(testing::volume(back.solids[0]) / report.volume_mm3, 1.0, 1e-6);
}

TEST_F(Step, PartsReadBackAsTheyWere) {
  auto body = sample_body({.beta = 15 * kPi / 180});
  body.name = "gear1";
  body.bore = Bore{20.0, 6.0, 2.8};
  expect_same_back(body);
  body.bore = Bore{20.0};
  body.twist = -body.twist;
  expect_same_back(body);
  expect_same_back(sample_body({.pointed = true, .full_radius_root = true}));
  expect_same_back(sample_body(
      {.teeth = 1, .normal_module = 1, .beta = 80 * kPi / 180, .face_width = 10, .dedendum = 1.2}));
  auto ring = testing::plain_body(-12, 25.0, 0.2, 20.0, 0.08, 10.0, 0.03);
  ring.bore = Bore{60.0};
  expect_same_back(ring);
}

TEST_F(Step, DoubleHelicalGearsReadBackAsTheyWere) {
  for (const double gap : {0.0, 4.0}) {
    auto body = testing::herringbone(gap);
    expect_same_back(body);
    body.bore = Bore{20.0, 6.0, 2.8};
    expect_same_back(body);
    body.twist = -body.twist;
    expect_same_back(body);
    expect_same_back(testing::herringbone_ring(gap));
  }
  expect_same_back(testing::herringbone(4.0, 0.5));
  expect_same_back(testing::herringbone_ring(4.0, 0.5));
}

TEST_F(Step, TheHalvesOfADoubleHelicalGearAreMirrorImages) {
  const auto made = step_document({testing::herringbone(4.0)}, "part.step");
  ASSERT_TRUE(made);
  const ReadStep back = read_step(made->text);
  ASSERT_EQ(back.solids.size(), 1u);
  EXPECT_NEAR(centre_of_mass(back.solids[0]).Z(), 0.0, 1e-6);
}

TEST_F(Step, FewTeethReadBackAsTheyWere) {
  expect_same_back(testing::two_teeth_body());
  expect_same_back(testing::one_tooth());
}

TEST_F(Step, CutWheelReadsBackAsItWas) { expect_same_back(testing::cut_wheel()); }

TEST_F(Step, CutRingReadsBackAsItWas) { expect_same_back(testing::cut_ring()); }

TEST_F(Step, HeaderSaysWhatAndWho) {
  const auto document = step_document({sample_body({})}, "pinion.step");
  ASSERT_TRUE(document);
  const std::string& text = document->text;
  EXPECT_TRUE(text.starts_with("ISO-10303-21;\nHEADER;\n"));
  EXPECT_TRUE(text.ends_with("ENDSEC;\nEND-ISO-10303-21;\n"));
  const std::string header = text.substr(0, text.find("DATA;"));
  EXPECT_NE(
      header.find("'AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'"),
      std::string::npos);
  EXPECT_NE(header.find("FILE_NAME('pinion.step','1970-01-01T00:00:00',('Gearwright'),"
                        "('Gearwright')"),
            std::string::npos)
      << header;
  EXPECT_NE(text.find("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07)"), std::string::npos);
  EXPECT_NE(text.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
}

TEST_F(Step, Ap214DiffersInItsProtocolAlone) {
  const auto body = sample_body({.beta = 0.2});
  const auto newer = step_document({body}, "a.step");
  const auto older = step_document({body}, "a.step", {StepSchema::ap214});
  ASSERT_TRUE(newer && older);
  EXPECT_NE(older->text.find("FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 3 1 1 }'))"),
            std::string::npos);
  EXPECT_EQ(older->text.find("AP242"), std::string::npos);
  EXPECT_EQ(older->text.find("ap242"), std::string::npos);
  std::istringstream a(newer->text), b(older->text);
  int lines = 0;
  for (std::string one, other; std::getline(a, one) && std::getline(b, other);)
    lines += one == other ? 0 : 1;
  EXPECT_EQ(lines, 3);  // the schema, the protocol, the subject
  const ReadStep back = read_step(older->text);
  EXPECT_EQ(back.refusals, 0);
  ASSERT_EQ(back.solids.size(), 1u);
  EXPECT_NEAR(testing::volume(back.solids[0]) / older->report.volume_mm3, 1.0, 1e-6);
}

TEST_F(Step, NamesComeBackWhateverTheyAre) {
  auto body = sample_body({});
  body.name = "Ritzel 'α' \\ 齿轮 \xF0\x9F\x94\xA7";
  const auto made = step_document({body}, "größe.step");
  ASSERT_TRUE(made);
  for (const char c : made->text) ASSERT_TRUE(c == '\n' || (c >= 0x20 && c < 0x7F));
  EXPECT_NE(made->text.find("FILE_NAME('gr\\X2\\00F600DF\\X0\\e.step'"), std::string::npos);
  EXPECT_EQ(read_step(made->text).names, std::vector<std::string>{body.name});
}

TEST_F(Step, SameBodiesSameBytes) {
  const auto gear = testing::plain_body(5, 20.0, 0.5, 25.0, 0.2, 10.0, 0.05);
  auto mate = testing::plain_body(7, 20.0, 0.3, 25.0, 0.1, 10.0, -0.05);
  mate.pose = SolidPose(Eigen::Isometry3d(Eigen::Translation3d(53.0, 0.0, 0.0)));
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
  // The axes are crossed: gear 2 is rotated by 30° about x and shifted.
  gear2.pose = SolidPose(Eigen::Translation3d(53.0, 4.0, -2.0) *
                         Eigen::AngleAxisd(kPi / 6, Eigen::Vector3d::UnitX()));
  const auto made = step_document({gear1, gear2}, "pair.step");
  ASSERT_TRUE(made);
  const StepReport& report = made->report;
  EXPECT_EQ(report.faces.size(), 8u);
  EXPECT_EQ(report.faces[3].body, 0u);
  EXPECT_EQ(report.faces[4].body, 1u);
  EXPECT_EQ(report.face_count, 6u * (20 + 31) + 4);

  const ReadStep back = read_step(made->text);
  EXPECT_EQ(back.refusals, 0);
  EXPECT_EQ(back.free_shapes, 1);
  EXPECT_TRUE(BRepCheck_Analyzer(back.shape).IsValid());
  EXPECT_EQ(back.names, (std::vector<std::string>{"pair", "gear1", "gear2"}));
  ASSERT_EQ(back.solids.size(), 2u);
  EXPECT_NEAR(testing::volume(back.solids[0]) / (metal_area(gear1) * 20), 1.0, 1e-6);
  EXPECT_NEAR(testing::volume(back.solids[1]) / (metal_area(gear2) * 15), 1.0, 1e-6);
  // Both bodies are symmetric about their origins, which the poses move. If a surface deviates by
  // 2e-5 mm, the centre of mass moves by at most 1e-5 mm.
  EXPECT_LE(centre_of_mass(back.solids[0]).Distance(gp_Pnt(0, 0, 0)), 1e-5);
  EXPECT_LE(centre_of_mass(back.solids[1]).Distance(gp_Pnt(53, 4, -2)), 1e-5);
  // Colours are written as sRGB values with three decimals. An error of 0.0005 corresponds to 0.001
  // in linear light.
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(back.colours[i][k], part_colour(i)[k], 0.001) << i << k;
  }
}

TEST_F(Step, PlacedKeywayPointsWhereThePoseTurnsIt) {
  auto body = testing::plain_body(12, 20.0, 0.2, 25.0, 0.08);
  body.bore = Bore{20.0, 6.0, 2.8};
  // +y to +x
  body.pose = SolidPose(Eigen::Isometry3d(Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitZ())));
  const auto made = step_document({body}, "turned.step");
  ASSERT_TRUE(made);
  const ReadStep back = read_step(made->text);
  EXPECT_EQ(back.names, (std::vector<std::string>{"turned", body.name}));
  ASSERT_EQ(back.solids.size(), 1u);
  const gp_Pnt centre = centre_of_mass(back.solids[0]);
  // The slot removes metal on the side +x. Its moment per face width about the y axis is
  // −∫ (12.8² − (100 − y²))/2 dy over |y| ≤ 3, which is −(3·(163.84 − 100) + 9).
  const double moment = -(3.0 * 63.84 + 9.0);
  EXPECT_NEAR(centre.X(), moment / metal_area(body), 1e-6);
  EXPECT_NEAR(centre.Y(), 0.0, 1e-6);
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
