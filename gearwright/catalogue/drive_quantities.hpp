// The quantities of a whole drive, which are `drive` in a result.
#pragma once

#include <optional>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {

const Quantities<Drive>& drive_quantities();

/// One body of a drive, and one mesh of a drive.
struct DriveBodyView {
  const Drive* drive;
  std::size_t body;
};
struct DriveMeshView {
  const Drive* drive;
  std::size_t mesh;
};
const Quantities<DriveBodyView>& drive_body_quantities();
const Quantities<DriveMeshView>& drive_mesh_quantities();
/// A harmonic of the transmission error, with the lever of DriveError.
struct DriveErrorLine {
  const DriveError::Line* line;
  std::optional<double> lever;
};
const Quantities<DriveErrorLine>& drive_error_line_quantities();
Value error_lines(const DriveError& error);

/// A drive under load: `drive.load` of a result.
///
/// Domain    with Drive::loaded (contract)
const Quantities<Drive>& drive_load_quantities();

/// The shares of the planets of a set of a drive.
struct PlanetSharesView {
  const Drive* drive;
  const PlanetShares* shares;
};
const Quantities<PlanetSharesView>& planet_share_quantities();

/// The greatest K_γ that the planets have under load; none without planets and a load.
std::optional<double> mesh_load_factor(const Drive& drive);
/// The K_γ with which the meshes of planets are rated; none without a rating.
std::optional<double> rated_mesh_load_factor(const Drive& drive);

/// The rating of a mesh, with the same quantities as for a pair. An idle mesh has none.
std::optional<ValueRecord> mesh_rating(const Drive& drive, std::size_t mesh);
const Quantities<PlanetSet>& assembly_quantities();
const Quantities<PlanetSet>& phasing_quantities();

}  // namespace gearwright
