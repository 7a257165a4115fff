// A drive under load: the shares of its planets, K_γ, and the transmission error at the output.
//
//   share   force of one planet over that of all planets of the set
//   K_γ     N times the greatest share [T13.26]
//                                              theory: docs/theory/13-drives.md, 13.7
//
// Every mesh is a spring from its own loaded contact. The planets turn freely on rigid pins, and only
// teeth yield.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/drive/drive_error.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

/// The load of a drive and the resolution of its meshes.
struct DriveLoadCase {
  double torque = 0.0;                  ///< T  N m, on the input, > 0
  int positions = 64;                   ///< over a period of the mesh, at least
  int harmonics = 3;                    ///< of the transmission error
  std::optional<std::size_t> floating;  ///< body that is free to move radially
  std::vector<double> pin_errors;       ///< mm, as PlanetErrors::pins
  std::vector<LoadRequest> requests;    ///< of each mesh: bodies, slices, accuracy
  MeshErrors errors{};                  ///< errors of mounting of the meshes
};

/// The reason why a drive or its load cannot be computed, before any mesh is.
///
/// Errors    `load` for kinds of drives that have no loaded contact; `load.torques` of 0;
///           `load.floating` that is not the carrier or a central gear of one set; `load.pin_errors`
///           without planets, or not one for each of them
std::optional<Error> check_load(const Drive& drive, const DriveLoadCase& load);

/// Formula   each position is the equilibrium of all planets, [T13.25]; meshes of several
///           frequencies add their peaks as transmission_error() does
/// Laws      equal planets at equal phases share equally; the shares of a mesh add up to 1; three
///           planets with a floating sun share equally whatever the errors of their pins
/// Domain    one request for each mesh (contract)
/// Errors    as check_load(); `load` of stepped planets; `load.floating` that does not find an
///           equilibrium; as mesh_springs(), with the mesh in the rule
Result<LoadedDrive> loaded_drive(const Drive& drive, const DriveLoadCase& load,
                                 Progress* progress = nullptr);

}  // namespace gearwright
