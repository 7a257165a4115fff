// Seeded pairs both for the contact room and for the five equations: circular arcs with all errors,
// and involute screws, including worms, on crossed and parallel axes, with and without crowned
// leads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/curve/basic_curves.hpp"
#include "tests/oracle/contact_gears.hpp"
#include "tests/oracle/five_equation.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/point_cloud.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::oracle {

/// Arcs that touch near θ = 20° … 40°, with flanks from 12° to 52° and errors from zero to large.
inline tca::ArcPair random_arcs(property::Random& random) {
  const auto sign = [&random] { return random.chance(0.5) ? 1.0 : -1.0; };
  const double m = random.pick({0.5, 2.0, 4.0, 10.0});
  tca::ArcPair p;
  p.teeth_1 = random.integer(8, 40);
  p.teeth_2 = random.integer(p.teeth_1, 150);
  p.lead_angle_f = p.lead_angle_p = random.uniform(60.0, 82.0) * kLongDegree;
  if (random.chance(0.3)) p.lead_angle_f += 0.05 * sign() * random.unit() * kLongDegree;
  const tca::Real sine = std::sin(p.lead_angle_p);
  p.pitch_radius_1 = p.teeth_1 * m / (2 * sine);
  p.pitch_radius_2 = p.teeth_2 * m / (2 * sine);
  const tca::Real theta = random.uniform(22.0, 38.0) * kLongDegree;
  const tca::Real more = m * random.logarithmic(0.05, 0.4);
  p.f.rho = m * random.uniform(1.2, 1.7);
  p.f.a = m * random.uniform(0.3, 0.5);
  p.f.b = m * random.uniform(0.0, 0.3);
  p.p.rho = p.f.rho + more;
  p.p.a = p.f.a + more * std::cos(theta);
  p.p.b = p.f.b + more * std::sin(theta);
  p.f.theta_low = 12 * kLongDegree, p.f.theta_high = 52 * kLongDegree;
  p.p.theta_low = 13 * kLongDegree, p.p.theta_high = 51 * kLongDegree;
  const double size = random.logarithmic(1e-3, 1.0);
  p.mounting.center_distance = p.pitch_radius_1 + p.pitch_radius_2;
  p.mounting.d_center = 0.2 * static_cast<double>(more) * size * sign() * random.unit();
  if (random.chance(0.8)) p.mounting.crossing = 1e-3 * size * sign() * random.unit();
  if (random.chance(0.8)) p.mounting.intersecting = 1e-3 * size * sign() * random.unit();
  if (random.chance(0.8)) p.mounting.axial = m * size * sign() * random.unit();
  if (random.chance(0.5)) p.lead_1.twist = 5e-4 * size / (m * p.teeth_1) * sign() * random.unit();
  if (random.chance(0.5)) p.lead_2.twist = 5e-4 * size / (m * p.teeth_2) * sign() * random.unit();
  // The width is one pitch of the axial section plus up to half a pitch.
  const tca::Real axial = std::numbers::pi_v<tca::Real> * m / std::cos(p.lead_angle_p);
  p.half_face_1 = axial * random.uniform(0.5, 0.8);
  p.half_face_2 = axial * random.uniform(0.5, 0.8);
  return p;
}

/// The same flanks, described by their azimuths.
inline BrutePair brute_arcs(const tca::ArcPair& pair) {
  BrutePair b;
  for (int i : {0, 1}) {
    const tca::RackArc& rack = i == 0 ? pair.f : pair.p;
    const tca::ArcFlank flank = i == 0 ? flank_1(pair) : flank_2(pair);
    const auto outline = std::make_shared<tca::ArcOutline>(flank, rack.theta_low, rack.theta_high);
    BruteGear& g = i == 0 ? b.one : b.two;
    g.teeth = i == 0 ? pair.teeth_1 : pair.teeth_2;
    // ArcOutline has the tooth of gear 2 in its position, half a pitch beyond the space.
    const tca::Real pi = std::numbers::pi_v<tca::Real>;
    const tca::Real rest = i == 0 ? 0 : pi + pi / pair.teeth_2;
    g.azimuth = [outline, rest](double rho) {
      const tca::Real inside = std::clamp<tca::Real>(rho, outline->rho_low(), outline->rho_high());
      return static_cast<double>((*outline)(inside)-rest);
    };
    // The rack moves along its datum line, which is inclined by τ and λ to the normal.
    const double r_sine = static_cast<double>((i == 0 ? pair.pitch_radius_1 : pair.pitch_radius_2) *
                                              std::sin(flank.lead_angle));
    g.turn_per_removal = [outline, r_sine](double rho) {
      const tca::Real inside = std::clamp<tca::Real>(rho, outline->rho_low(), outline->rho_high());
      return 1.0 / (r_sine * static_cast<double>(std::cos(outline->theta(inside))));
    };
    g.rho_low = static_cast<double>(outline->rho_low());
    g.rho_high = static_cast<double>(outline->rho_high());
    const tca::Real half = i == 0 ? pair.half_face_1 : pair.half_face_2;
    g.z_low = -static_cast<double>(half), g.z_high = static_cast<double>(half);
    const tca::Real rise = std::tan(flank.lead_angle) * flank.pitch_radius;
    const tca::Real twist = (i == 0 ? 1 : -1) / rise + (i == 0 ? pair.lead_1 : pair.lead_2).twist;
    g.twist = static_cast<double>(twist);
  }
  b.mounting = pair.mounting;
  return b;
}

enum class ScrewKind { crossed, worm, crowned_parallel };

/// Two screws in the notation of the room, of the five equations and of the cloud.
struct ScrewContact {
  ContactSet set;
  std::array<tca::InvoluteFlank, 2> flanks;
  std::array<tca::LeadTurn, 2> lead;
  tca::CloudPair cloud;
  double size = 0.0;  ///< mm, the reference radius of gear 1
};

inline ScrewContact random_screws(property::Random& random, ScrewKind kind) {
  const auto sign = [&random] { return random.chance(0.5) ? 1.0 : -1.0; };
  const bool worm = kind == ScrewKind::worm, parallel = kind == ScrewKind::crowned_parallel;
  const double m = random.pick({1.0, 3.0}), alpha_n = random.pick({14.5, 20.0, 25.0}) * kDegree;
  const std::array<int, 2> teeth{worm ? random.integer(1, 4) : random.integer(14, 40),
                                 random.integer(18, 60)};
  std::array<double, 2> beta{random.uniform(15.0, 55.0) * kDegree * sign(), 0.0};
  if (worm) beta[0] = random.uniform(72.0, 85.0) * kDegree * sign();
  beta[1] = random.uniform(10.0, 50.0) * kDegree * sign();
  if (worm) beta[1] = (beta[0] > 0 ? 1 : -1) * std::numbers::pi / 2 - beta[0];
  if (parallel) beta[1] = -(beta[0] *= random.chance(0.3) ? 0.0 : 0.5);
  while (!worm && !parallel && std::abs(beta[0] + beta[1]) < 8 * kDegree)
    beta[1] = random.uniform(10.0, 50.0) * kDegree * sign();
  ScrewContact s;
  const double size = random.logarithmic(1e-3, 1.0);
  const double face = m * (worm ? 25.0 : random.uniform(8.0, 20.0));
  double distance = 0.0;
  for (int i : {0, 1}) {
    const double r = teeth[i] * m / (2 * std::cos(beta[i]));
    const double alpha_t = std::atan(std::tan(alpha_n) / std::cos(beta[i]));
    const double r_b = r * std::cos(alpha_t);
    const double eta = std::numbers::pi / (2 * teeth[i]) + std::tan(alpha_t) - alpha_t;
    const double twist = std::tan(beta[i]) / r;
    const double lo = std::max(r_b * 1.0005, r - 0.9 * m), hi = r + m;
    const auto roll = [&](double rho) { return std::sqrt((rho - r_b) * (rho + r_b)) / r_b; };
    const auto curve = std::make_shared<Involute>(r_b, eta);
    const double b = i == 0 ? face : face * random.uniform(0.8, 1.2);
    s.set.gears[i] = gear_of_arc(teeth[i], r, twist, b, flank_arc(curve, roll(lo), roll(hi)));
    if (random.chance(0.5)) s.lead[i].twist = 1e-3 * size / r * sign() * random.unit();
    s.set.mount.errors.helix_twist[i] = static_cast<double>(s.lead[i].twist);
    if (parallel || random.chance(0.4)) {
      FlankModifications f;
      f.lead_crowning = m * random.logarithmic(1e-4, 3e-2);
      s.set.removal[i] = std::make_shared<RemovalField>(f, FlankExtent{r_b, lo, hi, b});
      // A removal along the normal corresponds to a turn of the section with the arm r_b cos β_b.
      const double arm = r_b / std::hypot(1.0, r_b * twist);
      s.lead[i].crowning = 4 * f.lead_crowning / (b * b * arm);
    }
    const double center = i == 0 ? 0.0 : 1.0;
    const tca::Real pi = std::numbers::pi_v<tca::Real>;
    s.flanks[i] = {i + 1, r_b, eta, static_cast<tca::Real>(center) * (pi + pi / teeth[i]),
                   twist, -1};
    const auto cloud = cloud_flank(s.flanks[i], lo, hi, s.lead[i], b / 2);
    (i == 0 ? s.cloud.flank_1 : s.cloud.flank_2) = cloud;
    (i == 0 ? s.cloud.teeth_1 : s.cloud.teeth_2) = teeth[i];
    distance += r;
    if (i == 0) s.size = r;
  }
  auto& place = s.set.mount;
  place.center_distance = distance;
  place.axis_angle = Angle::radians(parallel ? 0.0 : beta[0] + beta[1]);
  const double tilt = parallel ? 2e-4 : 3e-3;
  place.errors.center_distance = 0.1 * m * size * random.unit();
  if (random.chance(0.8)) {
    place.errors.crossing = Angle::radians(tilt * size * sign() * random.unit());
  }
  if (random.chance(0.8)) {
    place.errors.intersecting = Angle::radians(tilt * size * sign() * random.unit());
  }
  if (random.chance(0.8)) place.errors.axial = 0.5 * m * size * sign() * random.unit();
  s.cloud.mounting = mounting_of(place);
  return s;
}

/// The same flanks, described by their azimuths.
inline BrutePair brute_screws(const ScrewContact& s) {
  BrutePair b = brute_pair(s.set);
  for (int i : {0, 1}) {
    if (!s.set.removal[i]) continue;
    const double c = s.set.removal[i]->amount(Modification::lead_crowning);
    const double face = s.set.gears[i].spec.face_width;
    (i == 0 ? b.one : b.two).removed = [=](double, double z) {
      return c * 4 * z * z / face / face;
    };
  }
  return b;
}

/// The five equations of the tooth pair that carries the load at `p`, started slightly away from
/// `p`.
inline tca::FiveEquationTouch five_equations(const ScrewContact& s, const ContactPoint& p) {
  tca::FlankPair pair;
  pair.flank_1 = turned(involute_surface(s.flanks[0]), s.lead[0]);
  pair.flank_2 = turned(involute_surface(s.flanks[1]), s.lead[1]);
  pair.mounting = mounting_of(s.set.mount);
  pair.ratio = static_cast<tca::Real>(s.cloud.teeth_1) / s.cloud.teeth_2;
  pair.scale = s.flanks[0].base_radius;
  const auto roll = [&](int i) {
    const tca::Real r_b = s.flanks[i].base_radius, rho = p.diameter[i] / 2;
    return std::sqrt((rho - r_b) * (rho + r_b)) / r_b;
  };
  const tca::Real back = 2 * std::numbers::pi_v<tca::Real> * p.pair;
  const tca::Unknowns start{roll(0) * 1.0001L, p.height[0] + 1e-4L * pair.scale, roll(1),
                            p.height[1], p.rotation2.rad() - back / s.cloud.teeth_2 + 1e-6L};
  return solve(pair, p.rotation1.rad() - back / s.cloud.teeth_1, start);
}

}  // namespace gearwright::oracle
