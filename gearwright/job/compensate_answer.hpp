// Corrections that a workshop can make against the errors of a housing: the verb `compensate`.
//
// Closed forms first, where the teeth have them: the tool setting that brings the contact of
// circular-arc teeth back after a change of centre distance, and the lead of either gear that takes
// the slope out of the transmission error. Then the corrections asked for, against the whole range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/compensation.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright {

/// Δb_F after ΔC, and what it does. mm
struct SettingAnswer {
  double exact, first_order;              ///< Δb_F: [T8.20], −ΔC of [T8.21]
  std::optional<Angle> angle_nominal;     ///< normal angle θ at the contact: as drawn,
  std::optional<Angle> angle_displaced;   ///< with ΔC,
  std::optional<Angle> angle_exact, angle_first_order;  ///< and with either setting
  double
      thickness_change;  ///< of the tooth of the gear that F cuts, normal, at the contact's height
  double backlash_change;  ///< normal, for the exact setting alone
};

/// The change of a gear's lead angle that leaves no slope, the other gear's kept. [T8.22]
struct LeadAnswer {
  std::array<std::optional<Angle>, 2> exact;  ///< Δλ_1, Δλ_2
  std::optional<Angle> first_order;           ///< Δλ_1 of circular-arc teeth
  double slope;                               ///< dTE/dφ1 in the middle of the mesh, before
};

struct CompensateAnswer {
  std::vector<std::size_t> corrections;  ///< in kCorrections
  Compensation result;
  std::vector<std::string> scenarios;
  std::optional<SettingAnswer> setting;
  std::optional<LeadAnswer> lead;
  std::string corrected;  ///< the spec with the corrections in it, JSON
};

/// Errors    as ContactSetup; `compensate.corrections` for one that the teeth cannot take; `errors`
///           when nothing touches as the pair stands
Result<CompensateAnswer> answer_compensate(SolvedJob& job);

}  // namespace gearwright
