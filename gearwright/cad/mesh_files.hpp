// Files of triangle meshes: STL, 3MF and GLB. The same parts give the same bytes (3MF: with the
// same zlib release).
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Returns the bytes of a binary STL file, an unordered list of triangles that every printer and
/// mesh tool reads.
///
/// The file has 80 bytes of text, a count, and then 50 bytes per triangle: normal, three corners,
/// all float32 in mm, and two zero bytes. All parts are written into one list at their poses.
/// Corners that share a vertex of the mesh have the same twelve bytes, so readers can restore the
/// edges of the mesh.
///
/// Units     mm, in the frame to which the poses lead
/// Accuracy  coordinates rounded to float32: 2 nm at a radius of 50 mm
/// Domain    fewer than 2³² triangles in all (contract)
std::string stl_bytes(const std::vector<MeshPart>& parts);

/// Returns the bytes of a 3MF file, the format of 3D printers: XML in a ZIP archive, with units,
/// names and positions.
///
/// The file follows core specification 1.2. Each part is one mesh object in mm, and a build item
/// places it by its pose. Vertices are shared, so a reader need not guess which ones are equal.
///
/// Units     mm
/// Accuracy  9 significant digits: 0.05 nm at a radius of 50 mm
/// Domain    at least one part, an XML text below 2³² bytes (contract)
std::string threemf_bytes(const std::vector<MeshPart>& parts);

/// Returns the bytes of a GLB file, glTF 2.0 in one binary file, for browsers and viewers.
///
/// Each part has one node with its pose as matrix, one mesh with smooth normals, and one material
/// of its own colour. Lengths are in metres, as glTF requires. The gear axis remains z, which in
/// glTF points at the viewer, so a gear is seen from its face.
///
/// Accuracy  coordinates rounded to float32 metres: 2 nm at a radius of 50 mm
/// Domain    at least one part, rigid poses, fewer than 2³² bytes in all (contract)
std::string glb_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
