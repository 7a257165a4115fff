// The face widths that a design may have.
//
//   b    face width of both gears, mm: a given value, or the least value of a band with which the
//        design meets its limits
//   ε_β  overlap ratio
//
// Bands can be given for b, b/m_n and b/d_1. The face width lies within all of them, and is a multiple
// of a step, so that it suits a drawing.
#pragma once

#include <array>
#include <optional>

#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// The least and the greatest face width of a trial, mm. If least > greatest, there is no face width.
std::array<double, 2> face_widths(const SearchProblem& problem, const Trial& trial);

/// The least width with the required overlap ratio, mm; the greatest width if no width has this ratio.
double first_face_width(const ShiftGraph& graph);

/// The least possible face width of the trial that is at least `width` and greater than `before`, mm.
std::optional<double> next_face_width(const SearchProblem& problem, const Trial& trial,
                                      double before, double width);

}  // namespace gearwright
