// A load on the flank of one tooth and the displacement under it. Both use the same smooth bump
// along the flank, so Betti's symmetry holds.
//
//   s    arc length along the outline from the middle of the space, m_n
//   c    half width of the bump b(s) = 15/(16c) (1 − s²/c²)²
//                                                theory: docs/theory/12-loaded-contact.md, [T12.17]
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gearwright/compliance/section_mesh.hpp"

namespace gearwright::detail {

/// Weights of displacements: Σ weight · U(dof). As a load: the forces of a unit line load.
struct Functional {
  std::vector<int> dof;
  std::vector<double> weight;

  Eigen::VectorXd vector(Eigen::Index n) const;
};

/// A position on the flank: the point, the inward normal of the section, and the tangent towards
/// the tip.
struct FlankPlace {
  std::complex<double> point, normal, tangent;
};
FlankPlace flank_place(const SectionMesh& mesh, double s);
/// The arc length at which the outline of tooth 0 has a radius, in modules.
double length_at_radius(const SectionMesh& mesh, double radius);

/// The position and the width of a bump.
struct BumpPlace {
  double s, c;
};

/// The bump at s, along the flank's inward normal; with τ ≠ 0 along that of the screw surface.
Functional bump(const SectionMesh& mesh, double s, double c, double tau);
/// The same bump with its force along the axis.
Functional axial_bump(const SectionMesh& mesh, double s, double c);
/// The functional moved to tooth k.
Functional on_tooth(const SectionMesh& mesh, const Functional& f, int k);

}  // namespace gearwright::detail
