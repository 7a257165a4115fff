// The verb `identify` computes the gears that agree with the readings of an unknown gear.
// Internal to job/ and the program.
#pragma once

#include <string>
#include <vector>

#include "gearwright/inspection/identify.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/spec.hpp"

namespace gearwright {

struct IdentifyAnswer {
  int gear;  ///< 1 or 2, the gear with the readings
  Identification found;
  std::vector<Json> specs;  ///< for each candidate, the spec with the data of that candidate
  /// For each candidate, a sentence with its number and likelihood, followed by sentences about
  /// data of the gear that the readings do not determine.
  std::vector<std::vector<std::string>> notes;
};

/// Computes the candidates for the unknown gear of the spec.
///
/// Errors    `gear1.measured` if it is missing; the errors of identify(), with the keys of the spec
Result<IdentifyAnswer> answer_identify(const JobSpec& spec);

/// {"identify": {"candidates", "contradiction", "next_measurement", "reason"}}
Json identify_json(const IdentifyAnswer& answer);

/// A table for users.
std::string identify_listing(const IdentifyAnswer& answer, UnitSystem units);

}  // namespace gearwright
