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

#include <cmath>
#include <vector>

#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/curve/curve.hpp"
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
};

/// A point of the cutter in the position in which it cuts, and the rotation φ of the gear.
template <class T>
struct RackCut {
  T x, k, phi;
};

/// Returns the cut at the normal angle with the sine s and the cosine c. [T3.7]
template <class T>
RackCut<T> rack_cut(const RackCircle<T>& e, const T& s, const T& c) {
  const T x = e.center.x + e.q * s;
  const T y = (e.center.y + e.q * c) / e.cos_beta;
  const T k = x * e.cos_beta * c / s;
  return {x, k, (y - k) / e.r};
}

/// Computes W = (r + x + ik) e^{iφ} and its derivatives with respect to τ. In the code, x is the
/// height of the circle's centre, so the point of the cutter has the height x + q sin τ. Because
/// these two terms are kept apart, no divisor contains a higher power than sin² τ. [T8.6]
template <class T>
CurveJet<T> trochoid_jet(const RackCircle<T>& e, const T& tau) {
  using std::cos;
  using std::sin;
  const T &x = e.center.x, &q = e.q;
  const T s = sin(tau);
  const T c = cos(tau);
  const T cot = c / s;
  const T csc2 = T(1) / (s * s);
  const T k = e.cos_beta * (x * cot + q * c);
  const T k1 = -e.cos_beta * (x * csc2 + q * s);
  const T k2 = e.cos_beta * (T(2) * x * cot * csc2 - q * c);
  const T y = e.center.y + q * c;
  const Plane<T> f{e.r + q * s + x, k};
  const T norm = f.x * f.x + f.y * f.y;
  const Plane<T> over{f.x / norm, -f.y / norm};
  const Plane<T> a = times<T>({q * c, k1}, over);
  const T phi1 = (-q * s / e.cos_beta - k1) / e.r;
  const T phi2 = (-q * c / e.cos_beta - k2) / e.r;
  const Plane<T> b = times<T>({-q * s, k2}, over), aa = times(a, a);
  return {T(1), f, (y / e.cos_beta - k) / e.r, {a.x, a.y + phi1}, {b.x - aa.x, b.y - aa.y + phi2}};
}

/// The envelope of a circular piece of the edge, with the normal angle τ as parameter.
///
/// The values and the derivatives have separate formulas. point(), polar_angle() and at() are made
/// from rack_cut(). The first derivative of polar_jet() suffers from cancellation near a cusp, so a
/// tangent computed from it is less accurate than the tangent of at() (ledger rows
/// `rack_trochoid.tangent` and `rack_trochoid.jet`). log_radius() is as accurate as polar_jet() and
/// takes two thirds of its time.
///
/// Laws  (1) d|W|²/dτ = 2 F cos τ / sin³τ with the quartic F of [T3.9], so the radius is monotone
///           between zeros of F, and a zero of F is a cusp
///       (2) dθ/d|W| does not depend on the circle's radius
class RackTrochoid final : public Curve {
 public:
  RackTrochoid(const RackMotion& motion, const EdgeCircle& circle);
  Vec2 point(double tau) const override;
  CurvePoint at(double tau) const override;
  double polar_angle(double tau) const override;
  /// Returns the point W and its first two derivatives with respect to τ, in polar form. [T8.6]
  PolarJet polar_jet(double tau) const;
  /// ln |W| and its derivative with respect to τ, the part of polar_jet() for finding a radius.
  struct LogRadius {
    double u, slope;
  };
  LogRadius log_radius(double tau) const;
  const RackMotion& motion() const { return motion_; }
  const EdgeCircle& circle() const { return circle_; }  ///< the height of its centre includes e

  /// Returns the coefficients of F as a polynomial in sin τ, lowest power first. [T3.9]
  std::vector<double> cusp_polynomial() const;
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
  RackCut<double> cut(double s, double c) const { return rack_cut(numbers(), s, c); }

  RackMotion motion_;
  EdgeCircle circle_;  // the height of its centre includes e
};

// This function is inline, because the inner loop of contact/ calls it.
inline PolarJet RackTrochoid::polar_jet(double tau) const {
  return polar(trochoid_jet(numbers(), tau));
}

/// Returns the involute that a straight piece cuts. [T3.8]
Involute rack_involute(const RackMotion& motion, const EdgeLine& line);

/// Returns the roll angle ξ of the involute point that is cut by the point of the line at the
/// height x. The height is measured from the pitch circle, so it includes e.
double rack_involute_roll(const RackMotion& motion, const EdgeLine& line, double x);

}  // namespace gearwright
