// Computes the load shares of the planets, the mesh load factor K_γ, and the transmission error at
// the output of a drive under load.
//
//   share   force of one planet divided by the force of all planets of the set
//   K_γ     N times the greatest share [T13.26]
//                                              theory: docs/theory/13-drives.md, 13.7
//
// Each mesh acts as a spring, which is computed from the loaded contact of the mesh. The planets
// turn freely on rigid pins, and only the teeth are elastic.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/drive/drive_error.hpp"
#include "gearwright/load/pair_compliance.hpp"

namespace gearwright {

struct DriveLoadCase {
  double torque = 0.0;                  ///< T  N m, on the input, > 0
  int positions = 64;                   ///< least number of positions per period of the meshes
  int harmonics = 3;                    ///< number of harmonics of the transmission error
  std::optional<std::size_t> floating;  ///< body that is free to move radially
  std::vector<double> pin_errors;       ///< mm, in the order of PlanetErrors::pins
  std::vector<LoadRequest> requests;    ///< for each mesh: bodies, slices, accuracy
  MeshErrors errors{};                  ///< errors of mounting of the meshes
};

/// Checks whether the drive can be computed under this load, before any mesh is computed. Returns
/// the reason if the drive cannot be computed.
///
/// Errors    `load` if the loaded contact is not computed for this kind of drive; `load.torques` if
///           the torque is not greater than 0; `load.floating` if the floating body is not the
///           carrier or a central gear of a single set, or if the set has only one planet;
///           `load.pin_errors` if there is not exactly one set of planets, or if the number of pin
///           errors differs from the number of pins
std::optional<Error> check_load(const Drive& drive, const DriveLoadCase& load);

/// Computes the load shares of all planets and the transmission error of the drive under load.
///
/// Formula   at each position, all planets are in equilibrium, [T13.25]. If the meshes of a set
///           have several frequencies, all combinations of their positions are computed, [T13.26b].
///           Frequencies of different sets are not combined; their peak-to-peak values are added,
///           as in transmission_error()
/// Laws      equal planets at equal phases share equally; the shares of a mesh add up to 1;
///           three planets with a floating sun share equally for any errors of their pins
/// Domain    one request for each mesh (contract)
/// Errors    the errors of check_load(); `load.positions` if there are too many combinations of
///           positions; `load` if a mesh has no usable flanks; if there is no equilibrium,
///           `load.floating` if a body of the set floats, and otherwise `load`; the errors of
///           mesh_springs(), with the name of the mesh
Result<LoadedDrive> loaded_drive(const Drive& drive, const DriveLoadCase& load,
                                 Progress* progress = nullptr);

}  // namespace gearwright
