// The quantities that a workshop measures, and the description of a gear by another rack. A result
// contains them under `measure` and `as_rack`.
#pragma once

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"

namespace gearwright {

/// The measurements of one gear.
const Quantities<GearMeasures>& measure_quantities();

/// Data of a rack that would cut the same teeth.
const Quantities<ReferenceInput<double>>& as_rack_quantities();

// Data of a flank for a measuring machine: roll lengths, evaluation ranges and tolerances. The
// record `measure` contains them under `flank` and `tolerances`.

const Quantities<EvaluationRanges>& range_quantities();
const Quantities<FlankToleranceValues>& tolerance_quantities();

}  // namespace gearwright
