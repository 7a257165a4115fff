#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>
#include <string>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/mesh.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"

namespace gearwright {
namespace {

using testing::ring_body;
using testing::sample_body;

TEST(MeshRefusal, ABoreThatCutsTheRoot) {
  ToothedBody body = sample_body({});  // root radius 20 − 2.5
  body.bore = Bore{36.0};
  auto wide = tessellate(body);
  ASSERT_FALSE(wide);
  EXPECT_EQ(wide.error().field, "bore.diameter");
  EXPECT_EQ(wide.error().value, "36");
  EXPECT_NE(wide.error().message().find("at most 34.998 mm"), std::string::npos)
      << wide.error().message();
  body.bore = Bore{34.998};
  EXPECT_TRUE(tessellate(body));

  body.bore = Bore{30.0, 8.0, 3.5};  // corner at hypot(4, 18.5) = 18.93
  const auto corner = tessellate(body);
  ASSERT_FALSE(corner);
  EXPECT_EQ(corner.error().field, "bore.diameter");
  const double largest = std::floor(2e3 * (std::sqrt(17.499 * 17.499 - 16.0) - 3.5)) / 1e3;
  EXPECT_NE(corner.error().message().find(std::to_string(largest).substr(0, 6)), std::string::npos)
      << corner.error().message();
  body.bore->diameter = largest;
  EXPECT_TRUE(tessellate(body));
  body.bore = Bore{6.0, 36.0, 1.0};
  EXPECT_EQ(tessellate(body).error().field, "bore.keyway_width");
  body.bore = Bore{0.0};
  EXPECT_EQ(tessellate(body).error().field, "bore.diameter");
  body.bore = Bore{20.0, 6.0, -1.0};
  EXPECT_EQ(tessellate(body).error().field, "bore.keyway_depth");
}

TEST(MeshRefusal, WhatIsNoBody) {
  ToothedBody ring = ring_body(40, 2, 0.0, 15, 84);  // roots at 85 mm
  EXPECT_EQ(tessellate(ring).error().field, "bore.diameter");
  ring.bore.reset();
  EXPECT_EQ(tessellate(ring).error().field, "bore.diameter");
  ring.bore = Bore{95.0, 4.0, 2.0};
  EXPECT_EQ(tessellate(ring).error().field, "bore.keyway_width");

  ToothedBody none = sample_body({});
  none.outline.arcs.clear();
  EXPECT_EQ(tessellate(none).error().field, "teeth");

  // The flanks cross at the centre line of the tooth, so the tip is severed.
  ToothedBody severed{"severed", {3, {}}, 0.0, 5.0, std::nullopt, {}};
  const auto corner = [](double x, double y) { return testing::C(x, y); };
  const auto root = std::polar(5.0, kPi / 3);
  testing::append(severed.outline, ArcName::root_fillet,
                  std::make_shared<testing::SampleLine>(root, corner(6, -0.5)), 0, 1);
  testing::append(severed.outline, ArcName::flank,
                  std::make_shared<testing::SampleLine>(corner(6, -0.5), corner(8, 0.0)), 0, 1);
  EXPECT_EQ(tessellate(severed).error().field, "teeth");

  EXPECT_EQ(tessellate(sample_body({.beta = 0.3}), {.chord_tolerance_mm = 1e-9}).error().field,
            "chord_tolerance_mm");
  // Without a helix, the mesh always has few levels along the axis. The tolerance must therefore be
  // rejected because the section would have too many points.
  for (const double tolerance : {1e-12, 1e-100, 1e-300, 5e-324})
    EXPECT_EQ(tessellate(sample_body({}), {.chord_tolerance_mm = tolerance}).error().field,
              "chord_tolerance_mm");
}

}  // namespace
}  // namespace gearwright
