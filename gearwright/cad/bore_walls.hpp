// The bore of a gear, or the rim of a ring, as a loop of walls.
//
//   r    bore radius, mm      w, t   keyway width and depth from the bore circle, mm
//
// The keyway is a slot along +y with a flat bottom at y = r + t and sides x = ±w/2, which meet the
// bore at y = √(r² − w²/4). What must lie inside the root is its corner, hypot(w/2, r + t). A slot
// so narrow and shallow that its sides would be slivers is left out.
#pragma once

#include "gearwright/base/result.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// The bore's loop; for a ring (teeth < 0) the bore is the rim, the cylinder round its roots.
///
/// Facts     those of bore_error and, of a ring: no rim, a rim inside its roots, a keyway
/// Units     inner, outer: extreme radii of the outline, mm
Result<WallLoop> make_bore(const ToothedBody& body, double inner, double outer);

}  // namespace gearwright
