// Converts a design that a search has found into the data of a drawing, and judges this drawing.
//
// A search computes nominal gears. The drawing adds the tolerances of tooth thickness and centre
// distance. The verdict covers the nominal pair and all ends of these tolerances.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// Converts a design to the data of a drawing.
GivenPair drawing_of(const SearchProblem& problem, const DesignRow& row);

/// The verdict on the drawing. If the search computes a rating, the verdict includes it. The
/// finding that the rating of plastics ignores wear is omitted, because it applies to every design.
DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row);

}  // namespace gearwright
