// The deflection, the slope and the twist of stepped shafts are compared with brick elements of
// CalculiX (tests/oracle/shafts), which know neither Cowper's shear coefficient nor plane sections.
//
// A shaft without steps shows the error of the theory of beams alone. Behind a step, the material
// outside of a cone of about 30° carries nearly no load, so stepped shafts bend more than their
// sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/compliance/shaft.hpp"

namespace gearwright {
namespace {

struct BrickShaft {
  Shaft shaft;
  ShaftLoad load;
  double torque, body;  // the diameter of the face is that of the gear
  std::vector<double> z, w, slope, face_z, twist;
};

std::vector<double> scaled_list(const nlohmann::json& list, double factor) {
  std::vector<double> scaled = list;
  for (double& x : scaled) x *= factor;
  return scaled;
}

BrickShaft brick_shaft(const std::string& name) {
  const auto data = nlohmann::json::parse(
      std::ifstream(testing::source_file("tests/oracle/shafts/stepped_shafts.json")));
  const auto& all = data.at("shafts");
  const auto one =
      std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.at("name") == name; });
  BrickShaft b;
  b.shaft.bearings = one->at("bearings");
  b.shaft.diameters = one->at("diameters").get<std::vector<double>>();
  b.shaft.steps = one->at("steps").get<std::vector<double>>();
  b.shaft.youngs_modulus = data.at("youngs_modulus");
  b.shaft.poisson_ratio = data.at("poisson_ratio");
  b.load = {one->at("force"), one->at("moment"), one->at("face")[0], one->at("face")[1]};
  b.torque = data.at("torque");
  const auto step = std::upper_bound(b.shaft.steps.begin(), b.shaft.steps.end(), b.load.lo);
  b.body = b.shaft.diameters[static_cast<std::size_t>(step - b.shaft.steps.begin())];
  b.z = scaled_list(one->at("z"), 1.0);
  b.w = scaled_list(one->at("w_um"), 1e-3);
  b.slope = scaled_list(one->at("slope_urad"), 1e-6);
  b.face_z = scaled_list(one->at("face_z"), 1.0);
  b.twist = scaled_list(one->at("twist_urad"), 1e-6);
  return b;
}

// The greatest difference between two lists, divided by the greatest value of the second list.
double brick_difference(const std::vector<double>& ours, const std::vector<double>& bricks) {
  double most = 0.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    most = std::max(most, std::abs(bricks[i]));
    apart = std::max(apart, std::abs(ours[i] - bricks[i]));
  }
  return apart / most;
}

struct BrickDifferences {
  double w, slope, twist;
};
BrickDifferences differences_of(const BrickShaft& b, const Shaft& shaft) {
  const ShaftDeflection found = shaft_deflection(shaft, b.load, b.z);
  auto twist = shaft_twist(shaft, b.torque, b.body, b.load.lo, b.load.hi, b.face_z);
  const double end = twist.back();
  for (double& x : twist) x -= end;
  return {brick_difference(found.w, b.w), brick_difference(found.slope, b.slope),
          brick_difference(twist, b.twist)};
}

// Replaces each step by many small ones, so that the diameter behind it grows along a cone with
// half of this angle between its generatrix and the axis.
Shaft with_cones(const Shaft& shaft, double angle) {
  constexpr int kParts = 40;
  Shaft cones = shaft;
  cones.steps.clear();
  cones.diameters = {shaft.diameters.front()};
  for (std::size_t i = 0; i < shaft.steps.size(); ++i) {
    const double from = shaft.diameters[i];
    const double to = shaft.diameters[i + 1];
    const double length = std::abs(to - from) / 2 / std::tan(angle);
    const double begin = to > from ? shaft.steps[i] : shaft.steps[i] - length;
    for (int k = 0; k < kParts; ++k) {
      cones.steps.push_back(begin + length * (k + 0.5) / kParts);
      cones.diameters.push_back(from + (to - from) * (k + 1) / kParts);
    }
  }
  return cones;
}

// The difference consists of 0.2 % due to the width of the bearings in the bricks, and 0.25 % due
// to the displacements at the bearings, where sections do not remain plane.
TEST(ShaftBricks, PlainShaft) {
  const BrickShaft b = brick_shaft("plain");
  const BrickDifferences d = differences_of(b, b.shaft);
  EXPECT_LT(d.w, 0.005);
  EXPECT_LT(d.slope, 0.004);
  EXPECT_LT(d.twist, 1e-4);
}

TEST(ShaftBricks, SteppedShaftsBendMoreThanTheirSections) {
  for (const char* name : {"between the bearings", "overhung"}) {
    SCOPED_TRACE(name);
    const BrickShaft b = brick_shaft(name);
    const BrickDifferences d = differences_of(b, b.shaft);
    EXPECT_LT(d.w, 0.09);
    EXPECT_LT(d.slope, 0.10);
    const BrickDifferences cones = differences_of(b, with_cones(b.shaft, std::numbers::pi / 6));
    EXPECT_LT(cones.w, 0.02);
    EXPECT_LT(cones.slope, 0.025);
    RecordProperty("w", std::to_string(d.w) + " " + std::to_string(cones.w));
    RecordProperty("slope", std::to_string(d.slope) + " " + std::to_string(cones.slope));
  }
}

// The torque enters a face through its whole section, or through a thinner section at a step. In the
// second case, the rim of the end twists less than the section.
TEST(ShaftBricks, TwistOfTheFace) {
  const BrickShaft whole = brick_shaft("overhung");
  EXPECT_LT(differences_of(whole, whole.shaft).twist, 1e-4);
  const BrickShaft stepped = brick_shaft("between the bearings");
  EXPECT_LT(std::abs(stepped.twist.front()),
            shaft_twist(stepped.shaft, stepped.torque, stepped.body, -20, 20, {20}).front());
  EXPECT_LT(differences_of(stepped, stepped.shaft).twist, 0.4);
}

}  // namespace
}  // namespace gearwright
