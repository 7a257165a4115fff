// Computes corrections that centre the contact pattern and minimise the transmission error. Errors
// are given as several sets, and the worst set counts.
//
//   v   corrections, in the caller's units          S   scenarios: sets of errors
//   f(v) = max_S peak to peak TE + w (max_S q² + max_S p²)   [T8.24] of docs/theory/08-contact.md
//
//   TE  transmission error as a continuous curve. It is evaluated between the computed positions as
//       well, because its minima usually lie between two positions
//   q   mean position of the contact pattern along the face, −1 to 1
//   p   mean position of the contact along the profile; 0 if this position has no target. For
//       circular-arc teeth, the target is the pressure angle of their racks
//
// If the caller gives w, a greater transmission error is accepted for a more central pattern. With
// the small default of w, corrections that increase the transmission error are rejected.
//
// f is a maximum of maxima, so its slope jumps along creases. The search therefore uses a method
// without derivatives (subplex), or for an aim with an estimate a method that linearises each of
// the maxima separately (math/minimax.hpp). The search has four kinds of start: zero, the
// least-squares solution of the linearised problem, starting values that the caller gives, and the
// best point found in the whole box of bounds.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/contact_score.hpp"
#include "gearwright/math/minimax.hpp"

namespace gearwright {

struct ArcPair;      // pair/arc_pair.hpp
class ContactSetup;  // contact/contact_setup.hpp

struct Correction {
  double lo, hi;  ///< bounds, in the caller's unit
  double step;    ///< size of a small change, in the caller's unit
};

/// A quantity that is minimised instead of the transmission error of rigid teeth. If a task has
/// such an aim, the position of the pattern is ignored. The arguments of `of` and `near` are the
/// corrections, the index of the scenario and the number of positions per pitch.
struct CompensationAim {
  /// Returns the quantity, in any unit. Infinity marks the worst possible pair, or no pair.
  std::function<double(const std::vector<double>&, int, int)> of;
  /// An estimate of the quantity after the corrections have changed by `change`. It is exact if
  /// `change` is 0.
  struct Estimate {
    std::function<double(const std::vector<double>& change)> value;
    /// The tangents of a function of `change` that increases with `value`.
    std::function<Tangents(const std::vector<double>& change)> tangents;
  };
  /// Returns the estimate around the corrections, for which the pair exists. `near` is empty if
  /// there is no estimate.
  std::function<Estimate(const std::vector<double>&, int, int)> near{};
  /// The smallest improvement that justifies a correction, in the unit of the quantity, > 0.
  double same = 0.0;
};

struct CompensationTask {
  std::vector<Correction> corrections;
  int scenarios = 1;
  int positions = 24;       ///< per pitch, during the search
  int fine_positions = 64;  ///< per pitch, for the reported scores
  int curves = 6000;        ///< approximate number of TE curves computed in each search
  /// w, the penalty for a contact pattern at the end of the face. If w is absent,
  /// default_centering() is used, and corrections must not increase the transmission error.
  std::optional<Angle> centering{};
  /// False if q is ignored, which is useful if the contact point moves along the whole face anyway.
  bool along_face = true;
  ProfileTarget profile{};
  std::vector<std::vector<double>> starts{};  ///< additional starting values of the search
  Progress* progress = nullptr;
  std::optional<CompensationAim> aim{};  ///< minimised in place of f, if present
  /// Returns the pair with these corrections under the scenario with this index. The result is null
  /// if the pair cannot be made.
  std::function<std::shared_ptr<const ContactPair>(const std::vector<double>&, int)> pair_at;
};

/// The change of the tool setting Δb_F that compensates the error ΔC of the centre distance, and
/// its effect. Lengths are in mm.
struct SettingAnswer {
  double exact, first_order;             ///< Δb_F by [T8.20], and its first order −ΔC [T8.21]
  std::optional<Angle> angle_nominal;    ///< θ, normal angle at the contact, without ΔC
  std::optional<Angle> angle_displaced;  ///< θ with ΔC
  std::optional<Angle> angle_exact, angle_first_order;  ///< θ with ΔC, after each setting
  /// Change of the normal thickness of the tooth that rack F cuts, at the height of the contact.
  double thickness_change;
  double backlash_change;  ///< change of the normal backlash, for the exact setting only
};
/// Returns the tool setting that compensates the error of the centre distance in `setup`. Returns
/// none if no gear is cut by a rack F, or if the teeth have no contact without this error.
std::optional<SettingAnswer> arc_setting(const ArcPair& arcs, const ContactSetup& setup);

/// The corrections of the lead angles. Each correction alone makes the slope of TE zero, while the
/// lead angle of the other gear remains unchanged. [T8.22]
struct LeadAnswer {
  std::array<std::optional<Angle>, 2> exact;  ///< Δλ_1, Δλ_2; none if not within ±0.01 rad
  std::optional<Angle> first_order;           ///< Δλ_1 of circular-arc teeth
  double slope;  ///< dTE/dφ1 in the middle of the mesh, before the correction
};
/// Returns the changes of the lead angles under the errors in `setup`. Returns none if the teeth
/// are spur teeth or if tooth pair 0 does not touch. Involute pairs need no such function, because
/// they touch along lines, and helix slope modifications correct their lead.
std::optional<LeadAnswer> lead_without_slope(const ArcPair& arcs, const ContactSetup& setup,
                                             bool gear2_drives);

struct Compensation {
  std::vector<double> value;
  ContactScore before, after;                         ///< each number is the worst of all scenarios
  std::vector<ContactScore> each_before, each_after;  ///< one score per scenario
  Angle centering;                                    ///< w

  /// True if every value is 0. All values are 0 if no corrections lower f by more than kSameError.
  /// With an aim, the limit is CompensationAim::same.
  bool nothing_to_correct() const;
};

/// The smallest difference of the transmission error that can be measured.
constexpr Angle kSameError = Angle::arcseconds(0.001);

/// A pair counts as free of error if the peak to peak of its TE is below this angle. At a radius of
/// 50 mm, this angle corresponds to 2 nm, and no real flank is that smooth.
constexpr Angle kQuiet = Angle::arcseconds(0.01);

/// Returns the default of w, a tenth of the peak to peak without corrections, but at least 0.1
/// arcsec. With this w, TE dominates f. The position of the pattern decides only between pairs
/// whose TE is small and about the same.
Angle default_centering(Angle peak_to_peak);

/// Rounds the values for a drawing. Each result is a multiple of step/parts of its correction, lies
/// within the bounds of this correction, and is the double nearest to its decimal number. A result
/// of 0 has no sign.
///
/// Domain    one value for each correction, parts > 0 (contract)
std::vector<double> as_written(const std::vector<Correction>& corrections,
                               std::vector<double> values, double parts);

/// Computes the values of the corrections of a task.
///
/// Domain    at least one correction, each with lo ≤ 0 ≤ hi and lo < hi, step > 0; at least one
///           scenario; positions and fine_positions ≥ 2 (contract)
/// Accuracy  f is at a local minimum, the lowest one that a deterministic search of the whole box
///           (DIRECT) and descents from several starts find. Values are multiples of a hundredth of
///           `step`. If this rounding loses more than 1 % of the gain and more than kSameError, a
///           smaller fraction of `step` is used. All values are 0 if the gain is below kSameError.
///           Without an aim, a value is 0 if the other corrections alone lose at most kSameError
///           plus 1 % of the gain. With an aim, CompensationAim::same replaces kSameError
/// Laws      (1) f(value) <= f(0) at fine_positions. With an aim, the worst value of the aim over
///               the scenarios is not greater with the corrections than without
///           (2) if w is not given and there is no aim, after.span is at most the greater of
///               before.span + kSameError and kQuiet
Compensation compensate(const CompensationTask& task);

}  // namespace gearwright
