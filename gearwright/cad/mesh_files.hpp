// Writes triangle meshes as STL, 3MF and GLB files. The same parts give the same bytes (for 3MF,
// with the same zlib release).
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Returns the bytes of a binary STL file. All parts are written into one list of triangles at
/// their poses. Corners at the same vertex of the mesh have the same bytes, so a reader can connect
/// the triangles again.
///
/// Units     mm, in the frame to which the poses transform
/// Accuracy  coordinates rounded to float32: 2 nm at a radius of 50 mm
/// Domain    fewer than 2³² triangles in all (contract)
std::string stl_bytes(const std::vector<MeshPart>& parts);

/// Returns the bytes of a 3MF file (core specification 1.2): XML in a ZIP archive, with units,
/// names and positions. Each part with its own mesh is one mesh object in mm. A build item places
/// each part at its pose. A part with `same_as` uses the object of the earlier part.
///
/// Units     mm
/// Accuracy  9 significant digits: 0.05 nm at a radius of 50 mm
/// Domain    at least one part, an XML text below 2³² bytes (contract)
std::string threemf_bytes(const std::vector<MeshPart>& parts);

/// Returns the bytes of a GLB file, which is glTF 2.0 in one binary file. Each part has one node
/// with its pose as a matrix. It also has one mesh with smooth normals and one coloured material.
/// If `same_as` is set, the part uses the mesh and the material of that earlier part instead.
/// Lengths are in metres, as glTF requires. The gear axis remains the z axis. In glTF, the z axis
/// points at the viewer, so the viewer sees the end face of the gear.
///
/// Accuracy  coordinates rounded to float32 metres: 2 nm at a radius of 50 mm
/// Domain    at least one part, rigid poses, fewer than 2³² bytes in all (contract)
std::string glb_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
