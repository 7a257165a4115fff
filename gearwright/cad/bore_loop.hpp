// The bore's section: a circle, or a circle with a rectangular keyway.
//
//   r  bore radius     w, t  keyway width and depth     all mm
//
// The keyway's floor lies at y = r + t, its walls at x = ±w/2; w = 0: no keyway.
#pragma once

#include <vector>

#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// The wall's columns, counter-clockwise from the lowest point (0, −r), which is on the circle;
/// symmetric about the y axis bit for bit. Normals point into the hole.
///
/// Accuracy  chords leave the circle by at most `chord` mm and turn by at most `facet_turn` rad
/// Domain    a bore without bore_error (contract)
std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn);

}  // namespace gearwright
