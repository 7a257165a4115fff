// A family under torque that is quick to compute, for the tests of this room.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/scatter/loaded_family.hpp"

namespace gearwright::testing {

/// `torques` in N mm.
inline LoadedFamily loaded_family(const ContactSetup& setup, std::vector<double> torques,
                                  int samples) {
  LoadRequest request;
  request.torques = std::move(torques);
  request.positions = 4;
  request.slices = {8, 8};
  request.accuracy = ComplianceAccuracy::draft;
  request.root_stress = false;
  for (const int which : {1, 2})
    request.bodies[which - 1] = {0.5 * setup.gear(which).root_diameter, 0.3, 206000.0};
  auto compliance = pair_compliance(setup.gear(1), setup.gear(2), request);
  EXPECT_TRUE(compliance);
  return {std::move(compliance).take(), request, samples};
}

}  // namespace gearwright::testing
