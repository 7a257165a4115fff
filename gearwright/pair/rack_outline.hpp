// The teeth of a rack in its transverse section, as an outline of the same kind as the outline of a gear.
//
//   x     height above the datum line, mm       y   along the travel, mm
//   s_n   thickness at the datum line, in the normal section, mm
//   ρ_f   radius of the root fillet, in the normal section, mm
//   n     y cos β, the coordinate y of the normal section, mm
//                                     theory: docs/theory/02-involute-and-pair.md, [T2.45]
//
// Frame of a rack: the origin is on the datum line, in the middle of length and face. x points from
// the back towards the teeth, and z along the face. In the section z = 0, tooth k of N is centred at
// y = (k − (N − 1)/2) p_t, and in the section z it is displaced by z tan β.
//
//   Laws  (1) the first point is the middle of the space, y = p_t/2, and the last point is the
//             middle of the tooth, y = 0
//         (2) the normal section, (x, y cos β), is the section of the spur rack with the same m_n
//         (3) the flank is straight, and its envelope is the flank of the pinion
#pragma once

#include "gearwright/generation/outline.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

/// Half a tooth from root to tip, with the x axis as its centre line. The member `teeth` of the
/// outline is the number of teeth of the rack, or 1 if no number is given.
///
/// Formula   [T2.45]: land at x = −h_f, circle of radius ρ_f (in the transverse section an ellipse),
///           line n = s_n/2 − x tan α_n, land at x = h_a
/// Units     mm
/// Accuracy  closed form
/// Errors    `gear2.thickness_allowance` if it makes the teeth pointed or closes the spaces
Result<Outline> rack_outline(const RackGeometry& rack);

}  // namespace gearwright
