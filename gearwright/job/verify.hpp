// Case files: published numbers with their source, run through the same door as a user's spec.
//
//   {"cases": [{"id", "source", "verb", "spec": {...},
//               "expected": {"pair.center_distance_mm": 56.4999},
//               "tolerance": {"relative", "absolute"}, "note"}]}
//
// "tolerance" may also hold "values": {path: absolute} for single values printed with other digits.
// A path per expected value, list places by number ("gears.0.base_diameter_mm"); numbers as
// printed. A number holds when it is within the relative or the absolute tolerance, whichever is
// wider; true, false, null and words hold when they are equal. A case that expects "error.key"
// wants that error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"

namespace gearwright {

struct CaseOutcome {
  std::string id;
  int values = 0;                        ///< how many were compared
  std::vector<std::string> differences;  ///< a line each; empty: the case holds
};

/// Runs the cases of one file.
///
/// Errors    a case file that is not of that form, or that holds no case: nothing checked is no
///           success
Result<std::vector<CaseOutcome>> verify_cases(std::string_view json_text);

}  // namespace gearwright
