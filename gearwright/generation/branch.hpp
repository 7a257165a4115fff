// A branch of an envelope that may bound the tooth, and the tooth that results from many branches.
//
// Internal to generation/. The height grows along a branch. It is the radius on an external tooth
// and minus the radius on the tooth of an internal gear, so heights rise from root to tip on both.
// The tooth is the lower envelope of the half angles of the branches, |θ| < min θ(height). Two
// neighbours that do not join smoothly meet in a true intersection, which is found in a closed
// bracket.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <functional>
#include <vector>

#include "gearwright/curve/arc_name.hpp"
#include "gearwright/curve/curve.hpp"
#include "gearwright/generation/generate.hpp"

namespace gearwright::detail {

/// Relative difference within which the bottom of the cutter ends on the circle of the land.
inline constexpr double kAtTip = 1e-9;

struct Branch {
  ArcName name;
  CurvePtr curve;
  double t_lo, t_hi;
  double height_lo, height_hi;
  bool smooth_start = false;         ///< continues from the end of the preceding branch
  double side = 1.0;                 ///< height = side·|W|; −1 on an internal gear
  std::vector<double> turns = {};    ///< parameters at which the half angle is stationary
  bool ends_on_center_line = false;  ///< a rounded tip: θ = 0 at its end, without a point

  double height(double t) const { return side * curve->point(t).norm(); }
  double t_at(double h) const;
  double theta_at(double h) const { return curve->polar_angle(t_at(h)); }
  void end_at(double h);
  void start_at(double h);
};

/// Makes the branch of `curve` from t_lo to t_hi, with heights computed from the curve.
Branch branch_of(ArcName name, CurvePtr curve, double t_lo, double t_hi, double side);

/// The limits of the branches, which are ordered from root to tip. `side` is that of the branches.
struct ToothEnds {
  int teeth;                ///< z
  double side;              ///< 1; −1 for an internal gear
  double root_land_angle;   ///< rad, polar angle where the root land ends; π/|z| if there is none
  double blank_radius;      ///< mm; infinite (internal gear: 0) if there is none
  double cutter_radius;     ///< mm, radius at which the cutter itself ends the tooth; infinite
                            ///< (internal gear: 0) if it does not
  bool rack = true;         ///< cut by a rack
  bool turns_back = false;  ///< true if the cutter may also cut behind the tooth
  std::function<std::vector<Branch>()> all = {};  ///< in that case, returns every branch, both
                                                  ///< ahead and behind
};

/// Joins the branches and ends them at the tip. `tooth` contains root_radius and the requested
/// fillets, and the function sets all other members. Severed teeth have no outline.
///
/// Errors    `tip_diameter_mm` if the blank leaves no tooth above the root; `cut_by` if the cutter
///           removes the flank itself when it leaves
Result<GeneratedTooth> finish_tooth(const std::vector<Branch>& branches, const ToothEnds& ends,
                                    GeneratedTooth tooth);

}  // namespace gearwright::detail
