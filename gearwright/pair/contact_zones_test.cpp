// Laws: (1) zones follow each other without a gap; (2) the number of pairs in each zone is the
// contact ratio rounded up or down.
#include "gearwright/pair/efficiency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gearwright {
namespace {

// The zones of a path that begins at 1.5 mm and is `ratio` pitches of 3 mm long.
std::vector<ContactZone> zones_of_ratio(double ratio) {
  return contact_zones(1.5, 1.5 + ratio * 3.0, 3.0);
}

TEST(ContactZones, LawsHold) {
  for (const double ratio : {0.4, 0.999, 1.0, 1.0001, 1.5, 1.9999, 2.0, 2.3, 3.7}) {
    const auto zones = zones_of_ratio(ratio);
    double at = 1.5;
    double pairs_times_length = 0.0;
    for (const ContactZone& zone : zones) {
      EXPECT_NEAR(zone.begin, at, 1e-8);  // (1)
      EXPECT_LT(zone.begin, zone.end);
      EXPECT_GE(zone.pairs, static_cast<int>(std::floor(ratio))) << ratio;  // (2)
      EXPECT_LE(zone.pairs, static_cast<int>(std::ceil(ratio))) << ratio;
      at = zone.end;
    }
    // Along one pitch from A, the mean number of pairs is the contact ratio.
    for (const ContactZone& zone : zones) {
      const double end = std::min(zone.end, 1.5 + 3.0);
      pairs_times_length += zone.pairs * std::max(0.0, end - zone.begin);
    }
    EXPECT_NEAR(pairs_times_length / 3.0, ratio, 1e-8);
  }
}

TEST(ContactZones, OrdinaryPathHasThree) {
  const auto zones = zones_of_ratio(1.6);
  ASSERT_EQ(zones.size(), 3u);
  EXPECT_EQ(zones[0].pairs, 2);
  EXPECT_EQ(zones[1].pairs, 1);
  EXPECT_EQ(zones[2].pairs, 2);
}

}  // namespace
}  // namespace gearwright
