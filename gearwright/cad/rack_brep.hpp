// Writes a rack as an advanced B-rep of a STEP file. Internal to cad/.
//
//   part of the tooth   surface                                edges on the border
//   land, flank         plane                                  lines
//   fillet              cylinder along the tooth, radius ρ_f   ellipses (circles for a spur rack)
//
// All surfaces and edges are exact. Every face is a strip of the plan view (cad/rack_plan.hpp). A
// strip with a corner of the bar has five edges, and a strip with two corners has six.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include "gearwright/cad/brep.hpp"

namespace gearwright {

/// Returns the number of faces: the strips, and five planes for the back, the two ends and the two
/// sides.
std::size_t rack_face_count(const ToothedBody& body);

/// Writes the solid of a rack in its own frame. The pose is not applied.
///
/// Units     mm
/// Domain    a body that is a rack (contract)
Brep add_rack_brep(Part21& out, const ToothedBody& body);

}  // namespace gearwright
