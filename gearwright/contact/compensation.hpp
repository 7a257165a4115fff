// Corrections that make the worst of several errors as quiet, and its pattern as central, as they
// can be.
//
//   v   corrections, in the caller's units          S   scenarios: sets of errors
//   f(v) = max_S peak to peak TE + w · max_S (h² + p²)      [T8.24] of docs/theory/08-contact.md
//
//   h   mean place of the contact along the face, −1 to 1      p   the same along the profile,
//       where there is a target for it (the racks' pressure angle of circular-arc teeth)
//
// Whoever gives w asks for a trade: quiet running for a central pattern. Without one w is small,
// and no corrections are taken that make the transmission error greater than none do.
//
// f is a maximum of maxima and has creases, so that its own values lead the way (subplex), from
// several starts: as it is, the least squares answer of the linearised problem, what closed forms
// the caller has, and the best of the whole box.
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
  double step;    ///< what is a small change
};

/// Something else to be least than the transmission error of rigid teeth; the pattern's place then
/// counts nothing.
struct CompensationAim {
  /// At so many positions per pitch, in any unit; infinite: worse than anything.
  std::function<double(const ContactPair&, int)> of;
  double same = 0.0;  ///< > 0: nobody cares for less
};

struct CompensationTask {
  std::vector<Correction> corrections;
  int scenarios = 1;
  int positions = 24;                ///< per pitch, while looking
  int fine_positions = 64;           ///< per pitch, of the scores told
  int curves = 6000;                 ///< about so many are looked at by each search of the box
  std::optional<Angle> centering{};  ///< w  what a pattern at the end of the face may cost; absent:
                                     ///< default_centering, and the error never gets worse
  bool along_face = true;  ///< false: a contact point runs along the face anyhow, h does not count
  ProfileTarget profile{};
  std::vector<std::vector<double>> starts{};  ///< guesses beside its own
  Progress* progress = nullptr;               ///< told how far it is
  std::optional<CompensationAim> aim{};       ///< absent: f
  /// The pair under a scenario with the corrections made. Null where there is none.
  std::function<std::shared_ptr<const ContactPair>(const std::vector<double>&, int)> pair_at;
};

/// Δb_F after ΔC, and what it does. mm and rad.
struct SettingAnswer {
  double exact, first_order;             ///< Δb_F: [T8.20], −ΔC of [T8.21]
  std::optional<Angle> angle_nominal;    ///< normal angle θ at the contact: as drawn,
  std::optional<Angle> angle_displaced;  ///< with ΔC,
  std::optional<Angle> angle_exact, angle_first_order;  ///< and with either setting
  double thickness_change;  ///< of the tooth that F cuts, normal, at the contact's height
  double backlash_change;   ///< normal, for the exact setting alone
};

/// The change of a gear's lead angle that leaves no slope, the other gear's kept. [T8.22]
struct LeadAnswer {
  std::array<std::optional<Angle>, 2> exact;  ///< Δλ_1, Δλ_2
  std::optional<Angle> first_order;           ///< Δλ_1 of circular-arc teeth
  double slope;                               ///< dTE/dφ1 in the middle of the mesh, before
};

struct Compensation {
  std::vector<double> value;
  ContactScore before, after;                         ///< the worst, number by number
  std::vector<ContactScore> each_before, each_after;  ///< by scenario
  Angle centering;                                    ///< w
  int evaluations = 0;                                ///< of f

  /// No corrections lower f by 0.001 arcsec: every value is 0.
  bool nothing_to_correct() const;
};

/// No instrument sees a transmission error that differs by less.
constexpr Angle kSameError = Angle::arcseconds(0.001);

/// A pair with less runs without error: 2 nm on a radius of 50 mm, and no flank is that smooth. A
/// limit that is less binds nobody.
constexpr Angle kQuiet = Angle::arcseconds(0.01);

/// The w of a caller that asks for none: a tenth of the error as it stands, at least 0.1 arcsec.
/// What then counts most is TE; yet of two quiet pairs the one with the central pattern is better.
Angle default_centering(Angle peak_to_peak);

/// Values as a workshop writes them: whole numbers of a part of a step within the bounds, each the
/// nearest double to its decimal, and 0 without a sign.
///
/// Domain    as many values as corrections, parts > 0 (contract)
std::vector<double> as_written(const std::vector<Correction>& corrections,
                               std::vector<double> values, double parts);

/// Domain    at least one correction, each with lo ≤ 0 ≤ hi and lo < hi, step > 0; at least one
///           scenario; positions and fine_positions ≥ 2 (contract)
/// Accuracy  a local least of f, the best that a deterministic search of the whole box (DIRECT) and
///           descents from several starts find; values are multiples of a hundredth of `step`, of
///           less where that loses more than 1 % of what is gained; all are 0 where less than kSameError is to be had
/// Laws      (1) f(value) <= f(0) at fine_positions; of an aim its worst over the scenarios
///           (2) without a given w or an aim, after.peak_to_peak is at most before.peak_to_peak + kSameError,
///               or kQuiet where that is more
Compensation compensate(const CompensationTask& task);

}  // namespace gearwright
