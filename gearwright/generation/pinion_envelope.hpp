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
  double ratio() const { return static_cast<double>(cutter_teeth) / teeth; }  ///< m
  double cutter_pitch_radius() const;                                         ///< r_p  mm
  double pitch_radius() const;                                                ///< r_g  mm, signed
};

/// A sharp corner of the cutter as a curve of radius 0. The parameter is the angle ν of the normal.
class CornerFan final : public Curve {
 public:
  explicit CornerFan(const Vec2& point) : point_(point) {}
  Vec2 point(double) const override { return point_; }
  CurvePoint at(double nu) const override;

 private:
  Vec2 point_;
};

/// The direction in which the parameter of a cutter's curve grows. It is `forward` from root to tip
/// of the cutter.
enum class Walk { forward, backward };

/// The normal at a point of the cutter meets the centrode of the cutter twice, so the point cuts in
/// two positions. Ahead of the tooth (w > 0), the point cuts root, flank and tip. Behind the tooth
/// (w < 0), the point may trim the tip of an internal gear when the tooth of the cutter leaves the
/// space [T6.13].
enum class Meeting { ahead, behind };

/// The envelope as a function of the parameter of the cutter's curve. σ is the arc length of this
/// curve, and k is its curvature.
///
/// Laws  (1) dW/dσ = i G e^{i(κ−mϑ)} with G = 1 + (1+m) λ (1 − k λ)/w; a zero of G is a cusp [T6.9]
///       (2) d|W|²/dσ = −2 (r_g/r_p) s G, so the radius is monotone between cusps
/// Domain  s ≤ r_p at every evaluated parameter
class PinionEnvelope final : public Curve {
 public:
  PinionEnvelope(const PinionMotion& motion, CurvePtr cutter, Walk walk,
                 Meeting meeting = Meeting::ahead);
  Vec2 point(double t) const override;
  CurvePoint at(double t) const override;
  double polar_angle(double t) const override;

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
  struct Contact;
  struct Place;
  struct Circle;
  Contact contact(double t) const;
  Place place(double t, const Contact& contact) const;
  std::optional<Circle> circle() const;
  std::vector<double> centre_ways(std::span<const double> polynomial, double a, double b) const;

  PinionMotion motion_;
  CurvePtr cutter_;
  double walk_, meeting_;
  double r_p_, r_g_, m_;
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
