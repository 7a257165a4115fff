// Writes a rack as an advanced B-rep of a STEP file. Internal to cad/.
//
//   part of the tooth   surface                                edges on the border
//   land, flank         plane                                  lines
//   fillet              cylinder along the tooth, radius ρ_f   ellipses (spur: circles)
//
// All surfaces and edges are exact. Every face is a strip of the plan (cad/rack_plan.hpp); a strip
// that contains a corner of the bar has five edges, or six if it contains two.
//
//   Law   every edge is used twice, once in each direction
#pragma once

#include "gearwright/cad/brep.hpp"

namespace gearwright {

/// Returns the number of faces: the strips, and the five planes of back, ends and sides.
std::size_t rack_face_count(const ToothedBody& body);

/// Writes the solid of a rack in its own frame (the pose is not applied).
///
/// Units     mm
/// Domain    a body that is a rack (contract)
Brep add_rack_brep(Part21& out, const ToothedBody& body);

}  // namespace gearwright
