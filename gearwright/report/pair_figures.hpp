// The pictures of a pair on parallel axes: the mesh at the pitch point, the whole pair, the path of
// contact, and the effect of the profile shifts on the centrodes.
//
//   I    point where the reference circles touch, at a_d      I′   the pitch point at a
//                                              theory: docs/theory/06-few-teeth.md, 6.2
#pragma once

#include <array>
#include <string>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The mesh and the whole pair. `shapes` are the names of the SVG definitions of the gears
/// (gear_shape.hpp).
std::array<Figure, 2> mesh_figures(const InvolutePair& pair,
                                   const std::array<std::string, 2>& shapes);

/// HTML with both figures. `below` contains further figures, which are placed below the picture of
/// the whole pair.
std::string mesh_part(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                      const std::string& below = {});

/// The path of contact as a strip with its zones, and the specific sliding along it.
Figure path_figure(const InvolutePair& pair);

/// Transverse, overlap and total contact ratio as bars.
Figure ratio_figure(const InvolutePair& pair);

/// True if the centrodes are worth a picture: the axes are parallel, the centre distance differs
/// from the reference one by at least 0.02 m_n, and profile shifts or a pinion cutter are the
/// reason.
bool centrodes_are_worth_a_picture(const InvolutePair& pair);

/// Two figures: the reference circles at the reference centre distance, and the working pitch
/// circles at the centre distance of the pair. Empty if centrodes_are_worth_a_picture() is false.
std::string centrode_figures(const InvolutePair& pair);

}  // namespace gearwright
