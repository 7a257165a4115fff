// STL, binary: a heap of triangles, read by every printer and every mesh tool.
//
// 80 bytes of text, a count, then 50 bytes per triangle: normal, three corners, all float32 in mm,
// and two bytes of nothing. All parts go into one heap at their poses. Corners that are one vertex
// of the mesh are the same twelve bytes, so that readers find the mesh's own edges again.
#pragma once

#include <string>
#include <vector>

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// The bytes of a binary STL file.
///
/// Units     mm, in the frame the poses lead to
/// Accuracy  coordinates rounded to float32: 2 nm at a radius of 50 mm
/// Domain    fewer than 2³² triangles in all (contract)
std::string stl_bytes(const std::vector<MeshPart>& parts);

}  // namespace gearwright
