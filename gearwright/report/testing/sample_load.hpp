// Results of loaded contact for the tests of report/.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "gearwright/figure/load_scene.hpp"
#include "gearwright/report/testing/sample_contact.hpp"

namespace gearwright::testing {

/// A pair, and the load report on it. The report points to the pair.
struct LoadSample {
  std::shared_ptr<const ParallelPair> pair;
  LoadScene report;
};

/// `crossing` is in degrees. The compliance tables are coarse, and there are few positions.
inline LoadSample load_sample(ParallelPair mounted, std::vector<double> torques, double crossing,
                              bool gear2_drives = false) {
  LoadSample sample;
  sample.pair = std::make_shared<const ParallelPair>(std::move(mounted));
  const Gear& one = sample.pair->gears[0];
  const Gear& two = sample.pair->gears[1];
  ContactErrors errors;
  errors.crossing = Angle::degrees(crossing);
  ContactMount mount = mount_of(*sample.pair, errors);
  mount.gear2_drives = gear2_drives;
  const ContactPair pair({&one, {}}, {&two, {}}, mount);
  LoadRequest request;
  request.torques = std::move(torques);
  request.positions = 10;
  request.slices = {8, 8};
  request.accuracy = ComplianceAccuracy::draft;
  for (std::size_t i = 0; i < 2; ++i) {
    const Gear& gear = sample.pair->gears[i];
    const double held = gear.internal() ? gear.root_diameter + 5 * gear.spec.normal_module
                                        : 0.5 * gear.root_diameter;
    request.bodies[i] = {held, 0.3, 206000.0};
  }
  auto compliance = pair_compliance(one, two, request);
  GW_EXPECTS(static_cast<bool>(compliance));
  sample.report = {{&one, &two},
                   sample.pair.get(),
                   gear2_drives,
                   loaded_contact(pair, one, two, *compliance, request),
                   std::vector<LoadStandard>(request.torques.size(), {17.0, std::nullopt})};
  return sample;
}

inline ParallelPair spur_pair() {
  return sample_pair(sample_gear(25, 3, 0, 0), sample_gear(43, 3, 0, 0, 0.0, -0.1), 102.0);
}

}  // namespace gearwright::testing
