// Another CAD kernel measures balls in the tooth spaces of our STEP solids. Each ball touches both
// flanks at the position that inspection/balls.hpp computes, so the distance from its centre to the
// solid equals the radius of the ball.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>

#include <cmath>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/generated_bodies.hpp"
#include "gearwright/cad/testing/step_reader.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/inspection/balls.hpp"

namespace gearwright {
namespace {

// Permissible distance of the faces from the screw surface. It includes the tolerance of the
// kernel.
constexpr double kSolid = 5e-5;  // mm

CylindricalSpec spec_of(int teeth, double module, double beta_deg, double x) {
  return testing::plain_spec(
      {.teeth = teeth, .module = module, .beta_deg = beta_deg, .x = x, .face_width = 12 * module});
}

TEST(StepMeasured, balls_rest_where_they_are_said_to) {
  for (const CylindricalSpec& spec : {spec_of(20, 2, 0, 0), spec_of(17, 3, 20, 0.3),
                                      spec_of(33, 1.5, -30, -0.1), spec_of(-60, 2, 0, 0)}) {
    Gear gear = testing::taken(make_gear(spec));
    if (gear.internal()) gear = *cut_by_default(gear);
    const auto rim = gear.internal() ? std::optional(Bore{1.1 * gear.root_diameter}) : std::nullopt;
    const auto document =
        step_document({testing::body_of("gear", Result<Gear>(gear), rim)}, "gear.step");
    ASSERT_TRUE(document) << document.error().message();
    const testing::ReadStep read = testing::read_step(document->text);
    ASSERT_EQ(read.solids.size(), 1u);
    const auto sizes = ball_sizes(gear);
    ASSERT_TRUE(sizes);
    const BallSeat seat = testing::taken(ball_in_space(gear, sizes->metric));
    const int z = std::abs(spec.teeth);
    // The first tooth space, and the space opposite to it or next to the opposite position.
    for (const int space : {0, z / 2}) {
      const double angle = (2 * space + 1) * std::acos(-1.0) / z;
      const double r = seat.center_diameter / 2;
      const gp_Pnt center(r * std::cos(angle), r * std::sin(angle), 0.0);
      const BRepExtrema_DistShapeShape gap(BRepBuilderAPI_MakeVertex(center).Vertex(),
                                           read.solids.front());
      ASSERT_TRUE(gap.IsDone());
      EXPECT_NEAR(gap.Value(), seat.ball_diameter / 2, kSolid) << spec.teeth << " " << space;
    }
  }
}

}  // namespace
}  // namespace gearwright
