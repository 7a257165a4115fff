// Laws of the inputs of a drive: (1) an input that absorbs power is reported; (2) reversed speeds and
// torques have the same flow; (3) the torque of a single input has the sign of its speed; (4) no
// speed is without an input.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "gearwright/drive/testing/simple_set.hpp"

namespace gearwright {
namespace {

using testing::error_field;
using testing::made;
using testing::simple_set;

// Without losses, the torques of sun and ring are in the ratio 24 : 60. At speeds of 1500/min and
// −700/min, the ring therefore takes 7/6 of the power of the sun, and the carrier must deliver the
// rest.
TEST(DriveInputs, AnInputThatAbsorbsPowerIsReported) {
  PlanetarySpec set = simple_set(24, 18, 60, 1.0, 1.0);
  set.fixed = std::vector<std::string>{};
  set.inputs = {"sun", "ring"};
  const auto reported = [&](double ring_rpm) {
    set.speeds_rpm = {1500, ring_rpm};
    std::string text;
    for (const Warning& w : made(set).findings)
      if (w.code == WarningCode::power_against_input) text += w.message;
    return text;
  };
  EXPECT_EQ(reported(700), "");
  EXPECT_EQ(
      reported(-700),
      "The input ring absorbs 100.00 % of the power that flows in, because its torque and its "
      "speed have opposite signs. The output carrier delivers power to the drive.");
  EXPECT_NE(reported(-400).find("The input ring absorbs 66.67 % of the power"), std::string::npos);
}

// If all speeds and torques are reversed, the directions of all powers remain. The power that flows
// in is always greater than the power that flows out. Without a torque, the first input delivers
// power.
TEST(DriveInputs, ReversedInputsHaveTheSameFlow) {
  PlanetarySpec set = simple_set(24, 18, 60, 0.98, 0.98);
  set.fixed = std::vector<std::string>{};
  set.inputs = {"sun", "ring"};
  const auto flow = [&](double sense, std::optional<double> torque) {
    set.speeds_rpm = {sense * 1500, sense * 300};
    set.torque_Nm = torque;
    return made(set).flow.value();
  };
  const auto same = [](const PowerFlow& a, const PowerFlow& b) {
    return a.efficiency == b.efficiency && a.driver == b.driver && a.torque == b.torque;
  };
  const PowerFlow forward = flow(1, 60), against = flow(1, -60);
  EXPECT_TRUE(same(flow(-1, -60), forward));
  EXPECT_TRUE(same(flow(1, std::nullopt), forward));
  EXPECT_TRUE(same(flow(-1, std::nullopt), forward));
  EXPECT_TRUE(same(flow(-1, 60), against));
  // If sun and planet drive, T_ring = 60/24 η² T_sun. If planet and ring drive,
  // T_ring = 60/24 T_sun/η².
  const auto bodies = made(set).graph.bodies;
  const auto ring = static_cast<std::size_t>(std::ranges::find(bodies, "ring", &DriveBody::name) -
                                             bodies.begin());
  EXPECT_NEAR(forward.torque.at(ring), 2.5 * 0.98 * 0.98, 1e-12);
  EXPECT_NEAR(against.torque.at(ring), 2.5 / (0.98 * 0.98), 1e-12);
  for (const PowerFlow& one : {forward, against}) {
    EXPECT_GT(one.efficiency, 0.98);
    EXPECT_LT(one.efficiency, 1.0);
  }
}

// The torque and the speed of a single input have the same sign, because power flows in.
TEST(DriveInputs, ASingleInputDrives) {
  PlanetarySpec set = simple_set(24, 18, 60, 0.98, 0.99);
  for (const double speed : {1500.0, -1500.0}) {
    for (const double torque : {40.0, -40.0}) {
      set.speeds_rpm = {speed};
      set.torque_Nm = torque;
      EXPECT_EQ(error_field(set), speed * torque > 0.0 ? "" : "drive.torque") << speed << torque;
    }
  }
}

// Regression: a second speed of a drive with one input removed all speeds from the results.
TEST(DriveInputs, EverySpeedHasAnInput) {
  PlanetarySpec set = simple_set(24, 18, 60, 0.98, 0.99);
  set.speeds_rpm = {1500, 20};
  EXPECT_EQ(error_field(set), "drive.speed");
  set.fixed = std::vector<std::string>{};
  set.inputs = {"sun", "ring"};
  EXPECT_EQ(error_field(set), "");
  set.speeds_rpm = {1500};  // was ignored, so the drive had no speeds
  EXPECT_EQ(error_field(set), "drive.speed");
}

}  // namespace
}  // namespace gearwright
