// Computes the springs of a mesh from the loaded contact of the pair at several torques. For each
// position, a spring gives the force as a function of the approach.
//
//   e_0    distance by which the driven gear is ahead without load, along the transverse line of
//          action, mm
//   δ      approach under load; the driven gear is then ahead by e_0 − δ; F = f(δ)  [T13.24]
//                                              theory: docs/theory/13-drives.md, 13.7
#pragma once

#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/drive/load_spring.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright::detail {

/// Returns the error that the loaded contact of a drive, or of one of its meshes, cannot be
/// computed.
Error not_loaded(const std::string& rule, const std::string& mesh = "");

struct MeshSprings {
  std::vector<LoadSpring> springs;  ///< one spring for each position
  std::vector<double> leads;        ///< e_0  mm
};

/// Returns the forces at which the loaded contact is solved, as multiples of an equal share of the
/// load, for a mesh with this number of copies. A single copy carries the whole load, so one force
/// is sufficient.
std::vector<double> load_levels(int copies);

/// Returns the springs of a mesh at the given rotations of gear 1, in rad. The rotations have the
/// same zero as in the contact analysis. `levels` are multiples of `nominal`. `nominal` is the
/// force along the transverse line of action under an equal share of the load, in N.
///
/// Errors    `load` if, at a position, no teeth touch, or the iteration does not converge for a
///           force up to `nominal`; `load.slices` if the slices are narrower than the contact under
///           such a force; the errors of pair_compliance()
Result<MeshSprings> mesh_springs(const ContactSetup& setup, bool gear2_drives, LoadRequest request,
                                 const std::vector<double>& levels, double nominal,
                                 const std::vector<double>& rotations);

}  // namespace gearwright::detail
