// Case files contain published numbers with their source. The program computes these numbers as it
// does for the spec of a user. Internal to job/, the programs and tests.
//
//   {"cases": [{"id", "source", "verb", "spec": {...},
//               "expected": {"pair.center_distance_mm": 56.4999},
//               "tolerance": {"relative", "absolute"}, "note"}]}
//
// "tolerance" may also contain "values": {path: absolute}, for single values that are printed with
// another number of digits. Each expected value has a path. In a path, indices of lists are numbers
// ("gears.0.base_diameter_mm"). Numbers are given as printed. A number passes if it is within the
// relative or the absolute tolerance, whichever is wider. true, false, null and words pass if they
// are equal. A case that expects "error.key" passes only if that error occurs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

struct CaseOutcome {
  std::string id;
  int values = 0;                        ///< number of compared values
  std::vector<std::string> differences;  ///< one line each; empty if the case passes
};

/// Errors    a file that does not have the form above; a file without a case, because an empty
///           check must not pass
Result<std::vector<CaseOutcome>> verify_cases(std::string_view json_text);
/// Runs the cases of a tree that has been read.
Result<std::vector<CaseOutcome>> run_cases(const Json& file);

}  // namespace gearwright
