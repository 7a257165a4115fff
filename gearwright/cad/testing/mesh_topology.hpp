// Determines the topology and the shading of a triangle mesh, for tests of the CAD files.
#pragma once

#include <cstddef>

#include "gearwright/cad/mesh.hpp"

namespace gearwright::testing {

struct Topology {
  bool closed = true;  // each directed edge occurs exactly once, and so does its reverse
  int euler = 0;
  int parts = 0;
  std::size_t unused = 0;  // vertices that belong to no triangle
};

Topology topology(const TriangleMesh& mesh);

struct Shading {
  bool same_corners = true;   // each shaded triangle has the vertices of its twin
  double length_error = 0.0;  // greatest difference of the length of a normal from 1
  double least_cosine = 1.0;  // least cosine between a facet's normal and one at its corners
};

/// Domain    as many triangles as shaded triangles
Shading shading(const TriangleMesh& mesh);

}  // namespace gearwright::testing
