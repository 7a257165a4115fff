// Writes teeth with flank modifications as an advanced B-rep of a STEP file. Internal to cad/.
//
//   layer   between two levels; levels are planes, and the lines at which end reliefs begin
//   slice   between two planes
//
// Flanks and fillets have one B-spline face per arc and layer (cad/modified_fit.hpp). Lands are
// true cylinders with one face per slice. Each side of such a face consists of one edge per layer.
// An edge on a land deviates from the cylinder by at most kHelixTarget_mm.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/modified_fit.hpp"
#include "gearwright/cad/modified_teeth.hpp"
#include "gearwright/cad/part21.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {

/// Writes the solid of a body with the given modified teeth, in its own frame.
///
/// Units     mm
/// Domain    walls = make_walls(body), fit = fit_modified(teeth, …) (contract)
Brep add_modified_brep(Part21& out, const ToothedBody& body, const BodyWalls& walls,
                       const ModifiedTeeth& teeth, const ModifiedFit& fit);

}  // namespace gearwright
