// Files of triangle meshes: STL, 3MF and GLB. The same parts give the same bytes (3MF: with the
// same zlib release).
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// The bytes of a binary STL file: a heap of triangles, read by every printer and every mesh tool.
///
/// 80 bytes of text, a count, then 50 bytes per triangle: normal, three corners, all float32 in mm,
/// and two bytes of nothing. All parts go into one heap at their poses. Corners that are one vertex
/// of the mesh are the same twelve bytes, so that readers find the mesh's own edges again.
///
/// Units     mm, in the frame the poses lead to
/// Accuracy  coordinates rounded to float32: 2 nm at a radius of 50 mm
/// Domain    fewer than 2³² triangles in all (contract)
std::string stl_bytes(const std::vector<MeshPart>& parts);

/// The bytes of a 3MF file, the printers' format: XML in a ZIP, with units, names and places.
///
/// Core specification 1.2: one mesh object per part in mm, and a build item that places it by its
/// pose. Vertices are shared, so that a reader need not guess which ones are the same.
///
/// Units     mm
/// Accuracy  9 significant digits: 0.05 nm at a radius of 50 mm
/// Domain    at least one part, an XML text below 2³² bytes (contract)
std::string threemf_bytes(const std::vector<MeshPart>& parts);

/// The bytes of a GLB file, glTF 2.0 in one binary file: what browsers and viewers show.
///
/// One node per part with its pose as matrix, one mesh with smooth normals, one material of its own
/// colour. Metres, as glTF wants. The gear axis stays z, which in glTF points at the viewer: a gear
/// is seen from its face.
///
/// Accuracy  coordinates rounded to float32 metres: 2 nm at a radius of 50 mm
/// Domain    at least one part, rigid poses, fewer than 2³² bytes in all (contract)
std::string glb_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
