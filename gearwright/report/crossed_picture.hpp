// A crossed pair seen along its centre line, from gear 2's side: y to the right, z up, axis 1
// upright. True to scale.
//
//   leading line A–E, trailing line A′–E′: its image under the half turn about the centre line
//   T_1, T_2  base tangent points      C  pitch point of gear 1
#pragma once

#include <array>
#include <string>

#include "gearwright/base/vector.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A point of the housing in this view, mm: (y, z).
Vec2 in_plan(const Point<Housing>& p);

/// Corners in this view of gear `which` (0, 1): its cylinder of `radius` from face to face.
std::array<Vec2, 4> face_in_plan(const InvolutePair& pair, std::size_t which, double radius);

/// The figures: lines of action in plan, and both gears whole.
///
/// Domain    crossed axes (contract)
std::string plan_figures(const InvolutePair& pair);

}  // namespace gearwright
