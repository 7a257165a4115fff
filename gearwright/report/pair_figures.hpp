// Draws the pictures of a pair on parallel axes, and of a rack and its pinion.
//
//   I    point where the reference circles touch at the reference centre distance a_d
//   I′   pitch point at the actual centre distance a
//                                              theory: docs/theory/06-few-teeth.md, 6.2
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/curve/curve.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/pair/rack_pair.hpp"
#include "gearwright/report/page_parts.hpp"

namespace gearwright {

/// Draws the mesh and the whole pair. `shapes` are the names of the SVG definitions of the gears
/// (gear_shape.hpp).
std::array<Figure, 2> mesh_figures(const InvolutePair& pair,
                                   const std::array<std::string, 2>& shapes);

/// Writes both figures as HTML. `below` contains further figures, which are placed below the
/// picture of the whole pair.
std::string mesh_part(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                      const FigureForm& form = {}, const std::string& below = {});

/// Draws the mesh of a rack and its pinion, with the definition of the rack's shape. `shapes` are
/// the names of the SVG definitions of pinion and rack.
///
/// Errors    as rack_definition()
Result<Figure> rack_figure(const RackPair& pair, const std::array<std::string, 2>& shapes);

/// Draws the path of contact as a strip with its zones, and the specific sliding along it.
Figure path_figure(const InvolutePair& pair);

/// Draws transverse, overlap and total contact ratio as bars.
Figure ratio_figure(const InvolutePair& pair);

/// True if a picture of the centrodes is useful. The centre distance must differ from the reference
/// centre distance by at least 0.02 m_n because of profile shifts or a pinion cutter.
bool centrodes_are_worth_a_picture(const ParallelPair& pair);

/// Draws two figures. The first shows the reference circles at the reference centre distance, and
/// the second shows the working pitch circles at the centre distance of the pair. The result is
/// empty if centrodes_are_worth_a_picture() is false.
std::string centrode_figures(const ParallelPair& pair, const FigureForm& form = {});

/// Draws circular-arc gears in the transverse section through contact point `which` of the pair.
/// `shapes` are as in mesh_figures().
Figure arc_mesh_figure(const ArcPair& pair, std::size_t which,
                       const std::array<std::string, 2>& shapes);

// Draws circular-arc teeth at their contact point.
//
//   ρ, a, b   radius of an arc and position of its centre, mm, as in pair/arc_contact.hpp
//   θ_0       angle of the common normal to the pitch line, where the racks touch
//                                              theory: docs/theory/07-circular-arc.md, 7.1, 7.4

/// Returns half a tooth of the gear's rack in the normal section, from the middle of the space to
/// the middle of the tooth. Each point is (height above the datum line, distance from the middle of
/// the tooth), mm. The tooth ends at the addendum, and its thickness includes the thickness
/// allowance.
///
/// Domain    a gear with arcs (contract)
std::vector<Vec2> rack_half_tooth(const Gear& gear);

/// The plane through the contact point, normal to the tooth. The origin is the contact point, x
/// points towards axis 2, and y points across the tooth.
struct NormalPlane {
  Vec3 origin, across, along;  ///< `along` is normal to the plane
};
NormalPlane normal_plane(const ArcPair& pair, const ArcPairContact& contact);

/// Returns the intersection of the plane with the flanks and roots of gear i, in mm, for `teeth`
/// teeth on either side of the tooth in contact. The gears are in the rotational position of the
/// contact.
std::vector<Vec2> normal_section(const ArcPair& pair, const ArcPairContact& contact, std::size_t i,
                                 int teeth);

/// Draws two figures. The first shows the racks that cut the teeth, in one normal section. The
/// second shows the teeth in the plane that is normal to them and contains the contact point. If
/// the arcs touch at the mounted centre distance but not at the reference centre distance, only the
/// second figure exists. If the arcs do not touch, there is no figure.
std::vector<Figure> arc_contact_figures(const ArcPair& pair);

}  // namespace gearwright
