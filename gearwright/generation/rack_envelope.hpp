// Computes the envelope of a rack cutter's edge in the transverse section of the gear.
//
//   r    pitch radius, mm        β    helix angle
//   e    height of the datum line over the pitch circle, mm
//   (x, y, τ)   a point of the cutter's edge with its normal angle as in tool/cutter_edge.hpp,
//               except that x includes e
//
// A point of the edge cuts when its normal passes through the pitch point. With k = x cot τ cos β,
// the gear has then turned by φ = (y/cos β − k)/r, and the point of the gear is [T3.7]
//
//   W = (r + x + ik) e^{iφ},   tangent e^{i(φ − τ_t)},   tan τ_t = tan τ / cos β
//
// A straight piece of the edge cuts an involute, and a circle or a corner cuts a trochoid.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/curve/curve.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

struct RackMotion {
  double pitch_radius;  ///< r  mm
  double cos_beta;      ///< cos β
  double shift;         ///< e = x_E m_n  mm
};

/// A circular piece of the edge and the motion of the rack. The height x of its centre includes e.
template <class T>
struct RackCircle {
  T r;              ///< pitch radius, mm
  T cos_beta;       ///< cos β
  Plane<T> center;  ///< mm
  T q;              ///< as in EdgeCircle, mm

  /// The coefficients of F as a polynomial in sin τ, lowest power first. [T3.9]
  std::array<T, 5> cusp_polynomial() const {
    const T cos2 = cos_beta * cos_beta, sin2 = T(1) - cos2;
    return {-cos2 * center.x * center.x, -cos2 * center.x * q, T(0), q * (r + sin2 * center.x),
            sin2 * q * q};
  }
};

namespace jets {

/// The envelope of a circular piece at the normal angle τ of the normal section with the sine s and
/// the cosine c.
///
/// The values and the derivatives have separate formulas. The first derivative of log_slopes()
/// suffers from cancellation near a cusp, so a tangent computed from it is less accurate than
/// tangent_angle() (ledger rows `rack_trochoid.tangent` and `rack_trochoid.jet`). In factor() and
/// log_slopes(), the height of the circle's centre and q sin τ are kept apart, so that no divisor
/// contains a higher power than sin² τ. [T8.6]
template <class T>
struct RackTrochoid {
  RackCircle<T> e;
  T s, c;

  // The point of the cutter (x, y) in the position in which it cuts, and the rotation φ of the
  // gear. [T3.7]
  T x() const { return e.center.x + e.q * s; }
  T y() const { return (e.center.y + e.q * c) / e.cos_beta; }
  T k() const { return x() * e.cos_beta * c / s; }
  T phi() const { return (y() - k()) / e.r; }

  Plane<T> point() const { return turned({e.r + x(), k()}, phi()); }
  T polar_angle() const { return phi() + atan2(k(), e.r + x()); }
  T tangent_angle() const {
    return phi() - atan2(s, e.cos_beta * c) + (speed() < T(0) ? half_turn<T>() : T(0));
  }
  T curvature() const {
    const T cb = e.cos_beta,
            phi1 = (-e.q * s / cb - (e.q * c * c * cb / s - x() * cb / (s * s))) / e.r;
    return (phi1 - cb / transverse_square()) / abs(speed());
  }

  Plane<T> factor() const { return {e.r + e.q * s + e.center.x, k_apart()}; }
  T phase() const { return ((e.center.y + e.q * c) / e.cos_beta - k_apart()) / e.r; }
  LogSlopes<T> log_slopes() const {
    const T q1 = e.q * c, q2 = -e.q * s, csc2 = T(1) / (s * s);
    const T k1 = -e.cos_beta * (e.center.x * csc2 + e.q * s);
    const T k2 = e.cos_beta * (T(2) * e.center.x * (c / s) * csc2 - q1);
    const Plane<T> f = factor();
    const T norm = f.x * f.x + f.y * f.y;
    const Plane<T> over{f.x / norm, -f.y / norm};
    const Plane<T> a = times<T>({q1, k1}, over), b = times<T>({q2, k2}, over), aa = times(a, a);
    const T phi1 = (q2 / e.cos_beta - k1) / e.r, phi2 = (-q1 / e.cos_beta - k2) / e.r;
    return {{a.x, a.y + phi1}, {b.x - aa.x, b.y - aa.y + phi2}};
  }

 private:
  T k_apart() const { return e.cos_beta * (e.center.x * (c / s) + e.q * c); }
  T transverse_square() const { return s * s + e.cos_beta * e.cos_beta * c * c; }
  // v of dW/dτ = v e^{i(φ − τ_t)},  v = F √(s² + cos²β c²)/(s³ r cos β). [T3.9]
  T speed() const {
    return evaluate_polynomial<T>(e.cusp_polynomial(), s) * sqrt(transverse_square()) /
           (s * s * s * e.r * e.cos_beta);
  }
};

}  // namespace jets

/// The envelope of a circular piece of the edge, with the normal angle τ as parameter.
///
/// Laws  (1) d|W|²/dτ = 2 F cos τ / sin³τ with the quartic F of [T3.9], so the radius is monotone
///           between zeros of F, and a zero of F is a cusp
///       (2) dθ/d|W| does not depend on the circle's radius
class RackTrochoid final : public JetCurve<RackTrochoid> {
 public:
  RackTrochoid(const RackMotion& motion, const EdgeCircle& circle);
  jets::RackTrochoid<double> jet(double tau) const {
    return {numbers(), std::sin(tau), std::cos(tau)};
  }
  const RackMotion& motion() const { return motion_; }
  const EdgeCircle& circle() const { return circle_; }  ///< the height of its centre includes e

  std::array<double, 5> cusp_polynomial() const { return numbers().cusp_polynomial(); }
  /// Returns the normal angles of the necks. At a neck, the half angle of the tooth is stationary.
  /// [T3.10]
  std::vector<double> neck_angles(double tau_lo, double tau_hi) const;

 private:
  RackCircle<double> numbers() const {
    return {motion_.pitch_radius,
            motion_.cos_beta,
            {circle_.center.x(), circle_.center.y()},
            circle_.q};
  }

  RackMotion motion_;
  EdgeCircle circle_;  // the height of its centre includes e
};

/// The involute that a straight piece cuts. [T3.8]
Involute rack_involute(const RackMotion& motion, const EdgeLine& line);

/// Returns the roll angle ξ of the involute point that is cut by the point of the line at the
/// height x. The height is measured from the pitch circle, so it includes e.
double rack_involute_roll(const RackMotion& motion, const EdgeLine& line, double x);

}  // namespace gearwright
