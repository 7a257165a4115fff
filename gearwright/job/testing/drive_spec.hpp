// Reads specs of drives and computes their records, for the tests of job/.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::testing {

/// Returns the spec of a drive, or of a search for drives, in TOML.
inline JobSpec drive_job(const std::string& toml) {
  return taken(read_spec(toml, SpecFormat::toml));
}

/// Returns the record `drive` of the answer of the verb `drive`.
inline Json drive_record(const JobSpec& spec) {
  const auto answer = answer_drive(spec);
  EXPECT_TRUE(answer) << answer.error().message();
  return answer->record["drive"];
}

/// Returns the key of the error of a spec that cannot be read, or "" without an error.
inline std::string refused_drive_key(const std::string& toml) {
  const auto spec = read_spec(toml, SpecFormat::toml);
  return spec ? "" : spec.error().field;
}

}  // namespace gearwright::testing
