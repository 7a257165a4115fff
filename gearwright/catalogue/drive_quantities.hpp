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
/// The rating of a mesh, with the same quantities as for a pair. An idle mesh has none.
std::optional<ValueRecord> mesh_rating(const Drive& drive, std::size_t mesh);
const Quantities<PlanetSet>& assembly_quantities();
const Quantities<PlanetSet>& phasing_quantities();

}  // namespace gearwright
