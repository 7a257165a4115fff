// The verbs `fit` and `identify` compute gears that the spec does not give completely.
// Internal to job/ and the programs.
//
// The verb `fit` computes the numbers that are absent in a spec. Here, an absent key means an
// unknown number and not the default of the key. Every branch of the solution is returned as a spec
// for the other verbs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/design/fit.hpp"
#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct FitAnswer : FitView {
  std::vector<Json> specs{};  ///< for each branch, the spec completed by the computed numbers
  std::string remark{};       ///< a sentence for users about the design; may be empty
};
void add_branch(FitAnswer& answer, const FitBranch& branch, Json spec,
                const std::optional<double>& transverse_contact_ratio = {});

/// Errors    `gear1` or `gear2` if it is missing; `gearN.…` for circular arcs, for `cut_by`, or for
///           values outside their limits; `gear2.form` for a rack; `gear2.normal_module` if the
///           gears differ in module or pressure angle although helix angles or profile shifts are
///           unknown; the errors of fit() and answer_few_teeth()
Result<FitAnswer> answer_fit(const JobSpec& spec, Progress* progress = nullptr);

/// {"fit": {"branches", "reason", "nearest"}}
Json fit_json(const FitAnswer& answer);

std::string fit_listing(const FitAnswer& answer, UnitSystem units);

// The verb `fit` for a pinion with few teeth and the wheel that it cuts ([fit] few_teeth = true).

/// Errors    keys of the spec that are not allowed here; a bore that does not fit the computed
///           gear; the errors of design_few_teeth()
Result<FitAnswer> answer_few_teeth(const JobSpec& spec, Progress* progress);

// The verb `identify` computes the gears that agree with the readings of an unknown gear.

struct IdentifyAnswer : IdentifyView {
  std::vector<Json> specs;  ///< for each candidate, the spec with the data of that candidate
  /// For each candidate, a list of sentences. The first sentence contains the number and the
  /// likelihood of the candidate. Further sentences describe, for example, data of the gear that
  /// the readings do not determine.
  std::vector<std::vector<std::string>> notes;
  std::vector<Warning> warnings;
};

/// Computes the candidates for the unknown gear of the spec. If both gears have readings, gear 1 is
/// the unknown gear. A warning then names the readings of gear 2 that were not used.
///
/// Errors    `gear1.measured` if it is missing; the errors of identify(), with the keys of the spec
Result<IdentifyAnswer> answer_identify(const JobSpec& spec);

/// {"identify": {"candidates", "contradiction", "next_measurement", "alternative", "reason"}}
Json identify_json(const IdentifyAnswer& answer);

std::string identify_listing(const IdentifyAnswer& answer, UnitSystem units);

}  // namespace gearwright
