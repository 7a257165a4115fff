// Writes teeth with flank modifications as an advanced B-rep of a STEP file. Internal to cad/.
//
//   layer   between two levels: planes, and the lines where end reliefs begin
//   slice   between two planes
//
// Flanks and fillets are one B-spline face per arc and layer (cad/modified_fit.hpp). Lands are true
// cylinders, one face per slice, whose sides consist of one edge per layer. An edge on a land deviates
// from its cylinder by at most kHelixTarget_mm.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/modified_fit.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Writes the solid of a body with these teeth in its own frame.
///
/// Units     mm
/// Domain    walls = make_walls(body), fit = fit_modified(teeth, …) (contract)
Brep add_modified_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls,
                       const ModifiedTeeth& teeth, const ModifiedFit& fit);

}  // namespace gearwright
