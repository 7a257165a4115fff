// Compares the leaf formulas with the reference geometry, which computes the same numbers with
// other formulas.
#include "gearwright/gear/leaf_formulas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/gear/reference.hpp"

namespace gearwright {
namespace {

using testing::kDegree;
using testing::kEps;

// tan β_b is computed from sin β, as in the SIMD lanes, and from the angle of the reference
// geometry.
TEST(LeafFormulas, base_helix_without_an_angle) {
  for (const double alpha : {14.5, 20.0, 30.0}) {
    for (double beta = -85.0; beta <= 85.0; beta += 5.0) {
      const auto g = reference_geometry(
          ReferenceInput<double>{17, 1.0, alpha * kDegree, beta * kDegree, 0.0, 0.0});
      const double tan_b =
          leaf::tan_of_base_helix(std::sin(beta * kDegree), std::cos(beta * kDegree),
                                  std::cos(g.transverse_pressure_angle));
      const double expected = std::tan(g.base_helix_angle);
      EXPECT_NEAR(tan_b, expected, 64 * kEps * std::abs(expected)) << alpha << " " << beta;
    }
  }
}

TEST(LeafFormulas, undercut_begins_where_the_flank_does_on_the_base_circle) {
  for (const int z : {1, 5, 17, 40}) {
    const double sin_t = std::sin(21.0 * kDegree);
    const double cos_beta = std::cos(17.0 * kDegree);
    const double x = leaf::undercut_limit<double>(1.1, z, sin_t, cos_beta);
    const double r = z / (2 * cos_beta);
    EXPECT_NEAR(leaf::flank_start(r, sin_t, 1.1, x), 0.0, 8 * kEps * (1 + r)) << z;
  }
}

TEST(LeafFormulas, inside_the_base_circle) {
  EXPECT_EQ(leaf::curvature_at(5.0, 4.0), 3.0);
  EXPECT_EQ(leaf::curvature(5.0, 4.0), 3.0);
  EXPECT_EQ(leaf::curvature_at(4.0, 5.0), 0.0);
  EXPECT_TRUE(std::isnan(leaf::curvature(4.0, 5.0)));
}

TEST(LeafFormulas, no_number_gives_the_second) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(leaf::max_of(nan, 1.0), 1.0);
  EXPECT_TRUE(std::isnan(leaf::max_of(1.0, nan)));
  EXPECT_EQ(leaf::min_of(nan, 1.0), 1.0);
  EXPECT_TRUE(std::isnan(leaf::min_of(1.0, nan)));
}

}  // namespace
}  // namespace gearwright
