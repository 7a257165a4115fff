// Computes the forces of the teeth on the gears and axes of a drive for a given torque.
//
//   T_1       torque of one copy of a mesh on its first gear, counter-clockwise seen from +z
//   r_w, α_wt, β_w   working pitch radius, working pressure angle and helix angle of the first gear
//   u         unit vector from the axis of the first gear to the pitch point
//   F_t = T_1/r_w     F_r = |F_t| tan α_wt     F_z = −F_t tan β_w                          [T13.29]
//   F_1 = F_t z × u − F_r u + F_z z     F_2 = −F_1                                         [T13.30]
//                                              theory: docs/theory/13-drives.md, 13.8
//
// The torques include the losses of the teeth. The forces do not include friction forces.
#pragma once

#include <optional>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// The forces of one copy of a mesh at the working pitch circle, N.
struct MeshForces {
  double tangential;  ///< F_t on the first gear, > 0 if it turns the gear counter-clockwise
  double separating;  ///< F_r ≥ 0, which pushes the teeth of the two gears apart
  double axial;       ///< F_z on the first gear, along +z; 0 for double-helical gears
};

/// The sum of the forces of all meshes of a body. For a planet, the sum applies to copy 0.
struct BodyForces {
  double radial;   ///< N; the bearings carry it in shares that depend on the positions of the gears
  double axial;    ///< N, along +z
  double tilting;  ///< N mm, moment of the axial forces, which tilts the body
};

/// Returns the forces of a mesh. Returns none without a torque, a power flow or the mesh geometry,
/// or if the drive is self-locking.
///
/// Formula   [T13.29]
std::optional<MeshForces> mesh_forces(const Drive& drive, std::size_t mesh);

/// Returns the forces on a body. Returns none if the body has no gears, if mesh_forces() is none
/// for one of its meshes, or if the positions of the axes are unknown.
///
/// Formula   [T13.31]; for the pin of an idler, [T13.15d]
std::optional<BodyForces> body_forces(const Drive& drive, std::size_t body);

}  // namespace gearwright
