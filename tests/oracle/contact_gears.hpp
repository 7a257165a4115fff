// Converts between gears of the oracles and gears of the contact room: gears with the flanks of an
// ArcPair, and brute flanks of an involute gear of the engine.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/pair/mounted_gears.hpp"
#include "tests/oracle/brute_flanks.hpp"
#include "tests/oracle/five_equation.hpp"

namespace gearwright::oracle {

/// A gear that has only one flank arc from root to tip.
inline Gear gear_of_arc(int teeth, double pitch_radius, double twist, double face, Arc arc) {
  Gear g{};
  g.spec.teeth = teeth;
  g.spec.face_width = face;
  g.reference_diameter = 2 * pitch_radius;
  g.lead = twist == 0.0 ? 0.0 : 2 * std::numbers::pi / twist;
  const bool rises = arc.begin_point.norm() < arc.end_point.norm();
  if (rises == (teeth < 0)) {
    std::swap(arc.begin, arc.end);
    std::swap(arc.begin_point, arc.end_point);
  }
  GeneratedTooth tooth{};
  tooth.outline.teeth = teeth;
  tooth.outline.arcs = {std::move(arc)};
  g.tooth = tooth;
  return g;
}

inline Arc flank_arc(const CurvePtr& curve, double begin, double end) {
  return {ArcName::flank, curve, begin, end, curve->point(begin), curve->point(end)};
}

/// The gear `which` of a circular-arc pair; its angles must have ends.
inline Gear arc_gear(const tca::ArcPair& pair, int which, double face) {
  const bool first = which == 1;
  const tca::RackArc& rack = first ? pair.f : pair.p;
  const int teeth = first ? pair.teeth_1 : pair.teeth_2;
  const auto d = [](tca::Real x) { return static_cast<double>(x); };
  const double r = d(first ? pair.pitch_radius_1 : pair.pitch_radius_2);
  const double lambda = d(first ? pair.lead_angle_f : pair.lead_angle_p);
  const double rho = d(rack.rho), a = d(rack.a), b = d(rack.b);
  // F is drawn from the middle of the tooth and away from the axis. P is drawn in the opposite
  // direction, with its tooth half a pitch further.
  const double half_pitch = std::numbers::pi * r * std::sin(lambda) / teeth;
  const EdgeCircle circle{first ? Vec2(-b, -a) : Vec2(b, a + half_pitch), first ? rho : -rho,
                          Angle::radians(d(rack.theta_low)), Angle::radians(d(rack.theta_high))};
  const auto curve = std::make_shared<RackTrochoid>(RackMotion{r, std::sin(lambda), 0.0}, circle);
  const double twist = (first ? 1.0 : -1.0) / (r * std::tan(lambda));
  return gear_of_arc(teeth, r, twist, face,
                     flank_arc(curve, circle.begin_tau.rad(), circle.end_tau.rad()));
}

inline ContactMount contact_mount(const tca::Mounting& m) {
  const auto d = [](tca::Real x) { return static_cast<double>(x); };
  ContactMount out;
  out.center_distance = d(m.center_distance);
  out.axis_angle = Angle::radians(d(m.shaft_angle));
  out.errors.center_distance = d(m.d_center);
  out.errors.crossing = Angle::radians(d(m.crossing));
  out.errors.intersecting = Angle::radians(d(m.intersecting));
  out.errors.axial = d(m.axial);
  return out;
}

inline tca::Mounting mounting_of(const ContactMount& m) {
  return {m.center_distance,       m.axis_angle.rad(),          m.errors.center_distance,
          m.errors.crossing.rad(), m.errors.intersecting.rad(), m.errors.axial};
}

/// Both gears and their mounting. It owns the objects to which ContactPair points.
struct ContactSet {
  std::array<Gear, 2> gears;
  std::array<std::shared_ptr<const RemovalField>, 2> removal{};  ///< on both flanks
  ContactMount mount;

  ContactPair pair() const {
    return ContactPair({&gears[0], {removal[0].get(), removal[0].get()}},
                       {&gears[1], {removal[1].get(), removal[1].get()}}, mount);
  }
};

/// Domain    both arcs and both faces have ends; no crowning
inline ContactSet contact_set(const tca::ArcPair& pair) {
  ContactSet s{{arc_gear(pair, 1, 2 * static_cast<double>(pair.half_face_1)),
                arc_gear(pair, 2, 2 * static_cast<double>(pair.half_face_2))},
               {},
               contact_mount(pair.mounting)};
  s.mount.errors.helix_twist = {static_cast<double>(pair.lead_1.twist),
                                static_cast<double>(pair.lead_2.twist)};
  return s;
}

/// The gears of a mounted pair, without errors.
inline ContactSet contact_set(const MountedGears& pair, bool gear2_drives) {
  ContactSet s{pair.gears, {}, {}};
  s.mount.center_distance = pair.center_distance;
  s.mount.axis_angle = pair.axis_angle();
  s.mount.gear2_drives = gear2_drives;
  return s;
}

/// The usable involute flank of a gear of the engine, on the side c.
inline BruteGear brute_flank(const Gear& g, double side, double helix_error) {
  double lo = std::numeric_limits<double>::infinity(), hi = 0.0;
  double half_angle = 0.0, base_radius = 0.0;
  for (const Arc& arc : g.tooth->outline.arcs) {
    if (arc.name != ArcName::flank) continue;
    const auto& involute = curve_as<Involute>(*arc.curve);
    base_radius = involute.base_radius(), half_angle = involute.base_half_angle();
    for (const double r : {arc.begin_point.norm(), arc.end_point.norm()})
      lo = std::min(lo, r), hi = std::max(hi, r);
  }
  BruteGear b = brute_involute(std::abs(g.spec.teeth), g.internal(), base_radius, half_angle,
                               g.twist(), helix_error, side);
  b.rho_low = lo, b.rho_high = hi;
  b.z_low = -g.spec.face_width / 2, b.z_high = g.spec.face_width / 2;
  return b;
}

/// The caller adds the modifications of the set by BruteGear::removed.
inline BrutePair brute_pair(const ContactSet& s) {
  const bool internal = s.gears[1].internal(), second = s.mount.gear2_drives;
  const auto& e = s.mount.errors;
  return {brute_flank(s.gears[0], second ? 1.0 : -1.0, e.helix_twist[0]),
          brute_flank(s.gears[1], second != internal ? 1.0 : -1.0, e.helix_twist[1]),
          mounting_of(s.mount), internal, second};
}

}  // namespace gearwright::oracle
