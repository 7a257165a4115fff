// A crossed pair cut by the plane of the leading line of action, normal to the teeth of the common
// rack: the rack is seen as it is, the line of action at its true length under α_wn, cylinders as
// ellipses. The trailing line, in a parallel plane, is carried here along the teeth.
//
//   h    to the right, the way the rack moves      x   up, along the centre line, gear 1 to gear 2
//   z_L  the plane's offset along the teeth from the centre line, mm
#pragma once

#include <string>

#include "gearwright/base/vector.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// A point of the housing in this view, mm: (h, x).
///
/// Formula   h = −y cos β_1 + z sin β_1
Vec2 in_section(const InvolutePair& pair, const Point<Housing>& p);

struct SectionEllipse {
  Vec2 center;         ///< (h, x)  mm
  double half_width;   ///< along h, mm
  double half_height;  ///< along x, mm
};

/// The cylinder of `radius` about the axis of gear `which` (0, 1), cut by the plane.
///
/// Formula   centre (z_L tan β_1, 0), (−z_L tan β_2, a); half width r/cos β_i, half height r
/// Domain    crossed axes, radius > 0 (contract)
SectionEllipse section_of_cylinder(const InvolutePair& pair, std::size_t which, double radius);

/// The figure.
///
/// Domain    crossed axes (contract)
std::string section_figure(const InvolutePair& pair);

}  // namespace gearwright
