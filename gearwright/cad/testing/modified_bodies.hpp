// Makes gears with flank modifications, and defines the law that their flanks obey, for tests of
// the CAD files.
//
//   L, ξ    roll length r_b ξ of an involute, mm, and roll angle       d   distance of a point from
//   c       material removed along the normal, mm                          the nominal flank, mm
//
// An involute helicoid that is turned about its axis by δ is its own parallel surface at the
// distance δ r_b cos β_b. Therefore d follows from the polar angle of a point. [T10.26] gives the
// normal n. The foot of the normal through a point (L, z) has the roll length L + σ d cos β_b. Its
// height is z − d sin β_b on the left flank, and z + d sin β_b on the right flank. c is computed
// here from its definition in gear/modifications.hpp, but without the code of that file.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

namespace gearwright::testing {

struct ModifiedGear {
  std::string name;
  Gear gear;
  BothFlanks flanks;
  ToothedBody body;
};

inline ModifiedGear modified(std::string name, Gear gear, BothFlanks flanks,
                             std::optional<Bore> bore = {}) {
  auto body = gear_body(gear, "gear", bore);
  GW_EXPECTS(body);
  ToothedBody made = std::move(body).take();
  GW_EXPECTS(!modify(made, gear, flanks));
  GW_EXPECTS(made.modified && made.unmodified.empty());
  return {std::move(name), std::move(gear), std::move(flanks), std::move(made)};
}

inline Gear external(int teeth, double beta_deg, double face_width = 25.0) {
  auto gear = make_gear(plain_spec(
      {.teeth = teeth, .module = 2.5, .beta_deg = beta_deg, .x = 0.3, .face_width = face_width}));
  GW_EXPECTS(gear);
  return std::move(gear).take();
}

inline Gear internal(double beta_deg) {
  CylindricalSpec s =
      plain_spec({.teeth = 18, .module = 2.0, .beta_deg = beta_deg, .x = 0.2, .face_width = 10.0});
  s.straight_rack().addendum = 1.25;
  const auto cutter = make_gear(s);
  GW_EXPECTS(cutter);
  auto gear = make_pinion_cut_gear(*cutter, {-49, 33.0, 10.0, 100.0});
  GW_EXPECTS(gear);
  return std::move(gear).take();
}

/// Returns all modifications at once, with `size` times their usual amounts. The two flanks have
/// different modifications.
inline BothFlanks everything(const Gear& gear, double size) {
  const double root = *gear.root_form_radius(), tip = gear.tip_form_radius();
  FlankModifications right;
  right.tip_relief = {0.020 * size, 2 * (root + 0.6 * (tip - root)), ReliefShape::linear};
  right.root_relief = {0.010 * size, 2 * (root + 0.2 * (tip - root)), ReliefShape::parabolic};
  right.lead_crowning = 0.008 * size;
  right.lead_slope = 0.012 * size;
  right.end_relief = {0.015 * size, 0.12 * gear.spec.face_width, ReliefShape::linear};
  FlankModifications left;
  left.tip_relief = {0.012 * size, 2 * (root + 0.5 * (tip - root)), ReliefShape::parabolic};
  left.profile_crowning = 0.006 * size;
  left.profile_slope = -0.005 * size;
  left.lead_crowning = -0.004 * size;
  return {right, left};
}

inline std::vector<ModifiedGear> modified_gears(double size) {
  std::vector<ModifiedGear> all;
  const auto add = [&](const char* name, Gear gear, std::optional<Bore> bore = {}) {
    BothFlanks flanks = everything(gear, size);
    all.push_back(modified(name, std::move(gear), std::move(flanks), bore));
  };
  add("spur", external(17, 0.0));
  add("right hand", external(21, 20.0), Bore{18.0, 5.0, 2.3});
  add("left hand", external(17, -15.0));
  add("internal spur", internal(0.0), Bore{118.0});
  add("internal", internal(20.0), Bore{118.0});
  return all;
}

/// Returns a double-helical gear with all modifications. `half` is its half at z > 0.
inline ModifiedGear modified_halves(std::string name, Gear half, double gap, double stagger = 0.0,
                                    std::optional<Bore> bore = {}) {
  BothFlanks flanks = everything(half, 3.0);
  ModifiedGear g{std::move(name), std::move(half), std::move(flanks), {}};
  g.body = gear_body(g.gear, "gear", bore).value();
  g.body.face_width = 2 * g.gear.spec.face_width + gap;
  const double root = g.body.outline.arcs.front().begin_point.norm();
  g.body.two_helices = TwoHelices{gap, g.body.ring() ? root + 1.0 : root - 1.0, stagger};
  GW_EXPECTS(!modify(g.body, g.gear, g.flanks));
  GW_EXPECTS(g.body.modified && g.body.unmodified.empty());
  return g;
}

inline std::vector<ModifiedGear> modified_double_helical_gears() {
  return {modified_halves("without gap", external(21, 20.0, 12.0), 0.0),
          modified_halves("with gap", external(17, -15.0, 12.0), 4.0, 0.0, Bore{18.0, 5.0, 2.3}),
          modified_halves("staggered", external(21, 20.0, 12.0), 4.0, kPi / 21),
          modified_halves("internal", internal(20.0), 3.0, 0.0, Bore{118.0})};
}

/// Returns a point of a double-helical gear in the frame of its half at z > 0. If the point is at z
/// < 0, its mirror image is used.
inline Vec3 in_half(const ModifiedGear& g, const Vec3& p) {
  const auto& [gap, groove, stagger] = *g.body.two_helices;
  const double middle = (gap + g.gear.spec.face_width) / 2;
  const double turn = g.gear.twist() * middle + (p.z() < 0 ? stagger : 0.0);
  const double c = std::cos(turn), s = std::sin(turn);
  return {c * p.x() + s * p.y(), c * p.y() - s * p.x(), std::abs(p.z()) - middle};
}

/// Returns c of the right or the left flank, computed from its definition.
inline double defined_removal(const ModifiedGear& g, bool left, double L, double z) {
  const FlankModifications& m = g.flanks[left ? 1 : 0];
  const double r_b = g.gear.reference().base_diameter / 2;
  const auto roll = [&](double rho) { return std::sqrt(rho * rho - r_b * r_b); };
  const double L_f = roll(*g.gear.root_form_radius()), L_a = roll(g.gear.tip_form_radius());
  const double b = g.gear.spec.face_width;
  const double w = (L - (L_f + L_a) / 2) / (L_a - L_f);
  double c = 4 * m.profile_crowning * w * w + m.profile_slope * w;
  c += 4 * m.lead_crowning * (z / b) * (z / b) + m.lead_slope * z / b;
  const auto relief = [](const Relief& r, double q) {
    if (q <= 0.0) return 0.0;
    return r.amount * (r.shape == ReliefShape::parabolic ? q * q : q);
  };
  if (m.tip_relief.reach) {
    const double L_s = roll(*m.tip_relief.reach / 2);
    c += relief(m.tip_relief, (L - L_s) / (L_a - L_s));
  }
  if (m.root_relief.reach) {
    const double L_s = roll(*m.root_relief.reach / 2);
    c += relief(m.root_relief, (L - L_s) / (L_f - L_s));
  }
  if (m.end_relief.reach)
    c += relief(m.end_relief, (std::abs(z) - b / 2 + *m.end_relief.reach) / *m.end_relief.reach);
  return c;
}

struct FlankReading {
  bool left;
  double foot;   ///< roll length of the foot of the normal, scaled from 0 at d_Ff to 1 at d_Fa
  double depth;  ///< d  mm, into the tooth
  double error;  ///< d − c  mm
};

inline FlankReading read_flank(const ModifiedGear& g, const Vec3& p) {
  const auto& ref = g.gear.reference();
  const double r_b = ref.base_diameter / 2, sigma = g.gear.spec.teeth < 0 ? -1.0 : 1.0;
  const double beta_b = ref.base_helix_angle;
  const double pitch = 2 * kPi / std::abs(g.gear.spec.teeth);
  const double turn = g.gear.lead == 0.0 ? 0.0 : 2 * kPi * p.z() / g.gear.lead;
  double angle = std::atan2(p.y(), p.x()) - turn;
  angle -= pitch * std::round(angle / pitch);
  const bool left = angle > 0.0;
  const double xi = std::sqrt(std::max(0.0, p.head<2>().squaredNorm() / (r_b * r_b) - 1));
  const double half = ref.base_tooth_thickness / ref.base_diameter - sigma * (xi - std::atan(xi));
  const double d = (half - std::abs(angle)) * r_b * std::cos(beta_b);
  const double L = r_b * xi + sigma * d * std::cos(beta_b);
  const double z = p.z() - (left ? 1.0 : -1.0) * d * std::sin(beta_b);
  const auto roll = [&](double rho) { return std::sqrt(rho * rho - r_b * r_b); };
  const double L_f = roll(*g.gear.root_form_radius()), L_a = roll(g.gear.tip_form_radius());
  return {left, (L - L_f) / (L_a - L_f), d, d - defined_removal(g, left, L, z)};
}

}  // namespace gearwright::testing
