// The quantities of a whole drive. A result contains them under `drive`.
#pragma once

#include <optional>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {

const Quantities<Drive>& drive_quantities();
/// The centre distance and the profile shifts. The record of a drive contains them under `coaxial`.
const Quantities<Drive>& coaxial_quantities();

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
/// A harmonic of the transmission error. `lever` is DriveError::lever, the travel of the rack in mm
/// for a motion of 1 rad.
struct DriveErrorLine {
  const DriveError::Line* line;
  std::optional<double> lever;
};
const Quantities<DriveErrorLine>& drive_error_line_quantities();
std::vector<DriveErrorLine> error_lines(const DriveError& error);

/// The quantities of a drive under load. A result contains them under `drive.load`.
///
/// Domain    a drive with Drive::loaded (contract)
const Quantities<Drive>& drive_load_quantities();

/// A planetary set of a drive, with the load share of each planet.
struct PlanetSharesView {
  const Drive* drive;
  const PlanetShares* shares;
};
const Quantities<PlanetSharesView>& planet_share_quantities();

/// Returns the greatest mesh load factor K_γ of the planets under load. Returns none without
/// planets or without a load.
std::optional<double> mesh_load_factor(const Drive& drive);
/// Returns the greatest K_γ with which a mesh is rated, or none without a rating.
std::optional<double> rated_mesh_load_factor(const Drive& drive);

/// Returns [p, q] in lowest terms, or null if one of the numbers has more than 63 bits.
Value exact_fraction(const Rational& r);
/// Returns phases in periods, or null if there are none.
Value phase_list(const std::vector<Rational>& phases);

/// Returns the rating of a mesh with the same quantities as the rating of a pair, or none if the
/// mesh transmits no power.
std::optional<ValueRecord> mesh_rating(const Drive& drive, std::size_t mesh);

const Quantities<PlanetSet>& assembly_quantities();
const Quantities<PlanetSet>& phasing_quantities();

// The quantities of a search for drives, which has the key `kind` in [search]. A result contains
// them under `search`.

const Quantities<FoundDrive>& found_drive_quantities();

struct FoundDrives {
  DriveSearchProblem problem;
  DriveSearchResult result;
  DriveDesigns designs;
  std::optional<double> default_face_load{};  ///< the default K_Hβ, if the search is rated and
                                              ///< its spec gives no K_Hβ; otherwise none
};
const Quantities<FoundDrives>& drive_search_quantities();

}  // namespace gearwright
