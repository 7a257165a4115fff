// Computes the envelope of a pinion cutter's outline in the transverse section of the gear.
//
//   r_p, r_g  radii of the two centrodes, mm; r_g < 0 if internal    m = z_0/z, < 0 if internal
//   s, q      coordinates of a point of the cutter along its tangent and its outward normal ν, mm
//   w         √(r_p² − s²)  mm, coordinate of the pitch point along ν when the normal passes
//             through the pitch point
//   λ         w − q  mm, distance along ν from the point of the cutter to the pitch point
//
// A point of the cutter cuts when its normal passes through the pitch point. Then κ = asin(s/r_p)
// is the angle between the normal and the line of centres, and the cutter has turned by −ϑ with
// ϑ = ν − κ. In the frame of the space, the point of the gear is e^{−imϑ} (r_g + λ e^{iκ}) [T6.8].
// Involutes generate involutes (pinion_involute), and circles about the axis generate circles.
// PinionEnvelope computes the envelopes of all other curves.
//                                              theory: docs/theory/06-few-teeth.md
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "gearwright/curve/basic_curves.hpp"
#include "gearwright/curve/curve.hpp"
#include "gearwright/generation/outline.hpp"

namespace gearwright {

struct PinionMotion {
  int cutter_teeth;  ///< z_0 ≥ 1
  int teeth;         ///< z, negative for an internal gear
  double distance;   ///< E  generating centre distance, > 0, mm
  double side() const { return side_of(teeth); }
  template <class T = double>
  T ratio() const {  ///< m
    return T(cutter_teeth) / teeth;
  }
  template <class T = double>
  T cutter_pitch_radius() const {  ///< r_p  mm
    return side_of<T>(teeth) * T(distance) * cutter_teeth / (cutter_teeth + teeth);
  }
  template <class T = double>
  T pitch_radius() const {  ///< r_g  mm, signed
    return side_of<T>(teeth) * T(distance) * teeth / (cutter_teeth + teeth);
  }
};

/// The direction in which the parameter of a cutter's curve grows. `forward` means from the root of
/// the cutter to its tip.
enum class Walk { forward, backward };

/// The normal at a point of the cutter meets the centrode of the cutter twice, so the point cuts in
/// two positions. Ahead of the tooth (w > 0), the point cuts root, flank and tip. Behind the tooth
/// (w < 0), the point may trim the tip of an internal gear when the tooth of the cutter leaves the
/// space [T6.13].
enum class Meeting { ahead, behind };

namespace jets {

template <class T>
struct CornerFan {
  Plane<T> corner;
  T nu;
  Plane<T> point() const { return corner; }
  T tangent_angle() const { return nu - half_turn<T>() / 2; }
  T curvature() const { return -std::numeric_limits<T>::infinity(); }
};

/// The motion of the cutter in a scalar type, and the way along its outline.
template <class T>
struct PinionWay {
  PinionWay(const PinionMotion& motion, Walk walk, Meeting meeting)
      : teeth(motion.teeth),
        side(motion.side()),
        walk(walk == Walk::forward ? 1.0 : -1.0),
        meeting(meeting == Meeting::ahead ? 1.0 : -1.0),
        r_p(motion.cutter_pitch_radius<T>()),
        r_g(motion.pitch_radius<T>()),
        m(motion.ratio<T>()) {}
  int teeth;
  double side, walk, meeting;  // 1 or −1
  T r_p, r_g, m;
};

/// A point of the cutter in the position in which it cuts.
template <class T>
struct PinionContact {
  /// The point, the direction of the tangent and the curvature of the cutter's curve.
  PinionContact(const PinionWay<T>& way, const Plane<T>& point, const T& tangent_angle,
                const T& cutter_curvature)
      : curvature(way.walk * cutter_curvature) {
    const T zero(0);
    const T cos_t = way.walk * cos(tangent_angle), sin_t = way.walk * sin(tangent_angle);
    s = std::max(zero, T(point.x * cos_t + point.y * sin_t));  // never negative on an outline
    q = point.y * cos_t - point.x * sin_t;
    // At the limit of reach, s equals r_p within rounding, and the square root would lose half of
    // the digits. w is therefore set to 0, so that the paths ahead of and behind the tooth end in
    // the same point.
    const bool at_limit = way.r_p - s < 4 * std::numeric_limits<T>::epsilon() * way.r_p;
    w = at_limit ? zero : T(way.meeting * sqrt(std::max(zero, T((way.r_p - s) * (way.r_p + s)))));
  }
  T s, q, w;
  T curvature;  // k of the cutter's curve, followed from root to tip
  T lambda() const { return w - q; }
  T kappa() const { return atan2(s, w); }
  /// w G [T6.9].   Domain  a finite curvature
  T w_g(const T& m) const { return w + (T(1) + m) * lambda() * (T(1) - curvature * lambda()); }
};

/// The envelope at a point of the cutter with the polar angle `polar`.
template <class T>
struct PinionEnvelope {
  PinionWay<T> way;
  PinionContact<T> contact;
  T polar;

  // The point of the gear is factor e^{i phase} with factor = r_g + λ e^{iκ} and e^{iκ} = (w +
  // is)/r_p. On an internal gear, the negative of its conjugate is used instead.
  Plane<T> factor() const {
    const T lambda = contact.lambda();
    return {way.side * (way.r_g + lambda * contact.w / way.r_p), lambda * contact.s / way.r_p};
  }
  T phase() const {
    // ν lies in the half turn that begins at the polar angle. The polar angle is continuous along
    // the curve.
    const T theta = polar + atan2(contact.s, contact.q) - contact.kappa();  // ϑ = ν − κ
    return half_turn<T>() / std::abs(way.teeth) - abs(way.m) * theta;
  }
  Plane<T> point() const { return turned(factor(), phase()); }
  T polar_angle() const {
    const Plane<T> f = factor();
    return phase() + atan2(f.y, f.x);
  }
  T tangent_angle() const {
    const T half = half_turn<T>(), none(0);
    return phase() + way.side * (contact.kappa() + half / 2) + (way.side > 0.0 ? none : half) +
           (backward() ? half : none);
  }
  T curvature() const {
    const auto [above, below] = bend();
    return way.side * above / below * (backward() ? -1.0 : 1.0);
  }

 private:
  struct Bend {
    T above, below;
  };
  // k_g = (k w + n (1 − kλ))/(w + nλ (1 − kλ)) with n = 1 + m, [T6.9]. At a corner, where t is ν
  // and k = −∞, numerator and denominator are divided by k.
  Bend bend() const {
    const T lambda = contact.lambda(), k = contact.curvature, n = T(1) + way.m;
    if (isinf(k)) return {contact.w - n * lambda, -n * lambda * lambda};
    return {k * contact.w + n * (T(1) - k * lambda), contact.w_g(way.m)};
  }
  // True if t grows against the direction of the tangent.
  bool backward() const { return way.walk * way.meeting * bend().below < 0.0; }
};

}  // namespace jets

/// A sharp corner of the cutter as a curve of radius 0. The parameter is the angle ν of the normal.
class CornerFan final : public JetCurve<CornerFan> {
 public:
  explicit CornerFan(const Vec2& point) : corner_{point.x(), point.y()} {}
  jets::CornerFan<double> jet(double nu) const { return {corner_, nu}; }

 private:
  Plane<double> corner_;
};

/// The envelope as a function of the parameter of the cutter's curve. σ is the arc length of this
/// curve, and k is its curvature.
///
/// Laws  (1) dW/dσ = i G e^{i(κ−mϑ)} with G = 1 + (1+m) λ (1 − k λ)/w; a zero of G is a cusp [T6.9]
///       (2) d|W|²/dσ = −2 (r_g/r_p) s G, so the radius is monotone between cusps
/// Domain  s ≤ r_p at every evaluated parameter
class PinionEnvelope final : public JetCurve<PinionEnvelope> {
 public:
  PinionEnvelope(const PinionMotion& motion, CurvePtr cutter, Walk walk,
                 Meeting meeting = Meeting::ahead);
  jets::PinionEnvelope<double> jet(double t) const {
    return {way_, contact(t), cutter_->polar_angle(t)};
  }

  /// Returns true if the cutter lies outside the material of the gear near the point. This is the
  /// case if s < r_p and w G > 0.
  bool cuts(double t) const;
  bool reaches(double t) const;  ///< true if the normal meets the centrode, s < r_p
  /// Returns the parameters at which cuts() may change, in order from a to b. They are the cusps
  /// and the ends of the range in which the normal meets the centrode. For corners, they are
  /// computed in closed form. For circles, the cusps are roots of a cubic. For other curves, the
  /// roots are bracketed on 256 cells. [T6.9]
  std::vector<double> breaks(double a, double b) const;
  /// Returns the parameters at which the half angle of the gear tooth is stationary, in order from
  /// a to b. The condition is q = w (1 + 1/m). [T6.10]
  std::vector<double> turns(double a, double b) const;

 private:
  struct Circle;
  jets::PinionContact<double> contact(double t) const;
  std::optional<Circle> circle() const;
  std::vector<double> centre_ways(std::span<const double> polynomial, double a, double b) const;

  CurvePtr cutter_;
  jets::PinionWay<double> way_;
};

/// The involute that an involute of the cutter generates. The roll angle ξ_0 on the cutter gives
/// ξ = (1 + m) tan α_w − m ξ_0 on an external gear, and ξ = m ξ_0 − (1 + m) tan α_w on an internal
/// gear. [T6.11]
struct PinionInvolute {
  Involute flank;
  double roll_at_0, roll_per_roll;
  double roll(double cutter_roll) const { return roll_at_0 + roll_per_roll * cutter_roll; }
};
/// Returns the generated involute. The result is empty if the base circle of the cutter does not
/// lie inside the centrode.
std::optional<PinionInvolute> pinion_involute(const PinionMotion& motion, const Involute& cutter,
                                              Meeting meeting = Meeting::ahead);

}  // namespace gearwright
