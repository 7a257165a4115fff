// The pictures of a pair on parallel axes: the mesh at the pitch point and the whole pair, the path
// of contact, and the effect of the profile shifts on its centrodes.
//
//   I    point where the reference circles touch, at a_d      I′   the pitch point at a
//                                              theory: docs/theory/06-few-teeth.md, 6.2
#pragma once

#include <array>
#include <string>

#include "gearwright/figure/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// The mesh and the whole pair. `shapes` are the names of the gears' definitions (gear_shape.hpp).
std::array<Figure, 2> mesh_figures(const InvolutePair& pair,
                                   const std::array<std::string, 2>& shapes);

/// Both for a page. `below` contains further figures, placed under the whole pair if the mesh leaves
/// room beside it.
std::string mesh_part(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                      const std::string& below = {});

/// The path of contact as a strip with its zones, and the specific sliding along it.
Figure path_figure(const InvolutePair& pair);

/// Transverse, overlap and total contact ratio as bars.
Figure ratio_figure(const InvolutePair& pair);

/// True if the centrodes are worth a picture. The axes are parallel, the centre distance differs
/// from the reference one by at least 0.02 m_n, and the gears explain it (shifts, or a gear cut by
/// a pinion cutter).
bool centrodes_are_worth_a_picture(const InvolutePair& pair);

/// The reference circles at the reference centre distance, where they roll on each other, and the
/// working pitch circles, which roll at the distance of the pair. Empty if they show nothing of
/// interest.
std::string centrode_figures(const InvolutePair& pair);

}  // namespace gearwright
