// 3MF, the printers' format: XML in a ZIP, with units, names and places.
//
// Core specification 1.2: one mesh object per part in mm, and a build item that places it by its
// pose. Vertices are shared, so that a reader need not guess which ones are the same.
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// The bytes of a 3MF file.
///
/// Units     mm
/// Accuracy  9 significant digits: 0.05 nm at a radius of 50 mm
/// Domain    at least one part, an XML text below 2³² bytes (contract)
std::string threemf_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
