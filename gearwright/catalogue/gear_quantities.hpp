// The quantities of one gear, of a mounted pair and of their measurements. A result contains them
// under gears[i] and `pair`.
#pragma once

#include "gearwright/arrange/measured_gear.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

namespace gear_group {
constexpr const char* kTeeth = "Teeth";
constexpr const char* kDiameters = "Diameters";
constexpr const char* kTooth = "Tooth";
constexpr const char* kUndercut = "Undercut";
constexpr const char* kRootFillet = "Circular root fillet";
constexpr const char* kTipFillet = "Circular tip fillet";
constexpr const char* kCutter = "Cut by a pinion cutter";
constexpr const char* kBody = "Bore (for an internal gear, the rim)";
}  // namespace gear_group

const Quantities<Gear>& gear_quantities();

/// The quantities of a warning. A warning states a fact about a gear or a pair. It is not an error.
const Quantities<Warning>& warning_quantities();

/// Returns the quantities of a gear. For a double-helical gear, `gear` is one half, but the face
/// width in the record is that of the whole gear.
ValueRecord gear_record(const Gear& gear, const std::optional<Halves>& halves);

const Quantities<Halves>& double_helical_quantities();

// The quantities of a verdict. A result contains them under `verdict`.

const Quantities<Verdict>& verdict_quantities();

const Quantities<Pair>& pair_quantities();

// The quantities of a rack and of its pair with a pinion. A result for a rack and its pinion
// contains them under `gears` and `pair`.

const Quantities<RackGeometry>& rack_quantities();
const Quantities<RackPair>& rack_pair_quantities();

// The quantities that a workshop measures, and the description of a gear by another rack. A result
// contains them under `measure` and `as_rack`.

const Quantities<GearMeasures>& measure_quantities();

/// The data of another rack that would cut the same teeth.
const Quantities<ReferenceInput<double>>& as_rack_quantities();

// Data of a flank for a measuring machine: roll lengths, evaluation ranges and tolerances. The
// record `measure` contains them under `flank` and `tolerances`.

const Quantities<EvaluationRanges>& range_quantities();
const Quantities<FlankToleranceValues>& tolerance_quantities();

}  // namespace gearwright
