// Pairs for the tests of contact/: involute gears, external or internal, and circular-arc gears.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::testing {

struct SamplePair {
  std::array<Gear, 2> gears;
  std::array<std::shared_ptr<const RemovalField>, 2> removal{};  ///< the same field for both flanks
  ContactMount place;

  ContactPair pair() const {
    return ContactPair({&gears[0], {removal[0].get(), removal[0].get()}},
                       {&gears[1], {removal[1].get(), removal[1].get()}}, place);
  }
  void modify(int gear, const FlankModifications& m) {
    const Gear& g = gears[gear - 1];
    auto field = make_removal_field(m, {g.involute() ? g.base_radius() : 0.0, *g.root_form_radius(),
                                        g.tip_form_radius(), g.spec.face_width});
    ASSERT_TRUE(field) << field.error().message();
    removal[gear - 1] = std::make_shared<RemovalField>(std::move(field).take());
  }
};

inline Gear involute_gear(int teeth, double helix_deg, double face) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 2.0, .beta_deg = helix_deg, .face_width = face});
  s.rack = *iso53_rack("ISO53-A");
  Gear g = std::move(make_gear(s)).take();
  return g.internal() ? *cut_by_default(g) : g;
}

/// A pair with m = 2 mm, no backlash and faces of 20 and 18 mm. If z2 < 0, gear 2 is internal.
inline SamplePair involutes(int z1, int z2, double helix_deg) {
  SamplePair p{
      {involute_gear(z1, helix_deg, 20), involute_gear(z2, z2 < 0 ? helix_deg : -helix_deg, 18)},
      {},
      {}};
  p.place.center_distance =
      std::abs(p.gears[1].reference_diameter + (z2 < 0 ? -1 : 1) * p.gears[0].reference_diameter) /
      2;
  return p;
}

/// A pair cut by the racks F and P, with 16 and 48 teeth, m_n = 4 mm, β = 20° and face widths of
/// 1.3 axial pitches.
inline SamplePair arcs() {
  const auto gear = [](int teeth, double helix_deg, ArcRack::Cutter cutter) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = teeth, .module = 4.0, .beta_deg = helix_deg, .face_width = 48.0});
    // ψ_c = 30°, as in the examples of the paper.
    const bool convex = cutter == ArcRack::Cutter::F;
    ArcRack rack = default_arc_rack(cutter);
    rack.arc_radius = convex ? 1.4 : 1.55;
    rack.center_a = convex ? 0.42 : 0.42 + 0.15 * std::sqrt(0.75);
    rack.center_b = convex ? 0.24 : 0.24 + 0.15 * 0.5;
    s.rack = rack;
    return std::move(make_gear(s)).take();
  };
  SamplePair p{{gear(16, 20, ArcRack::Cutter::F), gear(48, -20, ArcRack::Cutter::P)}, {}, {}};
  p.place.center_distance = (p.gears[0].reference_diameter + p.gears[1].reference_diameter) / 2;
  return p;
}

}  // namespace gearwright::testing
