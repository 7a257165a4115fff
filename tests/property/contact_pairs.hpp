// Pairs and functions that several tests of contact use.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "tests/oracle/modified_involutes.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/property/random_crossed.hpp"

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

/// A random pair on crossed axes with errors of mounting, internal or external. The contact ratio
/// exceeds 1. Returns nothing if the draw does not give such a pair.
inline std::optional<ContactSet> random_crossed_set(Random& random, bool internal) {
  CrossedSpecs specs;
  std::optional<CrossedPair> p;
  if (internal) {
    p = crossed_pair_with_ring(random, 0.05, specs);
  } else {
    specs = random_crossed(random, 3.0);
    p = mounted(specs, 0.2 * random.unit());
  }
  if (!p || !p->gears[0].root_form_radius() || !p->gears[1].root_form_radius()) return std::nullopt;
  if (!(p->mesh.true_ratio > 1.05)) return std::nullopt;
  ContactSet set = contact_set(*p, random.chance(0.4));
  auto& e = set.mount.errors;
  e.center_distance = 0.02 * p->side() * random.unit();
  e.crossing = Angle::radians(random.uniform(-1e-4, 1e-4));
  e.intersecting = Angle::radians(random.uniform(-1e-4, 1e-4));
  e.axial = random.uniform(-0.05, 0.05);
  return set;
}

/// A pinion and its rack with errors of mounting. Both flanks of the pinion may be modified.
struct RackSet {
  RackPair rack;
  std::shared_ptr<const RemovalField> removal{};
  ContactMount mount;

  ContactPair pair() const {
    return ContactPair({&rack.pinion, {removal.get(), removal.get()}}, rack.rack, mount);
  }
};

/// A pinion with a rack. If `whole_path`, the flank of the rack touches the involute of the pinion
/// along its whole path of contact, as the gears of over_pairs() do. If the flank of the pinion
/// began within the path, the curve would jump there. Returns nothing if the draw does not give such
/// a pair.
inline std::optional<RackSet> random_rack_set(Random& random, bool modified, bool whole_path) {
  CylindricalSpec spec = random_pair(random, false).first;
  spec.profile_shift = std::abs(spec.profile_shift);
  const auto pinion = make_gear(spec);
  if (!pinion || !pinion->root_form_radius()) return std::nullopt;
  auto rack = mount_rack(*pinion, {});
  if (!rack) return std::nullopt;
  if (whole_path &&
      (!(rack->true_contact_ratio() > 1.05) || rack->true_approach < rack->approach - 1e-9 ||
       rack->true_recess < rack->recess - 1e-9))
    return std::nullopt;
  RackSet set{std::move(rack).take(), {}, {}};
  set.mount.center_distance = set.rack.center_distance;
  set.mount.gear2_drives = random.chance(0.4);
  auto& e = set.mount.errors;
  e.center_distance = 0.02 * spec.normal_module * random.unit();
  e.crossing = Angle::radians(random.uniform(-1e-4, 1e-4));
  e.intersecting = Angle::radians(random.uniform(-1e-4, 1e-4));
  e.axial = random.uniform(-0.05, 0.05);
  if (!modified || random.chance(0.3)) return set;
  const FlankExtent extent = extent_of(set.rack.pinion);
  const auto amount = [&] { return spec.normal_module * random.logarithmic(1e-5, 8e-3); };
  FlankModifications f;
  const double depth = extent.rho_tip_form - extent.rho_root_form;
  f.tip_relief = {amount(), 2 * (extent.rho_tip_form - depth * random.uniform(0.1, 0.5)),
                  random.chance(0.5) ? ReliefShape::linear : ReliefShape::parabolic};
  if (random.chance(0.5)) f.lead_crowning = amount();
  if (random.chance(0.5))
    f.end_relief = {amount(), extent.face_width * random.uniform(0.05, 0.45), ReliefShape::linear};
  auto field = make_removal_field(f, extent);
  if (!field) return std::nullopt;
  set.removal = std::make_shared<RemovalField>(std::move(field).take());
  return set;
}

/// The number of pairs of each kind over which a law is checked.
struct Counts {
  int parallel, crossed, racks;
  bool whole_path = true;  ///< of the racks, see random_rack_set()
};

/// Checks the law over the gears of over_pairs(), pairs on crossed axes, half of them internal, and
/// pinions with racks. No flank on crossed axes is modified. The law has two parameters, a
/// ContactSet or a RackSet, and a Random.
template <class Law>
void over_sets(std::uint64_t seed, const Counts& counts, const Wanted& want, Law law) {
  over_pairs(seed, counts.parallel, want,
             [&](const ModifiedPair& p, Random& random) { law(p.set, random); });
  const auto over = [&](int wanted, const auto& draw, const auto& describe_set) {
    Random random(seed);
    int held = 0;
    for (int i = 0; held < wanted && i < 20 * wanted; ++i) {
      const auto set = draw(random, held);
      if (!set) continue;
      ++held;
      law(*set, random);
      if (::testing::Test::HasFailure()) {
        ADD_FAILURE() << "seed " << seed << ", draw " << i << ", " << describe_set(*set);
        return;
      }
    }
    EXPECT_EQ(held, wanted);
  };
  over(
      counts.crossed, [](Random& r, int held) { return random_crossed_set(r, held % 2 == 0); },
      [](const ContactSet& set) {
        return "crossed axes, teeth " + std::to_string(set.gears[0].spec.teeth) + " and " +
               std::to_string(set.gears[1].spec.teeth);
      });
  over(
      counts.racks,
      [&](Random& r, int) { return random_rack_set(r, want.modifications, counts.whole_path); },
      [](const RackSet& set) { return "a rack and" + describe(set.rack.pinion.spec); });
}

/// Checks the law over the contacts of over_sets(), also those of undercut pinions with racks.
template <class Law>
void over_contacts(std::uint64_t seed, int pairs, Law law) {
  over_sets(seed, {pairs, pairs, pairs / 3, false}, {},
            [&](const auto& set, Random&) { law(set.pair()); });
}

}  // namespace gearwright::property
