// The mounted pair: the mesh at the pitch point, and the whole pair.
//
// Both in the housing frame, seen from +z: axis 1 left, axis 2 right (an internal gear's too), y
// up. Gear 1 is turned so that its leading flank touches at C, gear 2 so that it is touched there;
// a backlash opens on the other side.
#pragma once

#include <array>
#include <string>

#include "gearwright/pair/pair.hpp"

namespace gearwright {

/// Rotations of gear 1 and gear 2 out of the rest position of pair/pair.hpp at which the leading
/// flanks touch at C, counter-clockwise seen from +z: each turns its flank's point on the working
/// pitch circle onto the centre line.
///
/// Formula   φ_1 = ψ_1, φ_2 = −σ (π/|z_2| − ψ_2);  ψ_i = s_bti/d_bi − inv α_wt the half angles of
///           the teeth on the working pitch circles, of an internal gear's s_bt2/d_b2 + inv α_wt
/// Units     rad
std::array<double, 2> rotation_to_pitch_point(const InvolutePair& pair);

/// The two figures; `shapes` are the names of the gears' definitions (gear_shape.hpp). `below` are
/// further figures under the whole pair, where the mesh leaves room beside it.
std::string mesh_figures(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                         const std::string& below = {});

}  // namespace gearwright
