// The face widths that a design may have.
//
//   b    face width of both gears, mm: one value, or the least of a band with which the design
//        meets its limits
//   ε_β  overlap ratio
//
// Bands are given for b, b/m_n and b/d_1; a width lies within all of them. Widths within a band are
// multiples of a step, so that they suit a drawing.
#pragma once

#include <array>
#include <optional>

#include "gearwright/design/shift_graph.hpp"

namespace gearwright {

/// The least and the greatest face width of a trial, mm; there is none if least > greatest.
std::array<double, 2> face_widths(const SearchProblem& problem, const Trial& trial);

/// The least width that has the required overlap ratio, mm; the greatest one if none has it.
double first_face_width(const ShiftGraph& graph);

/// The least width of the trial that is at least `width` and greater than `before`, mm; none if there
/// is no such width.
std::optional<double> next_face_width(const SearchProblem& problem, const Trial& trial,
                                      double before, double width);

}  // namespace gearwright
