// Compares the plane teeth, which are the reference for the engine, with independent reference
// computations (gmsh, up to 68 000 unknowns, E = 1, m = 1, ν = 0.3; 25 teeth, x = 0, rack
// 1.25/0.38, bore radius 6 m), and with closed forms.
#include "tests/oracle/plane_teeth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/gear/testing/plain_spec.hpp"
#include "tests/oracle/plane_pair.hpp"
#include "tests/oracle/plane_section.hpp"

namespace gearwright::oracle {
namespace {

Gear gear_of(int teeth) {
  CylindricalSpec s = testing::plain_spec({.teeth = teeth, .module = 1.0, .face_width = 10});
  s.rack = *iso53_rack("ISO53-A");
  return std::move(make_gear(s)).take();
}

TEST(PlaneTeeth, YieldAndRootStressAreThoseOfOthers) {
  const PlaneGear gear = plane_section(gear_of(25), 12, 1);
  struct Row {
    double radius, yield, root;
  };
  for (const Row& row :
       {Row{13.4, 13.324, 3.57}, Row{12.5, 7.247, 2.414}, Row{11.9, 5.5155, 2.243}}) {
    const PlaneAnswer a = plane_teeth(gear, {{0, row.radius, 0.05}}, 1.5);
    EXPECT_NEAR(a.yield(0, 0), row.yield, 0.002 * row.yield);
    EXPECT_NEAR(a.root_stress(0, Eigen::VectorXd::Ones(1)), row.root, 0.01 * row.root);
  }
}

// The deflection of one tooth under a load on another tooth is symmetric, except for the effect of
// the strip widths.
TEST(PlaneTeeth, AreSymmetric) {
  const PlaneAnswer a =
      plane_teeth(plane_section(gear_of(25), 12, 2), {{0, 13.0, 0.05}, {1, 12.1, 0.05}});
  EXPECT_NEAR(a.yield(0, 1), a.yield(1, 0), 1e-3 * a.yield(0, 1));
}

// PAIR2D-25: two gears of triangles in node-to-node contact, without a formula of Hertz; E = 206
// 000, m = 3, 100 N/mm; µm along the line of action.
TEST(PlaneTeeth, PairsShareAsOthersDo) {
  const double base = 12.5 * std::cos(20 * M_PI / 180);
  const double pitch = 2 * M_PI * base / 25;
  PlanePair pair{plane_section(gear_of(25), 12, 1), plane_section(gear_of(25), 12, 1), base, base,
                 25 * std::sin(20 * M_PI / 180)};
  pair.last = std::sqrt(13.5 * 13.5 - base * base);
  const double unit = 100.0 / 206000 * 1e3;  // F′/E, µm
  for (const auto& [phase, approach, share] :
       {std::tuple(0.05, 5.0349, 0.4248), {0.5, 4.9852, 0.5577}, {0.8, 7.3547, 1.0}}) {
    const PlaneShare a = plane_share(pair, 1.8963 + phase * pitch, unit * 1e-3 / 3, 1.5);
    EXPECT_NEAR(a.approach * unit, approach, 0.007 * approach) << phase;
    EXPECT_NEAR(a.share.front(), share, 0.003) << phase;
  }
}

}  // namespace
}  // namespace gearwright::oracle
