// Draws circular-arc teeth at their contact.
//
//   ρ, a, b   radius of an arc and place of its centre, mm, as in pair/arc_contact.hpp
//   ψ_c       angle of the common normal to the pitch line, where the racks touch
//                                              theory: docs/theory/07-circular-arc.md, 7.1, 7.4
#pragma once

#include <vector>

#include "gearwright/curve/curve.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// Half a tooth of the gear's rack in its normal section, from the middle of the space to the
/// middle of the tooth: (height above the datum line, distance from the middle of the tooth), mm.
/// The tooth is cut off at the addendum and reduced by the thickness allowance.
///
/// Domain    a gear with arcs (contract)
std::vector<Vec2> rack_half_tooth(const Gear& gear);

/// The plane across a tooth. From the contact point, x points towards axis 2 and y across the
/// tooth.
struct NormalPlane {
  Vec3 origin, across, along;  ///< `along` is normal to the plane
};
NormalPlane normal_plane(const ArcPair& pair, const ArcPairContact& contact);

/// The intersection of the flanks and roots of gear i with that plane, in mm in the plane, for
/// `teeth` teeth on both sides of the nearest one. The gears are in the rotational position of the
/// contact.
std::vector<Vec2> normal_section(const ArcPair& pair, const ArcPairContact& contact, std::size_t i,
                                 int teeth);

/// The two racks that cut circular-arc teeth, in one normal section, and the teeth themselves in
/// the plane across the tooth through the contact point. There are none if the arcs do not touch, and only the teeth if
/// they do not touch at the reference centre distance.
std::vector<Figure> arc_contact_figures(const ArcPair& pair);

}  // namespace gearwright
