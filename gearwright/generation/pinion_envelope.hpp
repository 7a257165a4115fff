// The envelope of a pinion cutter's outline in the transverse section of the gear that it
// generates.
//
//   r_p, r_g  radii of the two centrodes, mm; r_g < 0 if internal    m = z_0/z, < 0 if internal
//   s, q      the cutter's point along its tangent and along its outward normal ν, mm
//   w         √(r_p² − s²): the pitch point along ν when the normal passes through it
//   λ         w − q: from the cutter's point along ν to the pitch point
//
// The point is cut when its normal passes through the pitch point; κ = asin(s/r_p) is then the
// angle between the normal and the line of centres, and the cutter has turned by κ − ν. In the
// frame of the space the gear's point is  e^{−im(ν−κ)} (r_g + λ e^{iκ})  [T6.8]. Involutes generate
// involutes (closed form), and circles about the axis generate circles. This file computes all
// other curves.
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
  double distance;   ///< E > 0  mm
  double side() const { return side_of(teeth); }
  double ratio() const { return static_cast<double>(cutter_teeth) / teeth; }  ///< m
  double cutter_pitch_radius() const;                                         ///< r_p  mm
  double pitch_radius() const;                                                ///< r_g  mm, signed
};

/// A sharp corner of the cutter as a curve with the angle ν of its normals as parameter, which is a
/// circle of radius 0.
class CornerFan final : public Curve {
 public:
  explicit CornerFan(const Vec2& point) : point_(point) {}
  Vec2 point(double) const override { return point_; }
  CurvePoint at(double nu) const override;

 private:
  Vec2 point_;
};

/// True if the parameter of the cutter's curve grows from its root to its tip.
enum class Walk { forward, backward };

/// The normal meets the cutter's centrode twice: ahead of the tooth (w > 0), where it cuts root,
/// flank and tip, and behind it (w < 0), where it may trim the tip of an internal gear when the
/// tooth leaves [T6.13].
enum class Meeting { ahead, behind };

/// The envelope as a function of the cutter's own parameter.
///
/// Laws  (1) dW/dσ = i G e^{i(κ−mϑ)}, G = 1 + (1+m) λ (1 − k λ)/w, σ and k length and curvature of
///           the cutter's curve: G = 0 is a cusp; [T6.9]
///       (2) d|W|²/dσ = −2 (r_g/r_p) s G: between cusps the radius is monotone
/// Domain  s ≤ r_p at every evaluated parameter
class PinionEnvelope final : public Curve {
 public:
  PinionEnvelope(const PinionMotion& motion, CurvePtr cutter, Walk walk,
                 Meeting meeting = Meeting::ahead);
  Vec2 point(double t) const override;
  CurvePoint at(double t) const override;
  double polar_angle(double t) const override;

  /// True if the cutter lies outside the gear's material around the point: s < r_p and w G > 0.
  bool cuts(double t) const;
  bool reaches(double t) const;  ///< s < r_p: the normal meets the centrode
  /// The parameters between a and b, ordered from a, at which cuts() may change: cusps and limits
  /// of reach. Exact for circles and corners, elsewhere isolated on 256 cells. [T6.9]
  std::vector<double> breaks(double a, double b) const;
  /// The parameters between a and b, ordered from a, at which the gear's half angle is stationary:
  /// q = w (1 + 1/m). [T6.10]
  std::vector<double> turns(double a, double b) const;

 private:
  struct Contact;
  struct Circle;
  Contact contact(double t) const;
  std::optional<Circle> circle() const;
  std::vector<double> centre_ways(std::span<const double> polynomial, double a, double b) const;

  PinionMotion motion_;
  CurvePtr cutter_;
  double walk_, meeting_;
  double r_p_, r_g_, m_;
};

/// The involute that the cutter's involute generates; none if the base circle does not lie inside
/// the centrode. Its ξ for the cutter's ξ_0 is (1 + m) tan α_w − m ξ_0, for an internal gear minus
/// that. [T6.11]
struct PinionInvolute {
  Involute flank;
  double roll_at_0, roll_per_roll;
  double roll(double cutter_roll) const { return roll_at_0 + roll_per_roll * cutter_roll; }
};
std::optional<PinionInvolute> pinion_involute(const PinionMotion& motion, const Involute& cutter,
                                              Meeting meeting = Meeting::ahead);

}  // namespace gearwright
