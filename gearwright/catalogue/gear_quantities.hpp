// The quantities of one gear, for the table of gear data. A result contains them under gears[i].
#pragma once

#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/gear/gear.hpp"
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

/// The quantities of a warning. A warning states a fact about a gear or a pair that is not an
/// error.
const Quantities<Warning>& warning_quantities();

/// The quantities of a gear. For a double-helical gear, `gear` is one half, but the record has the
/// whole face width.
ValueRecord gear_record(const Gear& gear, const std::optional<Halves>& halves);

/// Additional quantities of a double-helical gear.
const Quantities<Halves>& double_helical_quantities();

// The quantities of a verdict. A result contains them under `verdict`.

const Quantities<Verdict>& verdict_quantities();

}  // namespace gearwright
