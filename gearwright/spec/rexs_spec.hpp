// A REXS model as a spec: one cylindrical stage as a pair, a chain of stages as [[stage]]s, and a
// planetary stage as [planetary]. Internal to spec/ and job/.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gearwright/spec/json.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright {

struct RexsSpec {
  Json tables;
  std::vector<std::string> notes;  ///< what was not read, a sentence each
};

/// Errors    a model without cylindrical stages; stages that form neither a chain nor one planetary
///           set; a stage without two gears, a gear without teeth
Result<RexsSpec> spec_of_rexs(const RexsModel& model);

/// The spec as TOML, under comments that name the file's version and what was not read.
Result<std::string> spec_text_of_rexs(std::string_view xml);

}  // namespace gearwright
