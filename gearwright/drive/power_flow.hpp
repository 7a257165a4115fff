// Computes torques, powers and losses of a drive, and the direction of the power in every mesh.
//
//   λ_m    tooth load of a mesh in the unit "torque per tooth", all copies together
//   T_a = z_a λ   T_b = z_b λ η^σ   T_c = −(T_a + T_b)                          [T13.6], [T13.7]
//   σ      1 if gear a drives, −1 if gear b drives
//   Σ_m T_body,m + T_ext = 0 on every body [T13.8]; power flows in if T_ext ω > 0
//                                              theory: docs/theory/13-drives.md
//
// The loss of a mesh depends on the power relative to the frame of the mesh. The power that the
// rotation of the frame itself transmits has no loss.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive_motion.hpp"

namespace gearwright {

/// The efficiency η of a mesh with its frame at rest. `first_drives` applies if gear a drives, and
/// `second_drives` applies if gear b drives.
struct MeshEfficiency {
  double first_drives, second_drives;
};

/// Power that flows from a mesh to a body (> 0) or from the body to the mesh (< 0), in the frame of
/// the housing. The sum of the powers of a mesh is −1 times the loss of the mesh.
struct PowerPath {
  std::size_t mesh, body;
  double power;
};

struct PowerFlow {
  std::vector<double> load;        ///< λ of each mesh
  std::vector<int> driver;         ///< 0 if gear a drives, 1 if gear b drives, −1 if idle
  std::vector<double> mesh_power;  ///< P_m, power of the driving gear in the frame of the mesh
  std::vector<double> torque;      ///< T_ext of each body, 0 if the body is free
  std::vector<PowerPath> paths;    ///< paths in the order of meshes; none for bodies at rest
  double power_in = 0.0;           ///< sum of the powers T ω that flow into the drive
  double efficiency = 0.0;         ///< η [T13.9]; 0 if self-locking, and other members are empty
  bool circulating = false;        ///< true if a group of planets or a mesh in the housing
                                   ///< carries more power than flows into the drive

  bool self_locking() const { return efficiency <= 0.0; }
};

/// Computes the power flow for given speeds of all bodies and the torque 1 on the first input.
///
/// Formula   The iteration begins with the signs σ of the flow without friction. Each step uses the
///           signs of the previous solution, until the signs do not change. If the iteration gives
///           no solution with η > 0, all patterns of signs are tried. The first consistent pattern
///           with η > 0 is then used. Closed forms: [T13.10], [T13.11]
/// Domain    independent meshes, f inputs and one output (contract)
/// Errors    `drive.mesh` if the iteration gives no solution and more than 16 meshes are loaded
Result<PowerFlow> power_flow(const DriveGraph& graph, const std::vector<double>& speeds,
                             const std::vector<MeshEfficiency>& efficiencies);

/// Returns the exact load λ of each mesh without friction, per unit torque on `body`. The body
/// `held` and the fixed bodies react. A motion of the teeth of a mesh turns `body` by λ times this
/// motion [T13.20]. If `body` itself is held or fixed, all loads are 0.
///
/// Domain    one degree of freedom, independent meshes; `held` is the input or output (contract)
std::vector<Rational> lossless_loads(const DriveGraph& graph, const DriveMotion& motion,
                                     std::size_t body, std::size_t held);

}  // namespace gearwright
