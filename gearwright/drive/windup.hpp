// Computes the elastic rotation of the output of a drive under load, and the variation of this
// rotation.
//
//   λ_m(t) contact lines of mesh m (pair/contact_lines.hpp), t in periods of the mesh
//   w_m    weight of a mesh, (2π λ_m/(T_o p_bt,m))²/(N b_m); here, λ_m without an argument is the
//          tooth load of drive/power_flow.hpp
//   Θ(t) = Σ_m w_m (1/N) Σ_i ε_α,m/λ_m(t − t_m − γ_i)     rotation of the output [T13.32]
//                                              theory: docs/theory/13-drives.md, 13.7
//
// All teeth are perfect, and every mm of contact line has the same stiffness. The N planets of a
// set share the load equally. The phases of the curves are those of the transmission error
// (drive_error.hpp).
#pragma once

#include <optional>
#include <vector>

#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// The contact of a mesh. Lengths and times are in periods, measured from the contact at the
/// pitch point in the middle of the face.
struct WindupMesh {
  double approach = 0.0, recess = 0.0;  ///< parts of ε_α before and after the pitch point
  double overlap = 0.0;                 ///< ε_β
  double weight = 1.0;                  ///< w_m
  std::vector<double> delays{0.0};      ///< t_m + γ_i of each copy
  std::size_t frequency = 0;            ///< number of the frequency; meshes with the same mesh
                                        ///< frequency have the same number
};

/// Returns the peak-to-peak variation of Θ, divided by Σ w_m. This sum is the value of Θ if all λ
/// are equal to ε_α. The variations of several frequencies are added, as in transmission_error().
/// Returns none if there are no meshes, or if a mesh loses contact.
///
/// Formula   [T13.32], [T13.33]
/// Laws      (1) the variation of a single mesh is deflection_variation(); (2) a common factor of
///           the weights or a common delay does not change the variation
std::optional<double> windup_variation(const std::vector<WindupMesh>& meshes);

/// Returns the variation of Θ of a drive. Returns none if there are several inputs or redundant
/// meshes, or if a mesh that moves the output is not a pair of involute gears or loses contact.
std::optional<double> windup_variation(const Drive& drive);

/// The teeth of a drive without geometry. They have no profile shift and an addendum of one module.
struct StandardTeeth {
  Angle normal_pressure_angle = Angle::degrees(20), helix_angle{};
  double face_modules = 10.0;  ///< b/m_n, the default of a drive

  /// Returns the contact of two gears if gear 1 drives. z2 is < 0 for a ring.
  WindupMesh mesh(int z1, int z2) const;
};

/// Returns the variation of Θ of a planetary set whose gears have the given standard teeth. Returns
/// none if there are several inputs, redundant meshes or no planets. Also returns none if a mesh
/// that moves the output loses contact or is not a mesh of a planet with a central gear.
std::optional<double> windup_variation(const Drive& set, const StandardTeeth& teeth);

}  // namespace gearwright
