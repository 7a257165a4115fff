#include "gearwright/report/k_diagram.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gearwright {
namespace {

// A helix without modification is a flat trace. Its diagram has a scale of micrometres, not of
// rounding errors.
TEST(KDiagram, AFlatTraceHasAReadableScale) {
  const FlankTrace flat{{{-15.0, 0.0}, {15.0, 0.0}}, {-13.5, 13.5}, {}};
  const FlankTrace relieved{{{4.0, 0.0}, {18.0, 0.0}, {20.0, -12.0}}, {4.0, 19.2}, {}};
  const std::string text = k_figures({{"Gear 1", relieved, flat}});
  EXPECT_EQ(text.find("0.000"), text.npos);
  EXPECT_NE(text.find(">−10<"), text.npos);
  EXPECT_NE(text.find(">0.6<"), text.npos);
}

}  // namespace
}  // namespace gearwright
