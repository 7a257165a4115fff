// The drawing of a design of a search, and the verdict over it.
//
// A search computes nominal gears. The drawing adds the tolerances of tooth thickness and centre
// distance, and the pair is judged as any other pair, at all ends of them.
#pragma once

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/design/design_row.hpp"

namespace gearwright {

/// The design as a drawing gives it.
GivenPair drawing_of(const SearchProblem& problem, const DesignRow& row);

/// The verdict over the drawing, with the rating in a rated search. Findings that every design has
/// are left out: that the rating of plastics does not cover wear.
DrawnDesign judge_drawing(const SearchProblem& problem, const DesignRow& row);

}  // namespace gearwright
