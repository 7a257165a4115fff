// Computes the face widths that are permissible for a design.
//
//   b    face width of both gears, mm: either a given value, or the smallest value of a band for
//        which the design meets its limits
//   ε_β  overlap ratio
//
// A trial whose helix angle was chosen for a face width has this face width. For all other trials,
// bands can be given for b, b/m_n and b/d_1. The face width lies within all given bands. If the
// bands contain multiples of a step, the face width is one of these multiples, because drawings
// show round numbers.
#pragma once

#include <array>
#include <optional>

#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// The least and the greatest face width of a trial, mm. If least > greatest, no face width is
/// permissible.
std::array<double, 2> face_widths(const SearchProblem& problem, const Trial& trial);

/// The smallest permissible width with the required overlap ratio, mm. If no permissible width has
/// this overlap ratio, the result is the greatest permissible width.
double first_face_width(const ShiftGraph& graph);

/// The smallest permissible face width of the trial that is at least `width` and greater than
/// `before`, mm. Absent if there is none.
std::optional<double> next_face_width(const SearchProblem& problem, const Trial& trial,
                                      double before, double width);

}  // namespace gearwright
