// The pictures of a pair on parallel axes: the mesh at the pitch point and the whole pair, the path of
// contact, and the effect of the profile shifts on its centrodes.
//
// Meshes are drawn in the housing frame, seen from +z: axis 1 left, axis 2 right (an internal gear's
// too), y up. Gear 1 is turned so that its leading flank touches at C, gear 2 so that it is touched there;
// a backlash opens on the other side.
//
//   I    where the reference circles touch, at a_d      I′   the pitch point at a
//                                              theory: docs/theory/06-few-teeth.md, 6.2
#pragma once

#include <array>
#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Rotations of gear 1 and gear 2 out of the rest position of pair/pair.hpp at which the leading
/// flanks touch at C, counter-clockwise seen from +z: each puts its flank's point on the working
/// pitch circle on the centre line.
///
/// Formula   φ_1 = ψ_1, φ_2 = −σ (π/|z_2| − ψ_2);  ψ_i = s_bti/d_bi − inv α_wt the half angles of
///           the teeth on the working pitch circles, of an internal gear's s_bt2/d_b2 + inv α_wt
/// Units     rad
std::array<double, 2> rotation_to_pitch_point(const InvolutePair& pair);

/// The mesh and the whole pair; `shapes` are the names of the gears' definitions (gear_shape.hpp).
/// `below` are further figures under the whole pair, where the mesh leaves room beside it.
std::string mesh_figures(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                         const std::string& below = {});

/// The path of contact as a strip with its zones, and specific sliding over it.
std::string path_figure(const InvolutePair& pair);

/// Transverse, overlap and total contact ratio as bars.
std::string ratio_figure(const InvolutePair& pair);

/// True if the centrodes are worth a picture: parallel axes, a shift of the centre distance of at
/// least 0.02 m_n, and a reason for it in the gears (shifts, or a gear cut by a pinion cutter).
bool centrodes_are_worth_a_picture(const InvolutePair& pair);

/// The reference circles at the reference centre distance, where they roll on each other, and the
/// working pitch circles, which roll at the distance of the pair; empty if they show nothing of
/// interest.
std::string centrode_figures(const InvolutePair& pair);

}  // namespace gearwright
