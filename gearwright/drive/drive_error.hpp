// Computes the transmission error of a drive from the transmission errors of its meshes, which have
// different phases.
//
//   e_m    transmission error of a mesh along the transverse line of action, mm; > 0 if the driven
//          gear is ahead
//   t      time in periods of the mesh, 0 when the loaded flanks of planet 0 touch at the pitch
//          point
//   δφ_o = Σ_m |λ_m/T_o| (2π/p_bt,m) ē_m(t), ē_m = Σ_i e_m(t − γ_i)/N          [T13.21], [T13.22]
//                                              theory: docs/theory/13-drives.md
//
// The curve of a mesh is the mean over the planets of the set. This is valid for equal planets with
// a floating member, because they share the load equally.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// Number of positions of each mesh over one period. With only 64 positions, the peak-to-peak value
/// for a relief of 20 µm would be 5 % too large.
inline constexpr int kErrorPositions = 256;

/// A function that returns the errors of mounting of the mesh with a given index. It is empty if no
/// mesh has errors of mounting.
using MeshErrors = std::function<ContactErrors(std::size_t mesh)>;

/// Returns the transmission error with the harmonics 1 … `harmonics` of each mesh frequency. At
/// most kErrorPositions/2 − 1 harmonics are included.
///
/// Formula   [T13.21], [T13.22]. Meshes that share a gear have one frequency, and their phase
///           follows from the angle between them on this gear, [T13.17]. Flanks without
///           modifications and without errors of mounting are conjugate. Their curve is 0 if the
///           total contact ratio is at least 1
/// Domain    a drive made by make_drive(), with its flow if there is one. If the drive has
///           `contacts`, the function uses them, and they must have been computed with the same
///           errors. harmonics ≥ 1 (contract)
/// None      if there are several inputs or a redundant mesh, if a mesh that moves the output has
///           no geometry or loses contact, if its rack has several pinions or errors of the teeth,
///           or if a measured gear is loaded on a flank without readings
std::optional<DriveError> transmission_error(const Drive& drive, int harmonics,
                                             const MeshErrors& errors = {});

/// Returns the contact of each mesh under errors, at kErrorPositions positions.
///
/// Domain    as for transmission_error(); errors given (contract)
/// None      for every mesh if there are several inputs, a redundant mesh or unknown phases; for a
///           single mesh if its flanks cannot be computed
std::vector<std::optional<MeshContact>> mesh_contacts(const Drive& drive, const MeshErrors& errors);

}  // namespace gearwright
