#include "gearwright/figure/rack_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/gear_shape.hpp"

namespace gearwright {
namespace {

RackPair drawn_pair(double x, double beta, double further) {
  Gear pinion = testing::taken(make_gear({.teeth = 18,
                                          .normal_module = 2,
                                          .helix_angle = Angle::degrees(beta),
                                          .profile_shift = x,
                                          .face_width = 20}));
  const double h = pinion.reference_diameter / 2 + 2 * x + further;
  return testing::taken(mount_rack(std::move(pinion), {.teeth = 9, .height = 10}, h));
}

bool in_section(const Vec2& p, const std::vector<Vec2>& polygon) {
  bool in = false;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      in = !in;
  }
  return in;
}

TEST(RackMeshFigure, flanks_touch_at_the_pitch_point) {
  for (const auto& [x, beta, further] :
       {std::tuple{0.0, 0.0, 0.0}, std::tuple{0.2, 0.0, 0.1}, std::tuple{0.1, 20.0, 0.05}}) {
    const RackPair p = drawn_pair(x, beta, further);
    std::vector<Vec2> section = testing::taken(rack_section(p));
    for (Vec2& point : section) point = rack_place(p) - point;
    EXPECT_EQ(section.front(), section.back());
    const double turn = rack_pinion_rotation(p), step = 2 * M_PI / 18;
    double nearest = 1.0;
    for (int k = -2; k <= 2; ++k)
      for (const Arc& arc : p.pinion.tooth->outline.arcs)
        for (const int side : {+1, -1})
          for (int i = 0; i <= 400; ++i) {
            const Vec2 w = arc.point(i / 400.0);
            const double a = turn + k * step, c = std::cos(a), s = std::sin(a);
            const Vec2 q(c * w.x() - side * s * w.y(), s * w.x() + side * c * w.y());
            nearest = std::min(nearest, (q - Vec2(p.pinion.reference_diameter / 2, 0)).norm());
            // Chords of the fillets deviate by at most 2e-4 mm. A point 1e-3 mm inside the pinion
            // would be an overlap.
            const Vec2 to_axis = 1e-3 * q.normalized();
            EXPECT_FALSE(in_section(q - to_axis, section)) << x << " " << k;
          }
    EXPECT_LT(nearest, 0.01);  // points are at most 0.01 mm apart
    // At C the section has a point on the flank. The rack lies just below C but not just above it.
    const Vec2 C(p.pinion.reference_diameter / 2, 0);
    EXPECT_TRUE(in_section(C - Vec2(0, 1e-6), section));
    EXPECT_FALSE(in_section(C + Vec2(0, 1e-6), section));
  }
}

TEST(RackMeshFigure, is_drawn) {
  const RackPair p = drawn_pair(0.1, 15, 0.05);
  const RackScene scene{&p, {"gear1", "gear2"}};
  const Figure f = rack_mesh_figure(scene, rack_window(scene, MeshFrame::mesh, 1.2));
  const std::string html = figure_html(f, 640);
  for (const char* words : {"href=\"#gear1\"", "href=\"#gear2\"", "action-dot", "body g2"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

TEST(RackMeshFigure, windows_contain_their_parts) {
  const RackPair p = drawn_pair(0.1, 15, 0.05);
  const RackScene scene{&p, {"gear1", "gear2"}};
  const auto contains = [&](MeshFrame frame, const Vec2& point) {
    const Bounds window = rack_window(scene, frame, 1.2);
    EXPECT_NEAR(window.size().x(), 1.2 * window.size().y(), 1e-9);
    return (point - window.lo).minCoeff() > -1e-9 && (window.hi - point).minCoeff() > -1e-9;
  };
  for (const Vec2& point : testing::taken(rack_section(p)))
    EXPECT_TRUE(contains(MeshFrame::whole, rack_place(p) - point));
  EXPECT_TRUE(contains(MeshFrame::whole, Vec2(-p.pinion.actual_tip_radius(), 0)));
  const double alpha = p.pinion.reference().transverse_pressure_angle;
  const Vec2 C(p.pinion.reference_diameter / 2, 0);
  for (const double g : {-p.approach, p.recess})
    EXPECT_TRUE(contains(MeshFrame::flank, C + g * Vec2(std::sin(alpha), -std::cos(alpha))));
}

// If its number of teeth is not given, the rack has at least as many teeth as its pinion, and one
// of them is in the middle.
TEST(RackMeshFigure, endless_rack_has_teeth_about_its_middle) {
  RackPair p = drawn_pair(0.1, 0, 0.05);
  p = testing::taken(mount_rack(std::move(p.pinion), {}));
  const std::vector<Vec2> section = testing::taken(rack_section(p));
  const auto [first, last] = std::minmax_element(
      section.begin(), section.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  EXPECT_NEAR(last->y(), 19 * p.rack.transverse_pitch / 2, 1e-9);
  EXPECT_NEAR(first->y(), -last->y(), 1e-9);
}

}  // namespace
}  // namespace gearwright
