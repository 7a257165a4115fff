// Converts a design that a search has found to a drawing, and judges this drawing.
//
// A search computes nominal gears. The drawing adds the tolerances of tooth thickness and centre
// distance. The pair is judged like any other pair, at all ends of these tolerances.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// The design as the data of a drawing.
GivenPair drawing_of(const SearchProblem& problem, const DesignRow& row);

/// The verdict over the drawing, with the rating if the search is rated. The finding that a rating of
/// plastics does not cover wear is left out, because it applies to every design.
DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row);

}  // namespace gearwright
