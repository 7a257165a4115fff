// The quantities that a workshop measures, and a gear as another rack describes it: `measure` and
// `as_rack` of a result.
#pragma once

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/gear/reference.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"

namespace gearwright {

struct ChordView {
  double diameter;  ///< mm, at which the jaws touch
  ChordalThickness<double> chord;
};

/// Of one gear; none: it has no chord.
const Quantities<std::optional<ChordView>>& measure_quantities();

/// Of a rack that would cut the same teeth.
const Quantities<ReferenceInput<double>>& as_rack_quantities();

}  // namespace gearwright
