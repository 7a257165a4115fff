// Bodies of gears that are cut by other gears, and of gears with one and two teeth, for tests of
// the CAD files. The code of generation/ computes these bodies.
//
//   two_teeth       circular root fillet, and a circular tip fillet in place of the land; β 30°
//   cut_wheel       60 teeth, cut by two_teeth: tip, flank and root are three kinds of envelope
//   one_tooth       like two_teeth but with one tooth, β 55°
//   cut_ring        internal gear, cut by a pinion of 18 teeth whose tip generates the root fillet
//   arc_pinion      convex circular-arc teeth, β 20°
//   double_arcs     convex and concave arcs with a step between them, β −20°
//   herringbone     22 teeth, β 30°; without a gap, with a gap, or staggered by half a pitch
//   herringbone_ring  36 teeth, an internal gear with a gap
//   rack_bar        rack of module 2 and width 20 mm; the back is 12 mm below the datum line
//
// A gear and the gear that cut it mesh without backlash at the centre distance E given below.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/testing/odd_outlines.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright::testing {

/// Domain    the gear exists (contract)
inline ToothedBody body_of(std::string name, const Result<Gear>& gear,
                           std::optional<Bore> bore = std::nullopt) {
  GW_EXPECTS(gear && gear->exists());
  return {std::move(name),       gear->tooth->outline, gear->twist(),
          gear->spec.face_width, std::move(bore),      {}};
}

inline CylindricalSpec filleted_pinion(int teeth, double m, double beta_deg, double x,
                                       double offset, double tip_radius, double face_width) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = m, .beta_deg = beta_deg, .x = x, .face_width = face_width});
  s.straight_rack().dedendum = 1.0;
  s.straight_rack().root_fillet_radius = 0.0;
  s.root_fillet = RootFilletSpec{offset};
  s.tip_fillet = TipFilletSpec{TipFilletSpec::By::radius, tip_radius};
  return s;
}

inline CylindricalSpec two_teeth_spec() {
  return filleted_pinion(2, 1.75, 30, 0.7, 0.01, 0.332, 12.0);
}

inline ToothedBody two_teeth_body() { return body_of("two teeth", make_gear(two_teeth_spec())); }

inline ToothedBody one_tooth() {
  return body_of("one tooth", make_gear(filleted_pinion(1, 2, 55, 0.75, 0.05, 0.5, 14.0)));
}

/// Face 30 mm. The groove is 1 mm deeper than the teeth.
inline ToothedBody herringbone(double gap, double stagger_pitches = 0.0) {
  auto body = body_of(
      "herringbone",
      make_gear(testing::plain_spec({.teeth = 22, .module = 2, .beta_deg = 30, .face_width = 30})));
  const double root = body.outline.arcs.front().begin_point.norm();
  body.two_helices = TwoHelices{gap, root - 1.0, stagger_pitches * 2 * kPi / 22};
  return body;
}

inline ToothedBody herringbone_ring(double gap, double stagger_pitches = 0.0) {
  auto body = ring_body(36, 2, 0.012, 30, 95);
  body.name = "herringbone ring";
  const double root = body.outline.arcs.front().begin_point.norm();
  body.two_helices = TwoHelices{gap, root + 1.0, stagger_pitches * 2 * kPi / 36};
  return body;
}

/// E = 61.106 mm
inline ToothedBody cut_wheel() {
  const auto cutter = make_gear(two_teeth_spec());
  GW_EXPECTS(cutter);
  return body_of("wheel", make_pinion_cut_gear(*cutter, {60, 61.106, 5.0, std::nullopt}));
}

/// E = 33.0 mm; rim 118 mm
inline ToothedBody cut_ring() {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = 18, .module = 2.0, .beta_deg = 20, .x = 0.2, .face_width = 10.0});
  s.straight_rack().addendum = 1.25;
  const auto cutter = make_gear(s);
  GW_EXPECTS(cutter);
  return body_of("ring", make_pinion_cut_gear(*cutter, {-49, 33.0, 8.0, 100.0}), Bore{118.0});
}

inline CylindricalSpec arc_spec(Rack rack, int teeth, double beta_deg) {
  CylindricalSpec s = testing::plain_spec(
      {.teeth = teeth, .module = 2.0, .beta_deg = beta_deg, .face_width = 12.0});
  s.rack = std::move(rack);
  return s;
}

inline ToothedBody arc_pinion() {
  ArcRack rack = default_arc_rack(ArcRack::Cutter::F);
  rack.center_a = 0.422436;
  rack.center_b = 0.243893;
  return body_of("arc pinion", make_gear(arc_spec(rack, 12, 20)));
}

inline ToothedBody double_arcs() {
  return body_of("double arcs", make_gear(arc_spec(DoubleArcRack{}, 15, -20)), Bore{12.0});
}

inline ToothedBody rack_bar(int teeth, double beta_deg, double allowance = 0.0) {
  auto pinion = make_gear(
      testing::plain_spec({.teeth = 20, .module = 2, .beta_deg = -beta_deg, .face_width = 20}));
  GW_EXPECTS(pinion);
  const auto pair = mount_rack(std::move(pinion).take(),
                               {.teeth = teeth, .height = 12.0, .thickness_allowance = allowance});
  GW_EXPECTS(pair);
  auto body = rack_body(pair->rack, "rack");
  GW_EXPECTS(body);
  return std::move(body).take();
}

}  // namespace gearwright::testing
