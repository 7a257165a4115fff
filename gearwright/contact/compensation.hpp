// Corrections that make the worst of several errors as quiet, and its pattern as central, as they
// can be.
//
//   v   corrections, in the caller's units          S   scenarios: sets of errors
//   f(v) = max_S peak to peak TE + w · max_S (h² + p²)      [T8.24] of docs/theory/08-contact.md
//
//   h   mean place of the contact along the face, −1 to 1      p   the same along the profile,
//       where there is a target for it (the racks' pressure angle of circular-arc teeth)
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

#include "gearwright/base/angle.hpp"
#include "gearwright/contact/contact_pair.hpp"

namespace gearwright {

struct Correction {
  double lo, hi;  ///< bounds, in the caller's unit
  double step;    ///< what is a small change
};

struct ContactScore {
  Angle peak_to_peak;          ///< greatest over the scenarios
  double along_face = 0.0;     ///< h: greatest magnitude over the scenarios, with its sign
  double along_profile = 0.0;  ///< p; 0 without a target
  bool lost = false;           ///< contact is lost somewhere
};

struct CompensationTask {
  std::vector<Correction> corrections;
  int scenarios = 1;
  int positions = 24;       ///< per pitch, while looking
  int fine_positions = 64;  ///< per pitch, of the scores told
  Angle centering{};        ///< w  what a pattern at the end of the face may cost
  bool along_face = true;   ///< false: a contact point runs along the face anyhow, h does not count
  Angle profile_target{};   ///< rack angle; with profile_width
  Angle profile_width{};    ///< what counts as the end; 0: no target
  std::vector<std::vector<double>> starts{};  ///< guesses beside the two of its own
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
  ContactScore before, after;
  std::vector<ContactScore> each_before, each_after;  ///< by scenario
  int evaluations = 0;                                ///< of f
};

/// Domain    at least one correction with lo ≤ 0 ≤ hi, at least one scenario (contract)
/// Accuracy  a local least of f, the best that a deterministic search of the whole box (DIRECT) and
///           descents from several starts find; values are rounded to a hundredth of `step`, and 0
///           where less than 0.001 arcsec is to be had
Compensation compensate(const CompensationTask& task);

/// Of one pair.
ContactScore score_of(const ContactPair& pair, int positions, Angle profile_target,
                      Angle profile_width);

}  // namespace gearwright
