// The quantities of corrections. A result contains them under `compensate`.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/contact/compensation.hpp"
#include "gearwright/load/load_summary.hpp"

namespace gearwright {

/// A correction that was found. `key` and `unit` are written as in specs, for example
/// "gear1.lead_crowning_um" and "um".
struct FoundCorrection {
  std::string key, unit;
  std::string words;  ///< for users: "helix crowning of gear 1"
  double value;
  std::string spec_key;  ///< key of the correction in the corrected spec
  bool at_bound;         ///< true if the value is at the end of the searched range
};

/// The value of an error of error_entries(), in the unit of its key.
struct ErrorValue {
  std::size_t index;
  double value;
};
/// Returns the errors with their keys, "crossing_deg = -0.01, axial_mm = 2". Without values, these
/// are the errors of the spec, and the text is "as given".
std::string errors_text(const std::vector<ErrorValue>& errors);

/// A set of errors, and its effect before and after the correction.
struct Scenario {
  std::vector<ErrorValue> errors;  ///< as in errors_text()
  ContactScore before, after;
};

struct CompensateView {
  std::vector<FoundCorrection> corrections;
  ContactScore before, after;
  bool nothing_to_correct = false;
  Angle centering;
  std::vector<Scenario> scenarios;
  std::optional<SettingAnswer> setting;
  std::optional<LeadAnswer> lead;
  Value spec;  ///< the whole spec with the corrections
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<AimedLoad> loads{};  ///< results for each torque; empty unless under_load(aim)
};

/// Returns the smallest improvement for which corrections are made, as text: "0.001 ″".
const char* least_gain(CompensateAim aim);

const Quantities<CompensateView>& compensate_quantities();
const Quantities<FoundCorrection>& correction_quantities();
const Quantities<LoadedScore>& loaded_score_quantities();
/// The score of one scenario, or the worst score of all scenarios.
const Quantities<ContactScore>& score_quantities();

}  // namespace gearwright
