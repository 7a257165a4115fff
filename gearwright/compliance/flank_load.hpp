// A load on the flank of a tooth is distributed with a smooth weight function, called a bump. The
// displacement of a flank is averaged with the same bump, so Betti's reciprocity holds.
//
//   s    arc length along the outline from the middle of the space, m_n
//   c    half width of the bump b(s) = 15/(16c) (1 − s²/c²)², m_n
//                                                theory: docs/theory/12-loaded-contact.md, [T12.17]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/compliance/section_mesh.hpp"

namespace gearwright::detail {

/// A weighted sum of displacements, Σ weight · U(dof). The same weights, used as nodal forces,
/// represent a unit line load.
struct Functional {
  std::vector<int> dof;
  std::vector<double> weight;

  Eigen::VectorXd vector(Eigen::Index n) const;
};

/// A point on the flank, with the unit normal into the material and the unit tangent towards the
/// tip, both in the section.
struct FlankPlace {
  std::complex<double> point, normal, tangent;
};
FlankPlace flank_place(const SectionMesh& mesh, double s);
/// Returns the arc length at which the outline of tooth 0 reaches `radius`, in modules, limited to
/// the part from the start of the flank to the tip land.
double length_at_radius(const SectionMesh& mesh, double radius);

struct BumpPlace {
  double s, c;
};

/// Returns the bump at s, with its force along the inward normal of the flank. For a helical gear
/// (τ ≠ 0), the normal of the screw surface is used.
Functional bump(const SectionMesh& mesh, double s, double c, double tau);
Functional axial_bump(const SectionMesh& mesh, double s, double c);
/// Moves the functional from tooth 0 to tooth k.
Functional on_tooth(const SectionMesh& mesh, const Functional& f, int k);

}  // namespace gearwright::detail
