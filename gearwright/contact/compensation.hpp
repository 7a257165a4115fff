// Corrections that minimise the transmission error under the worst of several errors and centre its
// contact pattern.
//
//   v   corrections, in the caller's units          S   scenarios: sets of errors
//   f(v) = max_S peak to peak TE + w · max_S (h² + p²)      [T8.24] of docs/theory/08-contact.md
//
//   h   mean place of the contact along the face, −1 to 1      p      the same along the profile,
//       if it has a target (the racks' pressure angle of circular-arc teeth)
//
// A given w trades quiet running for a central pattern. Without it w is small, and corrections are
// rejected if they make the transmission error greater than no corrections do.
//
// f is a maximum of maxima and has creases, so the search uses values only (subplex). It starts
// from zero, from the least squares solution of the linearised problem, from closed forms of the
// caller, and from the best point of the whole box.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/contact/contact_score.hpp"

namespace gearwright {

struct Correction {
  double lo, hi;  ///< bounds, in the caller's unit
  double step;    ///< a small change
};

/// Another quantity to minimise instead of the transmission error of rigid teeth. The position of
/// the pattern is then ignored.
struct CompensationAim {
  /// Evaluates the quantity with this number of positions per pitch, in any unit; infinite is worse
  /// than any value.
  std::function<double(const ContactPair&, int)> of;
  double same = 0.0;  ///< smallest improvement worth making, > 0
};

struct CompensationTask {
  std::vector<Correction> corrections;
  int scenarios = 1;
  int positions = 24;                ///< per pitch, during the search
  int fine_positions = 64;           ///< per pitch, for the reported scores
  int curves = 6000;                 ///< approximate number of curves in each search of the box
  std::optional<Angle> centering{};  ///< w, cost of a pattern at the end of the face; if absent,
                                     ///< default_centering, and the error never increases
  bool along_face = true;  ///< false if a contact point runs along the face in any case, so that h
                           ///< is ignored
  ProfileTarget profile{};
  std::vector<std::vector<double>> starts{};  ///< starting values in addition to its own
  Progress* progress = nullptr;               ///< reports the progress
  std::optional<CompensationAim> aim{};       ///< f if absent
  /// The pair under a scenario with these corrections; null if there is none.
  std::function<std::shared_ptr<const ContactPair>(const std::vector<double>&, int)> pair_at;
};

/// Δb_F for ΔC, and its effect. mm and rad.
struct SettingAnswer {
  double exact, first_order;             ///< Δb_F: [T8.20], −ΔC of [T8.21]
  std::optional<Angle> angle_nominal;    ///< normal angle θ at the contact as drawn,
  std::optional<Angle> angle_displaced;  ///< with ΔC,
  std::optional<Angle> angle_exact, angle_first_order;  ///< and with each of the two settings
  double thickness_change;  ///< change of the tooth that F cuts, normal, at the height of the
                            ///< contact
  double backlash_change;   ///< normal, for the exact setting only
};

/// The change of a gear's lead angle that leaves no slope, with the lead of the other gear
/// unchanged. [T8.22]
struct LeadAnswer {
  std::array<std::optional<Angle>, 2> exact;  ///< Δλ_1, Δλ_2
  std::optional<Angle> first_order;           ///< Δλ_1 of circular-arc teeth
  double slope;  ///< dTE/dφ1 in the middle of the mesh, before the correction
};

struct Compensation {
  std::vector<double> value;
  ContactScore before, after;                         ///< the worst of each number
  std::vector<ContactScore> each_before, each_after;  ///< by scenario
  Angle centering;                                    ///< w
  int evaluations = 0;                                ///< of f

  /// True if no corrections lower f by 0.001 arcsec. Every value is then 0.
  bool nothing_to_correct() const;
};

/// Differences of transmission error below this cannot be measured.
constexpr Angle kSameError = Angle::arcseconds(0.001);

/// A pair with less is free of error: 2 nm on a radius of 50 mm, which is smoother than any flank.
/// A smaller limit has no effect.
constexpr Angle kQuiet = Angle::arcseconds(0.01);

/// The default of w: a tenth of the present error, at least 0.1 arcsec. TE then dominates, but of
/// two quiet pairs the one with the central pattern is better.
Angle default_centering(Angle peak_to_peak);

/// Rounded values for a drawing: whole multiples of a part of a step within the bounds, each the
/// nearest double to its decimal, and 0 without a sign.
///
/// Domain    as many values as corrections, parts > 0 (contract)
std::vector<double> as_written(const std::vector<Correction>& corrections,
                               std::vector<double> values, double parts);

/// Domain    at least one correction, each with lo ≤ 0 ≤ hi and lo < hi, step > 0; at least one
///           scenario; positions and fine_positions ≥ 2 (contract)
/// Accuracy  a local minimum of f, the best found by a deterministic search of the whole box
///           (DIRECT) and by descents from several starts. Values are multiples of a hundredth of
///           `step`, or of less if that loses more than 1 % of the gain. All are 0 if the gain is
///           below kSameError
/// Laws      (1) f(value) <= f(0) at fine_positions; of an aim its worst over the scenarios
///           (2) without a given w or an aim, after.peak_to_peak is at most before.peak_to_peak + kSameError,
///               or kQuiet where that is more
Compensation compensate(const CompensationTask& task);

}  // namespace gearwright
