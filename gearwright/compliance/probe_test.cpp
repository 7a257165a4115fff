// The compliance of a tooth is compared with converged finite elements, and its laws are tested.
//
// The references FE2D-25, FE3D-25 and FE3D-25-HEL are separate computations, with up to 68 000
// unknowns for triangles (gmsh) and 105 840 for C3D20 elements (CalculiX), for E = 1, m = 1,
// ν = 0.3, 25 teeth, x = 0, a rack with dedendum 1.25 and root fillet 0.38, and a bore radius of
// 6 modules. The values for the helix angle of 45° come from tests/oracle/bricks.
#include "gearwright/compliance/probe.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/compliance/tooth_table.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {
namespace {

constexpr double kModule = 3.0;

Gear gear_of(double module, int teeth = 25, double shift = 0.0) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = module, .x = shift, .face_width = 10 * module});
  s.rack = *iso53_rack("ISO53-A");
  return std::move(make_gear(s)).take();
}
ElasticBody body_of(double module) { return {12 * module, 0.3, 1.0}; }

TEST(ToothCompliance, InTheSectionAgreesWithTriangles) {
  const Gear gear = gear_of(kModule);
  const double reference[3][2] = {{13.4, 13.324}, {12.5, 7.247}, {11.9, 5.5155}};
  for (const auto& [radius, want] : reference) {
    const auto a = probe_compliance(gear, body_of(kModule), {.diameter = 2 * radius * kModule},
                                    ComplianceAccuracy::full);
    ASSERT_TRUE(a) << a.error().message();
    EXPECT_NEAR(a->own, want, 0.007 * want) << radius;
  }
}

// The model of a tooth includes its neighbour on each side, so it needs three teeth.
TEST(ToothCompliance, NeedsThreeTeeth) {
  for (const int teeth : {1, 2, 3}) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = teeth, .module = kModule, .beta_deg = 65, .x = 0.4, .face_width = 10 * kModule});
    s.rack = *iso53_rack("ISO53-A");
    const Gear gear = std::move(make_gear(s)).take();
    const auto a = probe_compliance(gear, {2 * kModule, 0.3, 1.0},
                                    {.diameter = gear.reference().reference_diameter},
                                    ComplianceAccuracy::draft);
    ASSERT_EQ(bool(a), teeth == 3);
    if (teeth < 3) {
      EXPECT_EQ(a.error().kind, FailureKind::not_under_load);
    }
  }
}

// The compliance includes the twist of the body. Its closed form is compared with the value that
// the reference prints for this part.
TEST(ToothCompliance, TwistOfTheBodyInClosedForm) {
  EXPECT_NEAR(body_twist(12.5 * std::cos(20 * M_PI / 180), 6.0, 11.25, 0.3), 0.567, 5e-4);
  // The ring is held at its outside. Its rotation is the integral of dφ = M/(2πG) dr/r³, starting
  // at the root.
  constexpr int kSteps = 1000;
  const double step = (33.75 - 31.25) / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) sum += step * std::pow(31.25 + (i + 0.5) * step, -3);
  const double want = 28.0 * 28.0 * 2 * (1 + 0.3) / (2 * M_PI) * sum;
  EXPECT_NEAR(body_twist(28.0, 33.75, 31.25, 0.3), want, 1e-6 * want);
}

// The stiffness of two teeth in contact at the pitch point, for 300 N/mm, m = 5 and rims 4 modules
// thick, without the twist of the bodies. It is compared with independent finite elements and with
// c'_th of ISO 6336-1, which approximates the formulas of Weber and Banaschek.
TEST(ToothCompliance, StiffnessOfAPairIsThatOfTheStandard) {
  struct Row {
    int z1, z2;
    double x1, x2, elements, standard;
  };
  constexpr double kE = 206000.0;
  constexpr double kLoad = 300.0;
  constexpr double kPitchModule = 5.0;
  for (const Row& row : {Row{18, 18, 0.3, 0.3, 16.49, 16.03}, Row{25, 25, 0, 0, 15.71, 15.68},
                         Row{40, 40, 0, 0, 17.39, 17.37}, Row{60, 60, 0, 0, 18.51, 18.48},
                         Row{100, 100, 0, 0, 19.67, 19.47}, Row{25, 100, 0, 0, 17.28, 17.85},
                         Row{20, 60, 0.4, 0.2, 17.57, 18.46}}) {
    const double tan_20 = std::tan(20 * M_PI / 180);
    const double alpha = inverse_involute(tan_20 - 20 * M_PI / 180 +
                                          2 * (row.x1 + row.x2) * tan_20 / (row.z1 + row.z2));
    const double grow = std::cos(20 * M_PI / 180) / std::cos(alpha);
    const double r1 = row.z1 * kPitchModule / 2 * grow;
    const double r2 = row.z2 * kPitchModule / 2 * grow;
    const double curvature = (1 / r1 + 1 / r2) / std::sin(alpha);
    const double half = std::sqrt(4 * kLoad * 2 * (1 - 0.09) / (M_PI * kE * curvature));
    double softness = 0.0;
    for (const auto& [z, x, r] : {std::tuple(row.z1, row.x1, r1), std::tuple(row.z2, row.x2, r2)}) {
      const Gear gear = gear_of(kPitchModule, z, x);
      const double bore = gear.root_diameter - 8 * kPitchModule;
      const auto a =
          probe_compliance(gear, ElasticBody{bore, 0.3, kE},
                           {.diameter = 2 * r, .half_width = half}, ComplianceAccuracy::full);
      ASSERT_TRUE(a) << a.error().message();
      softness +=
          a->own - body_twist(gear.base_radius(), bore / 2, gear.root_diameter / 2, 0.3) / kE;
    }
    const double stiffness = 1e-3 / softness;  // N/(mm µm)
    EXPECT_NEAR(stiffness, row.elements, 0.01 * row.elements) << row.z1 << ':' << row.z2;
    EXPECT_NEAR(stiffness, row.standard, 0.06 * row.standard) << row.z1 << ':' << row.z2;
  }
}

void expect_profile(double twist, double radius, double from, const std::vector<double>& at,
                    const std::vector<double>& want, double share) {
  ComplianceProbe probe{.diameter = 2 * radius * kModule};
  probe.loaded = {kModule * (from - 5), kModule * (from - 4.5)};
  for (const double z : at) probe.read.push_back(kModule * (z - 5));
  const auto a = probe_compliance(gear_of(kModule), twist / kModule, body_of(kModule), probe,
                                  ComplianceAccuracy::full);
  ASSERT_TRUE(a) << a.error().message();
  for (std::size_t i = 0; i < at.size(); ++i) {
    // The reference has no Hertz contact strip, so positions near the load are left out.
    if (std::abs(at[i] - from - 0.25) < 0.9) continue;
    EXPECT_NEAR(a->profile[i] * kModule, want[i], share * a->own * kModule) << from << ' ' << at[i];
  }
}

TEST(ToothCompliance, AlongTheFaceAgreesWithBricks) {
  const std::vector<double> z{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  expect_profile(0, 13.2, 0.0, z,
                 {8.554, 3.449, 1.752, 0.872, 0.427, 0.215, 0.117, 0.073, 0.05, 0.034, 0.017},
                 0.03);
  expect_profile(0, 13.2, 4.5, z,
                 {0.213, 0.406, 0.685, 1.174, 1.995, 3.535, 1.537, 0.875, 0.501, 0.295, 0.152},
                 0.03);
}

// Compliance at the obtuse and acute ends of a helical tooth. Errors are relative to the greatest
// displacement, which occurs under the load.
TEST(ToothCompliance, AlongAHelicalFaceAgreesWithBricks) {
  const double twist = std::tan(20 * M_PI / 180) / 12.5;
  const std::vector<double> z{0, 2, 4, 6, 8, 10};
  expect_profile(twist, 13.2, 0.0, z, {7.053, 1.733, 0.381, 0.1, 0.047, 0.023}, 0.04);
  expect_profile(twist, 13.2, 4.5, z, {0.168, 0.639, 2.172, 1.719, 0.506, 0.133}, 0.04);
  expect_profile(twist, 13.2, 9.5, z, {0.02, 0.049, 0.099, 0.409, 2.094, 13.52}, 0.04);
  expect_profile(twist, 12.5, 4.5, z, {0.114, 0.362, 1.097, 0.883, 0.309, 0.094}, 0.04);
}

// Compliance with a helix angle of 45° at both ends and in the middle of the face, including the
// point under the load. The greatest measured error is 0.9 % of the greatest displacement of a row,
// and 1.8 % at the acute end.
TEST(ToothCompliance, AlongASteepHelixAgreesWithBricks) {
  const auto data = nlohmann::json::parse(
      std::ifstream(testing::source_file("tests/oracle/bricks/tooth_bricks.json")));
  const auto& bricks = data.at("gears").back();
  ASSERT_EQ(bricks.at("helix_angle_deg"), 45);
  CylindricalSpec spec =
      testing::plain_spec({.teeth = data.at("teeth"),
                           .module = kModule,
                           .beta_deg = bricks.at("helix_angle_deg"),
                           .face_width = kModule * data.at("face_width").get<double>()});
  spec.rack = *iso53_rack("ISO53-A");
  const Gear gear = std::move(make_gear(spec)).take();
  const ElasticBody body{kModule * bricks.at("bore_diameter").get<double>(), 0.3, 1.0};
  const auto from_middle = [&](double z) { return kModule * z - spec.face_width / 2; };
  for (const auto& load : bricks.at("loads")) {
    const std::array<double, 2> part = load.at("z");
    ComplianceProbe probe{.diameter = kModule * load.at("diameter").get<double>()};
    probe.loaded = {from_middle(part[0]), from_middle(part[1])};
    for (const double z : data.at("read_z")) probe.read.push_back(from_middle(z));
    const auto a = probe_compliance(gear, body, probe, ComplianceAccuracy::full);
    ASSERT_TRUE(a) << a.error().message();
    const std::vector<double> want = load.at("strip");
    const double peak = *std::max_element(want.begin(), want.end());
    for (std::size_t k = 0; k < want.size(); ++k)
      EXPECT_NEAR(a->profile[k] * kModule, want[k], 0.02 * peak) << part[0] << ' ' << probe.read[k];
  }
}

TEST(ToothCompliance, ScalesWithLength) {
  const auto small =
      probe_compliance(gear_of(3.0), body_of(3.0), {.diameter = 75.0}, ComplianceAccuracy::draft);
  const auto large =
      probe_compliance(gear_of(6.0), body_of(6.0), {.diameter = 150.0}, ComplianceAccuracy::draft);
  ASSERT_TRUE(small && large);
  EXPECT_NEAR(small->own, large->own, 1e-9 * small->own);
}

TEST(ToothCompliance, AMirroredHelixIsMirrored) {
  const Gear gear = gear_of(kModule);
  ComplianceProbe probe{.diameter = 76.0, .loaded = {{-12.0, -9.0}}, .read = {-6.0, 0.0, 6.0}};
  ComplianceProbe mirrored{.diameter = 76.0, .loaded = {{9.0, 12.0}}, .read = {6.0, 0.0, -6.0}};
  const auto draft = ComplianceAccuracy::draft;
  const auto a = probe_compliance(gear, 0.01, body_of(kModule), probe, draft);
  const auto b = probe_compliance(gear, -0.01, body_of(kModule), mirrored, draft);
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(a->own, b->own, 1e-8 * a->own);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a->profile[i], b->profile[i], 1e-8 * a->own);
}

TEST(ToothCompliance, OfOneToothIsSymmetricAndPositive) {
  for (const double twist : {0.0, 0.012}) {
    auto section =
        make_tooth_section(gear_of(kModule), twist, body_of(kModule), ComplianceAccuracy::draft);
    ASSERT_TRUE(section) << section.error().message();
    ToothTableRequest request{.face_width = 10.0, .slices = {12, -5.0, 5.0}, .root_stress = false};
    const ToothTable table(*section, request);
    LinePlaces line;
    for (int j = 0; j < 12; ++j) line.push_back((*section)->s[1] + (twist == 0.0 ? 0.0 : 0.09 * j));
    const Eigen::MatrixXd c = table.same_tooth(line);
    EXPECT_EQ((c - c.transpose()).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_GT(c.eigenvalues().real().minCoeff(), 0.0);
    EXPECT_GT(c.minCoeff(), 0.0);
    // Two neighbouring teeth influence each other equally.
    const Eigen::MatrixXd to = table.other_tooth(1, line, line);
    const Eigen::MatrixXd from = table.other_tooth(-1, line, line);
    EXPECT_LT((to - from.transpose()).cwiseAbs().maxCoeff(), 1e-12 * c.maxCoeff());
  }
}

// A table of some slices contains the same coefficients as a table of all slices of the face.
TEST(ToothCompliance, OfPartOfTheFaceIsPartOfThatOfTheFace) {
  for (const double twist : {0.0, 0.012}) {
    auto section =
        make_tooth_section(gear_of(kModule), twist, body_of(kModule), ComplianceAccuracy::draft);
    ASSERT_TRUE(section) << section.error().message();
    const ToothTable all(*section, {.face_width = 10.0, .slices = {10, -5.0, 5.0}});
    const ToothTable part(*section, {.face_width = 10.0, .slices = {6, -4.0, 2.0}});
    constexpr int kFirst = 1, kCount = 6;
    LinePlaces line;
    for (int j = 0; j < 10; ++j) line.push_back((*section)->s[1] + 0.09 * j);
    const LinePlaces there(line.begin() + kFirst, line.begin() + kFirst + kCount);
    const auto expect_same = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-12 * a.cwiseAbs().maxCoeff());
    };
    expect_same(all.same_tooth(line).block(kFirst, kFirst, kCount, kCount), part.same_tooth(there));
    expect_same(all.other_tooth(1, line, line).block(kFirst, kFirst, kCount, kCount),
                part.other_tooth(1, there, there));
    const auto points = static_cast<Eigen::Index>(all.root().t.size());
    Eigen::MatrixXd of_all = Eigen::MatrixXd::Zero(6 * points, 10);
    Eigen::MatrixXd of_part = Eigen::MatrixXd::Zero(6 * points, kCount);
    all.add_root_stress(0, all.on_grid(TablePlace{line[4], -2.5}), of_all);
    part.add_root_stress(0, part.on_grid(TablePlace{line[4], -2.5}), of_part);
    expect_same(of_all.middleCols(kFirst, kCount), of_part);
  }
}

// Teeth that touch at points can touch at the ends of the face, so the table contains these ends.
TEST(ToothCompliance, AtItsFreeEndsAToothYieldsMoreThanInItsMiddle) {
  auto section =
      make_tooth_section(gear_of(kModule), 0.0, body_of(kModule), ComplianceAccuracy::draft);
  ASSERT_TRUE(section) << section.error().message();
  ToothTableRequest request{.face_width = 5.0, .slices = {8, -2.5, 2.5}, .root_stress = false};
  const ToothTable table(*section, request);
  for (const double s : (*section)->s) {
    const auto own = [&](double z) {
      const Eigen::MatrixXd at = table.on_grid(TablePlace{s, z});
      return table.yield(0, at, at);
    };
    EXPECT_GT(own(0.0), 0.0) << s;
    EXPECT_GT(own(2.5), own(0.0)) << s;
    EXPECT_NEAR(own(-2.5), own(2.5), 1e-9 * own(2.5)) << s;
  }
}

TEST(ToothCompliance, SaysWhatIsWrong) {
  const Gear gear = gear_of(kModule);
  const auto full = ComplianceAccuracy::draft;
  const auto above = probe_compliance(gear, {80.0, 0.3, 1.0}, {.diameter = 75.0}, full);
  ASSERT_FALSE(above);
  EXPECT_EQ(above.error().field, "bore.diameter");
  const auto off = probe_compliance(gear, body_of(kModule), {.diameter = 90.0}, full);
  ASSERT_FALSE(off);
  EXPECT_EQ(off.error().field, "diameter");
  const auto face =
      probe_compliance(gear, body_of(kModule), {.diameter = 75.0, .loaded = {{-20.0, 0.0}}}, full);
  ASSERT_FALSE(face);
  EXPECT_EQ(face.error().field, "z");
}

}  // namespace
}  // namespace gearwright
