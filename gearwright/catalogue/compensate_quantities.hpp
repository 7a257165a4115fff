// The quantities of corrections: `compensate` of a result.
#pragma once

#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/contact/compensation.hpp"
#include "gearwright/load/loaded_score.hpp"

namespace gearwright {

/// A correction found, by its key and its unit as keys end: "gear1.lead_crowning_um", "um".
struct FoundCorrection {
  std::string key, unit;
  std::string words, shown_unit;  ///< for people: "helix crowning of gear 1", "µm"
  double value;
  std::string spec_key;  ///< that holds it in the corrected spec
  bool at_bound;         ///< at the end of what is looked for
};

/// A set of errors in words, and what they do before and after.
struct Scenario {
  std::string errors;
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
  Value spec;  ///< the whole spec with the corrections in it
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<AimedLoad> loads{};  ///< of an aim under load
};

/// What nobody cares for less of: "0.001 ″".
const char* least_gain(CompensateAim aim);

const Quantities<CompensateView>& compensate_quantities();
const Quantities<FoundCorrection>& correction_quantities();
const Quantities<LoadedScore>& loaded_score_quantities();
/// Of one scenario, or of the worst of all.
const Quantities<ContactScore>& score_quantities();

}  // namespace gearwright
