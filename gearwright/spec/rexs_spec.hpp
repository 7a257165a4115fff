// Converts a REXS model to a spec: one cylindrical stage to a pair, a chain of stages to [[stage]]
// tables, and a planetary stage to [planetary]. Internal to spec/ and job/.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gearwright/spec/json.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright {

struct RexsSpec {
  Json tables;
  std::vector<std::string> notes;  ///< one sentence about each part that was not read
};

/// Errors    a model without cylindrical stages, or with stages of another type; stages that form
///           neither a chain nor one planetary set (set_of_rexs); a stage without two gears, a gear
///           without teeth
Result<RexsSpec> spec_of_rexs(const RexsModel& model);

/// The spec as TOML. Comments at its beginning name the version of the file and the parts that were
/// not read.
Result<std::string> spec_text_of_rexs(std::string_view xml);

}  // namespace gearwright
