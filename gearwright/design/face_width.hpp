// Computes the permissible face widths of a design.
//
//   b    face width of both gears, mm: either a given value, or the smallest value of a band for
//        which the design meets its limits
//   ε_β  overlap ratio
//
// If the helix angle of a trial was chosen for a face width, the trial has this face width. For
// other trials, the user can give bands for b, b/m_n and b/d_1, and the face width lies within all
// of them. If the bands contain multiples of a step, the face width is such a multiple, because
// drawings show round numbers.
#pragma once

#include <array>
#include <optional>

#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// Returns the least and the greatest face width of a trial, mm. If the first exceeds the second,
/// no face width is permissible.
std::array<double, 2> face_widths(const SearchProblem& problem, const Trial& trial);

/// Returns the smallest permissible width with the required overlap ratio, mm. If there is no such
/// width, the function returns the greatest permissible width.
double first_face_width(const ShiftGraph& graph);

/// Returns the smallest permissible face width of the trial that is at least `width` and greater
/// than `before`, mm. The result is absent if there is no such width.
std::optional<double> next_face_width(const SearchProblem& problem, const Trial& trial,
                                      double before, double width);

}  // namespace gearwright
