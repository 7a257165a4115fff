// The quantities of a whole drive: `drive` of a result.
#pragma once

#include <optional>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {

const Quantities<Drive>& drive_quantities();

/// A body of a drive, and a mesh of it.
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
/// The rating of a mesh as for a pair; none for an idle mesh.
std::optional<ValueRecord> mesh_rating(const Drive& drive, std::size_t mesh);
const Quantities<PlanetSet>& assembly_quantities();
const Quantities<PlanetSet>& phasing_quantities();

}  // namespace gearwright
