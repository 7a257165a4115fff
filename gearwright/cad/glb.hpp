// GLB, glTF 2.0 in one binary file: what browsers and viewers show.
//
// One node per part with its pose as matrix, one mesh with smooth normals, one material of its own
// colour. Metres, as glTF wants. The gear axis stays z, which in glTF points at the viewer: a gear
// is seen from its face.
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// The bytes of a GLB file.
///
/// Accuracy  coordinates rounded to float32 metres: 2 nm at a radius of 50 mm
/// Domain    at least one part, rigid poses, fewer than 2³² bytes in all (contract)
std::string glb_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
