// Computes the tooth that is bounded by the branches of an envelope.
//
// Internal to generation/. The height of a point is its radius on an external tooth, and minus its
// radius on the tooth of an internal gear. On both, the height increases from root to tip and along
// every branch. The tooth is the lower envelope of the half angles of the branches,
// |θ| < min θ(height).
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <functional>
#include <vector>

#include "gearwright/curve/curve.hpp"
#include "gearwright/generation/generate.hpp"

namespace gearwright::detail {

/// A branch counts as reaching the tip circle if it ends below the tip by at most this fraction of
/// the tip radius.
inline constexpr double kAtTip = 1e-9;

struct Branch {
  ArcName name;
  CurvePtr curve;
  double t_lo, t_hi;
  double height_lo, height_hi;
  bool smooth_start = false;         ///< true if the branch continues the preceding branch smoothly
  double side = 1.0;                 ///< height = side · radius; −1 on an internal gear
  std::vector<double> turns = {};    ///< parameters at which the half angle is stationary
  bool ends_on_center_line = false;  ///< true if a rounded tip ends the branch at θ = 0

  double height(double t) const { return side * curve->point(t).norm(); }
  double t_at(double h) const;
  double theta_at(double h) const { return curve->polar_angle(t_at(h)); }
  void end_at(double h);
  void start_at(double h);
};

Branch branch_of(ArcName name, CurvePtr curve, double t_lo, double t_hi, double side);

/// The limits of the branches of a tooth. `side` is equal to Branch::side.
struct ToothEnds {
  int teeth;               ///< z
  double side;             ///< 1; −1 for an internal gear
  double root_land_angle;  ///< rad, polar angle where the root land ends; π/|z| without a root land
  double blank_radius;     ///< mm; infinite (internal gear: 0) if no blank is given
  double cutter_radius;    ///< mm, where the cutter ends the tooth; infinite (internal gear: 0) if
                           ///< the cutter has no bottom
  bool rack = true;        ///< true if the cutter is a rack
  bool turns_back = false;  ///< true if the cutter may also cut behind the tooth
  /// Returns all branches, ahead of and behind the tooth. The function is not set for a rack.
  std::function<std::vector<Branch>()> all = {};
};

/// Joins the branches, which are ordered from root to tip, and ends them at the tip. On entry,
/// `tooth` contains root_radius and the requested fillets. The function sets all other members. If
/// the tooth is severed, its outline is empty.
///
/// Errors    `tip_diameter` if the blank leaves no tooth above the root; `cut_by` if the branches
///           of a pinion cutter do not join; `root_fillet.offset` or `tip_fillet` if no flank is
///           left
Result<GeneratedTooth> finish_tooth(const std::vector<Branch>& branches, const ToothEnds& ends,
                                    GeneratedTooth tooth);

// A chain is a list of branches in order of height. Each branch begins at the end of the preceding
// branch, so the chain represents the half angle as a function of the height.

/// Returns the chain up to the tip. The branches must be in the order of the cutter's edge from
/// root to tip. The result is empty if the ends of two neighbouring branches do not meet.
std::vector<Branch> assemble(const std::vector<Branch>& branches, double tip_height);

/// Returns the chain up to the tip, for branches in any order. The chain begins at the root with
/// the first branch and follows the lowest half angle at every height [T6.13]. The result is empty
/// if no branch continues the chain up to the tip. This function is slower than assemble() and is
/// used if the path of a point of the cutter turns back.
std::vector<Branch> lower_envelope(const std::vector<Branch>& branches, double tip_height);

/// Returns true if every branch begins at the end of the preceding branch.
bool is_continuous(const std::vector<Branch>& chain);

}  // namespace gearwright::detail
