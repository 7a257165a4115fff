// Computes the equilibrium of the planets of a set under the forces of the central gears, in the
// frame of the carrier.
//
//   x_b    rotation of a body times its base radius, mm     D   displacement of an axis, mm
//   y      approach of the flanks of a mesh, mm             n   direction of the mesh force
//   σ      ±1, the sign of z ω of the driving gear          p_bt   transverse base pitch, mm
//   y = σ (p_bt/2π) (z_a θ_a + z_b θ_b) + n·(D_a − D_b)                                [T13.23]
//   F = F(δ), δ = y + e_0                                                              [T13.24]
//   Σ w F ∂y/∂x = Q                                                                    [T13.25]
//                                              theory: docs/theory/13-drives.md, 13.7
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive_phases.hpp"
#include "gearwright/drive/load_sharing.hpp"

namespace gearwright::detail {

/// The deviations of a set from the ideal set.
struct PlanetErrors {
  std::optional<std::size_t> floating;  ///< body that is free to move radially
  std::vector<double> pins;  ///< ε  mm, tangential error of each pin, > 0 counter-clockwise. The
                             ///< order is: all copies of the first rider, then all copies of the
                             ///< next. If empty, all errors are 0
};

/// A mesh of one planet in one position.
struct MeshState {
  const LoadSpring* spring = nullptr;
  double lead = 0.0;  ///< e_0  mm
};

struct PlanetState {
  std::vector<std::vector<double>> forces;  ///< N, [mesh of PlanetEquilibrium::meshes()][planet]
  double output = 0.0;  ///< rad, δφ_o, rotation of the drive's output due to this set [T13.27]
  Vec2 displacement = Vec2::Zero();  ///< mm, D of the floating body in the carrier's frame
  bool found = false;
};

/// The unknowns and equations of one set, which are the same in all positions.
///
/// Laws      linear springs around a centred sun have the closed form [T13.28]; around a floating
///           sun, three planets share equally
class PlanetEquilibrium {
 public:
  /// Prepares the equations of a set.
  ///
  /// `nominal` is the force of an equal share of the load in each mesh of the drive, N along the
  /// transverse line of action.
  ///
  /// Domain    a drive that is not self-locking and has a power flow; the meshes of the set are
  ///           connected by bodies without a loop (contract)
  PlanetEquilibrium(const Drive& drive, const PlanetSet& set, const std::vector<MeshPhase>& phases,
                    const std::vector<double>& nominal, const PlanetErrors& errors);

  /// Returns the meshes of the set that carry load.
  const std::vector<std::size_t>& meshes() const { return meshes_; }
  /// Returns the force of an equal share of the load in each of meshes(), N.
  const std::vector<double>& nominal() const { return nominal_; }
  /// Computes the equilibrium in one position.
  ///
  /// `states` is indexed by [mesh of meshes()][planet].
  PlanetState solve(const std::vector<std::vector<MeshState>>& states) const;

 private:
  void find_weights(const std::vector<MeshPhase>& phases);
  void find_unknowns();
  void find_rows(const std::vector<MeshPhase>& phases, const PlanetErrors& errors);
  std::optional<Eigen::Index> column(std::size_t body, std::size_t planet) const;
  Vec2 push(std::size_t mesh, std::size_t planet, const MeshPhase& phase) const;
  Vec2 pin(const DriveGear& gear, std::size_t planet, const std::vector<double>& errors) const;

  const Drive& drive_;
  const PlanetSet& set_;
  std::vector<std::size_t> meshes_;
  std::vector<double> nominal_;                       // nominal force of each mesh
  std::vector<double> weights_;                       // w of each mesh
  std::vector<std::optional<Eigen::Index>> columns_;  // for each body: column of its first copy
  Eigen::Index unknowns_ = 0;
  std::optional<Eigen::Index> displaced_;  // the column of D's first component
  SharingProblem problem_;                 // springs in the order of mesh and planet
  Eigen::VectorXd output_;                 // rotation of the output per unit of each unknown
};

}  // namespace gearwright::detail
