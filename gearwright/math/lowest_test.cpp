#include "gearwright/math/lowest.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearwright {
namespace {

TEST(PlaceOfLeast, is_found_inside_and_at_both_ends) {
  for (const double at : {-0.7, 0.0, 0.123456, 0.99}) {
    const auto f = [at](double x) { return std::cosh(x - at); };
    EXPECT_NEAR(place_of_least(f, -1.0, 1.0), at, 2e-8);
  }
  EXPECT_NEAR(place_of_least([](double x) { return x; }, -1.0, 1.0), -1.0, 1e-9);
  EXPECT_NEAR(place_of_least([](double x) { return -x; }, -1.0, 1.0), 1.0, 1e-9);
}

TEST(PlaceOfLeast, finds_a_corner) {
  const auto f = [](double x) { return std::abs(x - 0.3) + 0.2 * x; };
  EXPECT_NEAR(place_of_least(f, -1.0, 2.0), 0.3, 1e-8);
}

}  // namespace
}  // namespace gearwright
