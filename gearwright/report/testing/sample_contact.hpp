// Contact results of sample pairs, for the tests of report/.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/report/contact_report.hpp"
#include "gearwright/report/testing/sample_reports.hpp"

namespace gearwright::testing {

/// Gears, their pair, and the contact report on it. The report points to the gears.
struct ContactSample {
  std::shared_ptr<const std::array<Gear, 2>> gears;
  std::shared_ptr<const ContactPair> pair;
  ContactReport report;
};

inline ContactSample contact_sample(const std::array<Gear, 2>& gears, ContactMount mount,
                                    int positions = 32) {
  ContactSample sample;
  sample.gears = std::make_shared<const std::array<Gear, 2>>(gears);
  const auto turned = [&](bool other) {
    ContactMount place = mount;
    place.gear2_drives = mount.gear2_drives != other;
    return ContactPair({&(*sample.gears)[0], {}}, {&(*sample.gears)[1], {}}, place);
  };
  sample.pair = std::make_shared<const ContactPair>(turned(false));
  const ContactPair& pair = *sample.pair;
  ContactReport& r = sample.report;
  constexpr double kMarking = 0.00635;
  const ContactRequest request{positions, 1, kMarking};
  static_cast<ContactScene&>(r) = contact_scene({&(*sample.gears)[0], &(*sample.gears)[1]}, pair,
                                                kMarking, analyse_contact(pair, request));
  r.other = analyse_contact(turned(true), request);
  r.min_play = Angle::radians(0.001);
  r.patterns = contact_pattern(pair, positions, {17, 33});
  r.middle = r.driving.positions[static_cast<std::size_t>(positions / 2)];
  r.middle_gap = gap_map(pair, r.middle->rotation1, r.middle->pair, {17, 33});
  r.errors = {{"out-of-plane shaft deviation", 0.02, "°"}};
  r.under = {{"no error", r.patterns[0], Angle(), false},
             {"as specified", r.patterns[0], Angle::radians(1e-5), true}};
  return sample;
}

inline ContactMount mount_of(const InvolutePair& pair, const ContactErrors& errors = {}) {
  return {pair.center_distance, pair.axis_angle(), false, errors};
}

/// Returns a pair 17/43. Its axes are crossed by 0.02°, so that an edge is in contact at all
/// positions.
inline ContactSample helical_contact() {
  const InvolutePair pair = helical_pair();
  ContactErrors errors;
  errors.crossing = Angle::degrees(0.02);
  return contact_sample({pair.gears[0], pair.gears[1]}, mount_of(pair, errors));
}

/// Crossed helical gears with every kind of error. They have point contact.
inline ContactSample crossed_contact(bool gear2_drives = false) {
  const InvolutePair pair = left_hand_pair();
  ContactMount mount =
      mount_of(pair, {0.05, Angle::radians(1e-3), Angle::radians(-7e-4), 0.3, {1e-6, -2e-6}, {}});
  mount.gear2_drives = gear2_drives;
  return contact_sample({pair.gears[0], pair.gears[1]}, mount);
}

inline ContactSample ring_contact(bool gear2_drives = false) {
  const InvolutePair pair = pinion_in_cut_ring();
  ContactMount mount =
      mount_of(pair, {0.0, Angle::radians(3e-4), Angle::radians(2e-4), 0.4, {}, {}});
  mount.gear2_drives = gear2_drives;
  return contact_sample({pair.gears[0], pair.gears[1]}, mount);
}

/// Returns a pair without errors. Its flanks are conjugate and touch along lines.
inline ContactSample perfect_contact() {
  const InvolutePair pair = helical_pair();
  ContactSample s = contact_sample({pair.gears[0], pair.gears[1]}, mount_of(pair));
  s.report.errors.clear();
  s.report.under.clear();
  return s;
}

}  // namespace gearwright::testing
