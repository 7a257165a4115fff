// Two steel gears on parallel axes, and their loaded contact for a request.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright::testing {

inline constexpr double kE = 206000.0;  ///< MPa

struct Drive {
  Gear one, two;
  ContactMount mount;
  ContactPair pair() const { return ContactPair({&one, {}}, {&two, {}}, mount); }
};

/// A pinion with 25 teeth and a wheel with z_2 teeth, mounted without backlash. If z_2 < 0, the
/// wheel is an internal gear, whose tips are shortened so that they do not reach the root of the
/// pinion.
inline Drive steel_drive(int z_2, double helix_deg, double face = 30.0, double module = 3.0) {
  const auto gear = [&](int teeth, double beta_deg) {
    CylindricalSpec s =
        plain_spec({.teeth = teeth, .module = module, .beta_deg = beta_deg, .face_width = face});
    s.rack = *iso53_rack("ISO53-A");
    if (teeth < 0) s.tip_diameter = module * (-teeth / std::cos(helix_deg * kRadPerDeg) - 1.6);
    auto made = make_gear_with_default_cutter(s);
    EXPECT_TRUE(made) << made.error().message();
    return std::move(made).take();
  };
  const double side = side_of(z_2);
  Drive d{gear(25, helix_deg), gear(z_2, -side * helix_deg), {}};
  d.mount.center_distance = 0.5 * (d.two.reference_diameter + side * d.one.reference_diameter);
  return d;
}

/// A request for draft tables, eight positions and twelve slices. The bodies have a bore of 12
/// modules or, for an internal gear, a rim of 2.5 modules.
inline LoadRequest steel_request(const Drive& d, double e = kE) {
  const double m = d.one.spec.normal_module;
  LoadRequest r;
  r.bodies = {ElasticBody{12 * m, 0.3, e}, ElasticBody{12 * m, 0.3, e}};
  if (d.two.side() < 0.0) r.bodies[1].bore_diameter = d.two.root_diameter + 5 * m;
  r.accuracy = ComplianceAccuracy::draft;
  r.slices = {12, 12};
  r.positions = 8;
  return r;
}

inline LoadedContact run(const Drive& d, const LoadRequest& r) {
  auto c = pair_compliance(d.one, d.two, r);
  EXPECT_TRUE(c) << c.error().message();
  return loaded_contact(d.pair(), d.one, d.two, *c, r);
}

}  // namespace gearwright::testing
