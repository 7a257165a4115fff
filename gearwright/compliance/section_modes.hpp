// Computes the displacement modes of a loaded section from displacement waves along the face and
// from solutions for the unloaded end faces. With these modes, the tooth is computed as a beam
// along its face.
//
//   Φ     modes: first fields of u and v, then fields of w
//   f(z)  amplitudes of the modes along the face
//                                    theory: docs/theory/12-loaded-contact.md, [T12.6], [T12.7]
#pragma once

#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/compliance/flank_load.hpp"
#include "gearwright/compliance/section_matrices.hpp"

namespace gearwright::detail {

/// The matrices of [T12.7] projected onto the modes.
struct ModeMatrices {
  Eigen::MatrixXd aa, ab, bb;
};

struct SectionModes {
  Eigen::MatrixXd fields;  ///< Φ, with a column per mode and 3·nodes rows
  ModeMatrices matrices;   ///< in coordinates that turn with the helix
};
/// Computes the modes for loads at `places` on the flank. For a helical gear (τ ≠ 0), waves along
/// the helix are included. A mode is dropped if its singular value is below `tolerance` times the
/// greatest singular value. Each wave, each of the two groups of modes and each matrix counts as
/// one step of `progress`.
SectionModes section_modes(const SectionMesh& mesh, double poisson_ratio,
                           const std::vector<BumpPlace>& places, double tau, double tolerance,
                           Progress* progress);

/// Returns the displacements of the section in plane strain under loads that are uniform along the
/// face. They are computed directly, without modes.
Eigen::MatrixXd plane_strain(const SectionMesh& mesh, double poisson_ratio,
                             const std::vector<Functional>& loads);

}  // namespace gearwright::detail
