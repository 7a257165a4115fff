// The bore's section: a circle, or a circle with a rectangular keyway.
//
//   r  bore radius     w, t  keyway width and depth     all mm
//
// The keyway's floor lies at y = r + t, its walls at x = ±w/2; w = 0: no keyway.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/cad/mesh_builder.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {

/// Largest distance of the bore's wall from the axis, mm: the keyway's corner, or the circle.
double bore_reach(const Bore& bore);

/// Nothing wrong: an empty optional. Else the key at fault and what is allowed.
///
/// Domain    `room` mm: the radius that the bore and its keyway must not exceed
std::optional<Error> bore_error(const Bore& bore, double room);

/// The wall's columns, counter-clockwise from the lowest point (0, −r), which is on the circle;
/// symmetric about the y axis bit for bit. Normals point into the hole.
///
/// Accuracy  chords leave the circle by at most `chord` mm and turn by at most `facet_turn` rad
/// Domain    a bore without bore_error (contract)
std::vector<Column> bore_columns(const Bore& bore, double chord, double facet_turn);

}  // namespace gearwright
