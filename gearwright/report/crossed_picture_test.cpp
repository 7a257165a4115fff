#include "gearwright/report/crossed_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright {
namespace {

TEST(CrossedPicture, FacesLieAcrossTheirAxes) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    for (const std::size_t i : {0u, 1u}) {
      const double radius = pair.gears[i].actual_tip_radius();
      const auto c = face_in_plan(pair, i, radius);
      // The corners of the cylinder, computed in space and moved by the pose of the gear.
      const double half = pair.input.face_width[i] / 2;
      const Vec3 axis = i == 0 ? Vec3(pair.pose_1().isometry().linear().col(2))
                               : Vec3(pair.pose_2().isometry().linear().col(2));
      const Vec2 end = half * Vec2(axis.y(), axis.z());
      EXPECT_LT(((c[2] + c[3]) / 2 - end).norm(), 1e-9);
      EXPECT_LT(((c[0] + c[1]) / 2 + end).norm(), 1e-9);
      EXPECT_NEAR((c[1] - c[0]).norm(), 2 * radius, 1e-9);
      EXPECT_NEAR((c[1] - c[0]).dot(end), 0.0, 1e-9 * radius * half);
    }
  }
}

TEST(CrossedPicture, LinesStandSquareOnTheTeeth) {
  for (const CrossedPair& pair : testing::crossed_pairs()) {
    const Mesh<double>& m = pair.mesh;
    const Vec2 along =
        in_plan(pair.on_line_of_action(m.rho1_C + 1.0)) - in_plan(pair.on_line_of_action(m.rho1_C));
    const auto& side = m.rack.sides[0];
    const Vec2 teeth(std::sin(side.helix_angle), std::cos(side.helix_angle));
    EXPECT_NEAR(along.dot(teeth), 0.0, 1e-10 * along.norm());
    // A half turn about the centre line maps the leading line to the trailing line.
    EXPECT_LT((in_plan(pair.on_trailing_line(m.rho1_E)) + in_plan(pair.on_line_of_action(m.rho1_E)))
                  .norm(),
              1e-12);
  }
}

TEST(CrossedPicture, EveryLetterOnce) {
  const std::string text = plan_part(testing::crossed_pair());
  const auto count = [&](const std::string& letter) {
    std::size_t n = 0;
    const std::string tspan = ">" + letter + "</tspan>";
    for (std::size_t at = text.find(tspan); at != text.npos; at = text.find(tspan, at + 1)) ++n;
    return n;
  };
  for (const char* letter : {"A", "E", "C", "A′", "E′"}) EXPECT_EQ(count(letter), 1u) << letter;
  EXPECT_EQ(count("T"), 4u);
}

}  // namespace
}  // namespace gearwright
