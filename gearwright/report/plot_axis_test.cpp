#include "gearwright/report/plot_axis.hpp"

#include <gtest/gtest.h>

namespace gearwright {
namespace {

TEST(PlotAxisPicture, CarriesValuesToPlaces) {
  const Axis y{-1.0, 3.0, 200.0, 100.0};
  EXPECT_EQ(y(-1.0), 200.0);
  EXPECT_EQ(y(3.0), 100.0);
  EXPECT_EQ(y(1.0), 150.0);
  EXPECT_EQ(y.near(1e9), 0.0);
  EXPECT_EQ(y.near(-1e9), 300.0);
}

}  // namespace
}  // namespace gearwright
