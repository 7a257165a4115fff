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
// A straight piece of the edge cuts an involute (closed form). A circle or a corner cuts a
// trochoid.
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

/// The envelope of a circular piece of the edge; the parameter is the normal angle τ of the normal
/// section.
///
/// The tangent and the curvature of at() have errors of at most 6e-16 rad and 9e-16, compared with
/// 50 digits on 20 000 random circles. The first derivative of polar_jet() suffers from
/// cancellation near a cusp, so a tangent and a curvature computed from it have errors of 4e-14 rad
/// and 2e-13. point(), polar_angle() and log_radius() are as accurate as polar_jet() and take two
/// thirds of its time.
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
  /// The point W and its first two derivatives by τ, in polar form. [T8.6]
  PolarJet polar_jet(double tau) const;
  /// Returns ln |W| and its derivative by τ. This is the only part of polar_jet() that a search for
  /// a radius needs.
  struct LogRadius {
    double u, slope;
  };
  LogRadius log_radius(double tau) const;
  const RackMotion& motion() const { return motion_; }
  const EdgeCircle& circle() const { return circle_; }  ///< the height of its centre includes e

  /// The coefficients of F as a polynomial in sin τ, lowest power first. [T3.9]
  std::vector<double> cusp_polynomial() const;
  /// Returns the normal angles of the necks. At a neck, the half angle of the tooth is stationary.
  /// [T3.10]
  std::vector<double> neck_angles(double tau_lo, double tau_hi) const;

 private:
  // A point of the cutter in the position in which it cuts, and the rotation φ of the gear.
  struct Cut {
    double x, k, phi;
  };
  Cut cut(double s, double c) const;

  RackMotion motion_;
  EdgeCircle circle_;  // the height of its centre includes e
};

// Computes W = (r + x + ik) e^{iφ} and its derivatives by τ. The function is inline, because the
// inner loop of contact/ calls it. In the code, x is the height of the circle's centre, so the
// point of the cutter has the height x + q sin τ. Because these two terms are kept apart, nothing
// is divided by more than sin² τ.
inline PolarJet RackTrochoid::polar_jet(double tau) const {
  const double r = motion_.pitch_radius, cos_beta = motion_.cos_beta;
  const double x = circle_.center.x(), q = circle_.q;
  const double s = std::sin(tau);
  const double c = std::cos(tau);
  const double cot = c / s;
  const double csc2 = 1.0 / (s * s);
  const double k = cos_beta * (x * cot + q * c);
  const double k1 = -cos_beta * (x * csc2 + q * s);
  const double k2 = cos_beta * (2.0 * x * cot * csc2 - q * c);
  const double y = circle_.center.y() + q * c;
  const Complex f{r + q * s + x, k};
  const Complex over = std::conj(f) / std::norm(f);
  const Complex a = times({q * c, k1}, over);
  const double phi1 = (-q * s / cos_beta - k1) / r;
  const double phi2 = (-q * c / cos_beta - k2) / r;
  return {f, (y / cos_beta - k) / r, a + Complex{0.0, phi1},
          times({-q * s, k2}, over) - times(a, a) + Complex{0.0, phi2}};
}

/// The involute that a straight piece cuts. [T3.8]
Involute rack_involute(const RackMotion& motion, const EdgeLine& line);

/// Returns the roll angle ξ of the involute point that the line cuts with its point at the height
/// x. x includes e.
double rack_involute_roll(const RackMotion& motion, const EdgeLine& line, double x);

}  // namespace gearwright
