// Contact of two gears, computed only from points of their flanks. External and internal pairs,
// either gear driving, and modified flanks are supported. For each of a dense set of points on
// flank 1, the search computes the rotation at which the mating flank passes the point. It shares
// only the definitions of errors and modifications with the contact room, and it uses no
// derivative.
//
//   ρ, z     radius and height of a point of a flank, mm, in the frame of its gear
//   θ(ρ)     azimuth of the flank in the section z = 0 of the tooth whose centre line is the x axis
//   τ        turn per mm of height      k(ρ)   turn per mm removed along the normal, rad/mm
//   C(ρ, z)  removed, mm                c      +1 the side y > 0 of the tooth, −1 the other
//
// The section z of the flank has the azimuth θ + τ z − c k C. Gear 1 turns clockwise by φ_1. Gear 2
// turns as it is driven: counter-clockwise, or clockwise for an internal gear. A point of flank 1
// lies on flank 2 at one rotation φ_2* of gear 2. The position of gear 2 is the greatest of these
// rotations if gear 1 drives, and the least if gear 2 drives. A point outside the radii or the face
// of the mating gear is ranked below all others, by its distance.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "tests/oracle/mounting.hpp"

namespace gearwright::oracle {

struct BruteGear {
  int teeth = 0;  ///< > 0, also for an internal gear
  std::function<double(double rho)> azimuth;
  std::function<double(double rho)> turn_per_removal;   ///< k
  std::function<double(double rho, double z)> removed;  ///< C; empty if nothing is removed
  double twist = 0.0;                                   ///< τ, errors included
  double side = -1.0;                                   ///< c
  double rho_low = 0.0, rho_high = 0.0, z_low = 0.0, z_high = 0.0;
  double turn(double rho, double z) const {
    const double helix = azimuth(rho) + twist * z;
    return removed ? helix - side * turn_per_removal(rho) * removed(rho, z) : helix;
  }
};

struct BrutePair {
  BruteGear one, two;
  tca::Mounting mounting;
  bool internal = false, gear2_drives = false;
};

struct BrutePlace {
  double te = -std::numeric_limits<double>::infinity();  ///< φ_2 − φ_1 N_1/N_2
  double rho_1 = 0.0, z_1 = 0.0;
  int pair = 0;
};

class BruteContact {
 public:
  explicit BruteContact(const BrutePair& pair) : p_(pair) {
    const tca::Mounting& m = p_.mounting;
    const tca::Matrix3 to_2 = tca::crossed(m.shaft_angle).transpose();
    const tca::Vector3 apart(-(m.center_distance + m.d_center), 0, m.axial);
    turn_ = (to_2 * tca::crossed(m.crossing) * tca::tilted(m.intersecting)).cast<double>();
    shift_ = (to_2 * apart).cast<double>();
  }

  struct Seen {
    double te;       ///< φ_2* − φ_1 N_1/N_2
    double outside;  ///< mm; 0 if the point is inside both flanks
  };

  /// A point of flank 1 that belongs to tooth pair k.
  Seen look(double rotation_1, int k, double rho, double z) const {
    const double pi = std::numbers::pi, mesh = p_.internal ? pi : 0.0;
    const double n1 = p_.one.teeth, n2 = p_.two.teeth;
    const double at = mesh + 2 * pi * k / n1 + p_.one.turn(rho, z) - rotation_1;
    const Eigen::Vector3d r(rho * std::cos(at), rho * std::sin(at), z);
    const Eigen::Vector3d q = turn_ * r + shift_;
    const double rho_2 = std::hypot(q.x(), q.y());
    const double broken =
        std::max({0.0, p_.one.rho_low - rho, rho - p_.one.rho_high, p_.one.z_low - z,
                  z - p_.one.z_high, p_.two.rho_low - rho_2, rho_2 - p_.two.rho_high,
                  p_.two.z_low - q.z(), q.z() - p_.two.z_high});
    const double sense = p_.internal ? -1.0 : 1.0;
    // The tooth of gear 2 next to space 0 that is in contact with tooth 0 of gear 1.
    const double tooth = p_.gear2_drives ? -pi : pi;
    const double rest = pi + sense * (tooth - 2 * pi * k) / n2;
    const double inside_rho = std::clamp(rho_2, p_.two.rho_low, p_.two.rho_high);
    const double flank = rest + p_.two.turn(inside_rho, q.z()) + sense * rotation_1 * n1 / n2;
    const double te = sense * std::remainder(std::atan2(q.y(), q.x()) - flank, 2 * pi);
    return {te, broken};
  }

  /// The first point of pair k that touches. Absent if no point lies inside both flanks.
  std::optional<BrutePlace> touch_of_pair(double rotation_1, int k, int sections = 60,
                                          int radii = 40) const {
    const double sign = p_.gear2_drives ? -1.0 : 1.0;
    const auto value = [&](double rho, double z) {
      const Seen s = look(rotation_1, k, rho, z);
      return s.outside > 0.0 ? -1e3 * (1.0 + s.outside) : sign * s.te;
    };
    double best_rho = 0.0;
    const auto section = [&](double z) {
      return max_over([&](double rho) { return value(rho, z); }, p_.one.rho_low, p_.one.rho_high,
                      radii, best_rho);
    };
    double best_z = 0.0;
    BrutePlace best;
    const double v = max_over(section, p_.one.z_low, p_.one.z_high, sections, best_z);
    if (v <= -1e3) return std::nullopt;
    section(best_z);
    best.te = sign * v;
    best.rho_1 = best_rho, best.z_1 = best_z, best.pair = k;
    return best;
  }

  /// The pair with |k| ≤ reach that carries the load.
  std::optional<BrutePlace> touch(double rotation_1, int reach, int sections = 60,
                                  int radii = 40) const {
    std::optional<BrutePlace> best;
    for (int k = -reach; k <= reach; ++k) {
      const auto t = touch_of_pair(rotation_1, k, sections, radii);
      if (t && (!best || (p_.gear2_drives ? t->te < best->te : t->te > best->te))) best = t;
    }
    return best;
  }

  const BrutePair& pair() const { return p_; }

 private:
  // Equal steps, followed by golden section around the best of them.
  template <class F>
  static double max_over(F f, double lo, double hi, int steps, double& where) {
    int at = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= steps; ++i) {
      const double v = f(lo + (hi - lo) * i / steps);
      if (v > most) most = v, at = i;
    }
    where = lo + (hi - lo) * at / steps;
    double a = lo + (hi - lo) * std::max(0, at - 1) / steps;
    double b = lo + (hi - lo) * std::min(steps, at + 1) / steps;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double c = b - golden * (b - a), d = a + golden * (b - a);
    double f_c = f(c), f_d = f(d);
    for (int i = 0; i < 70 && b - a > 1e-15 * (std::abs(a) + std::abs(b)); ++i) {
      if (f_c > most) most = f_c, where = c;
      if (f_d > most) most = f_d, where = d;
      if (f_c >= f_d) {
        b = d, d = c, f_d = f_c;
        c = b - golden * (b - a), f_c = f(c);
      } else {
        a = c, c = d, f_c = f_d;
        d = a + golden * (b - a), f_d = f(d);
      }
    }
    return most;
  }

  BrutePair p_;
  Eigen::Matrix3d turn_;
  Eigen::Vector3d shift_;
};

/// An involute flank defined by its data. The tooth of an internal gear becomes thicker outwards. A
/// helix error κ turns the sections, including their modifications.
inline BruteGear brute_involute(int teeth, bool ring, double base_radius, double half_angle,
                                double twist, double kappa, double side) {
  BruteGear g;
  g.teeth = teeth, g.twist = twist + kappa, g.side = side;
  g.azimuth = [=](double rho) {
    const double alpha = std::acos(std::min(1.0, base_radius / rho));
    const double inv = std::tan(alpha) - alpha;
    return side * (ring ? half_angle + inv : half_angle - inv);
  };
  // A turned involute is parallel to the original, at the distance r_b cos β_b.
  const double k = std::hypot(1.0, base_radius * twist) / base_radius;
  g.turn_per_removal = [=](double) { return k; };
  return g;
}

}  // namespace gearwright::oracle
