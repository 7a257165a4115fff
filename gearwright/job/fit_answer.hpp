// The verb fit: a spec with numbers left out in, the gears that have them out.
//
// An absent key is an unknown here, not its default. Every branch comes as a spec of its own, which
// the other verbs take.
// Internal to job/ and the program.
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
  std::vector<Json> specs;  ///< of the branches: the spec as read, with what was found
  /// Of the branches: why the verb pair refuses it. A conjugate line of action is no tooth yet.
  std::vector<std::optional<Error>> refused{};
  std::optional<double> transverse_contact_ratio = std::nullopt;  ///< of a design with few teeth
};

/// Errors    as fit, with keys of the spec; `gear2` missing
Result<FitAnswer> answer_fit(const JobSpec& spec, Progress* progress = nullptr);

/// What the catalogue says of an answer; it points into the answer.
FitView fit_view(const FitAnswer& answer);

/// {"fit": {"branches", "reason", "nearest"}}
Json fit_json(const FitAnswer& answer);

/// A table for people.
std::string fit_listing(const FitAnswer& answer);

}  // namespace gearwright
