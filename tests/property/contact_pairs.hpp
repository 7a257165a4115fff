// Pairs and functions that several tests of contact use.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "tests/oracle/modified_involutes.hpp"
#include "tests/oracle/numbers.hpp"

namespace gearwright::property {

namespace tca = oracle::tca;
using oracle::BruteContact;
using oracle::contact_set;
using oracle::ContactSet;
using oracle::extent_of;
using oracle::ModifiedPair;
using oracle::random_modified;
using oracle::Wanted;

inline ContactResult over_a_pitch(const ContactPair& pair, int positions, int pitches = 1) {
  ContactRequest request;
  request.positions = positions;
  request.pitches = pitches;
  return analyse_contact(pair, request);
}

inline ContactResult at_rotations(const ContactPair& pair, std::vector<Angle> rotations) {
  ContactRequest request;
  request.rotations = std::move(rotations);
  return analyse_contact(pair, request);
}

/// m = 4, 16 : 48 teeth. If there are no errors, the flanks touch at 30°.
inline tca::ArcPair some_arcs(double crossing = 0.0, double d_center = 0.0) {
  tca::ArcPair p;
  p.teeth_1 = 16, p.teeth_2 = 48;
  p.lead_angle_f = p.lead_angle_p = 70 * oracle::kLongDegree;
  const tca::Real m = 4, sine = std::sin(p.lead_angle_f);
  p.pitch_radius_1 = p.teeth_1 * m / (2 * sine), p.pitch_radius_2 = p.teeth_2 * m / (2 * sine);
  p.f = {1.4L * m, 0.42L * m, 0.24L * m, 12 * oracle::kLongDegree, 52 * oracle::kLongDegree};
  p.p = {1.55L * m, p.f.a + 0.15L * m * std::cos(30 * oracle::kLongDegree),
         p.f.b + 0.15L * m * std::sin(30 * oracle::kLongDegree), 13 * oracle::kLongDegree,
         51 * oracle::kLongDegree};
  p.mounting.center_distance = p.pitch_radius_1 + p.pitch_radius_2;
  p.mounting.crossing = crossing, p.mounting.d_center = d_center;
  p.half_face_1 = p.half_face_2 = 30;
  return p;
}

/// Checks the law over seeded pairs, a third of which are internal, and reports the first pair that
/// violates it.
template <class Law>
void over_pairs(std::uint64_t seed, int pairs, Wanted want, Law law) {
  Random random(seed);
  int held = 0;
  for (int i = 0; held < pairs && i < 20 * pairs; ++i) {
    want.internal = i % 3 == 0;
    const auto p = random_modified(random, want);
    if (!p) continue;
    ++held;
    law(*p, random);
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "seed " << seed << ", draw " << i << p->name
                    << (p->set.mount.gear2_drives ? "\n  gear 2 drives" : "");
      return;
    }
  }
  EXPECT_EQ(held, pairs);
}

}  // namespace gearwright::property
