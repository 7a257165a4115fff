// The closed triangle mesh of a rack. Internal to cad/.
//
// Every strip of the plan view (cad/rack_plan.hpp) is a plane quadrilateral. A fillet is divided
// into strips that deviate from its cylinder by no more than the tolerance. The back, the ends and
// the sides have one vertex below each vertex of the teeth.
#pragma once

#include "gearwright/cad/mesh.hpp"

namespace gearwright {

/// Works like tessellate() (cad/mesh.hpp), for a body that is a rack.
///
/// Accuracy  planes are exact; a fillet deviates by ρ_f (1 − cos Δ/2) ≤ chord_tolerance_mm, where Δ
///           is the change of its direction over one strip
/// Errors    chord_tolerance_mm if the mesh would have more than 2·10⁶ vertices
Result<TriangleMesh> tessellate_rack(const ToothedBody& body, const MeshOptions& options);

}  // namespace gearwright
