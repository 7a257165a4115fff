#include "gearwright/tool/straight_rack.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gearwright {
namespace {

TEST(AgmaRack, WholeDepthAndRoundingOfTheToothSystems) {
  for (const auto& [name, depth] :
       {std::pair{"AGMA-14.5", 2.157}, {"AGMA-20", 2.25}, {"AGMA-25", 2.25}, {"AGMA-stub", 1.8}}) {
    const AgmaRack* rack = agma_rack(name);
    ASSERT_NE(rack, nullptr) << name;
    EXPECT_NEAR(rack->rack.addendum + rack->rack.dedendum, depth, 1e-12) << name;
    EXPECT_LT(rack->rack.root_fillet_radius, full_radius(rack->rack, rack->normal_pressure_angle));
  }
  EXPECT_EQ(agma_rack("AGMA-30"), nullptr);
  EXPECT_EQ(agma_rack("ISO53-A"), nullptr);
}

}  // namespace
}  // namespace gearwright
