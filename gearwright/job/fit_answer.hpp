// The verb fit computes the numbers that are absent in a spec and returns the gears with these
// numbers.
//
// An absent key means an unknown number here, not the default of the key. Every branch of the
// solution is returned as a spec for the other verbs. Internal to job/ and the program.
#pragma once

#include <string>

#include "gearwright/base/progress.hpp"
#include "gearwright/catalogue/fit_quantities.hpp"
#include "gearwright/design/fit.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct FitAnswer {
  Fit fit;
  std::vector<Json> specs;  ///< for each branch, the spec completed by the computed numbers
  /// For each branch, the reason why the verb pair rejects it, if it does. A conjugate line of
  /// action does not guarantee that the teeth are possible.
  std::vector<std::optional<Error>> refused{};
  std::optional<double> transverse_contact_ratio = std::nullopt;  ///< only for few teeth
};

/// Errors    the errors of fit, with the keys of the spec; `gear2` if it is missing
Result<FitAnswer> answer_fit(const JobSpec& spec, Progress* progress = nullptr);

/// The quantities of a result. The view points into `answer`.
FitView fit_view(const FitAnswer& answer);

/// {"fit": {"branches", "reason", "nearest"}}
Json fit_json(const FitAnswer& answer);

/// A table for users.
std::string fit_listing(const FitAnswer& answer, UnitSystem units);

// The verb fit for a pinion with few teeth and the wheel that it cuts ([fit] few_teeth = true).

/// Errors    keys of the spec that are not allowed here, or are missing
Result<FitAnswer> answer_few_teeth(const JobSpec& spec, Progress* progress = nullptr);

}  // namespace gearwright
