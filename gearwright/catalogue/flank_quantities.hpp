// Data of a flank for a measuring machine: roll lengths, evaluation ranges and tolerances. They are
// `flank` and `tolerances` in `measure`.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"

namespace gearwright {

const Quantities<EvaluationRanges>& range_quantities();
const Quantities<FlankToleranceValues>& tolerance_quantities();

}  // namespace gearwright
