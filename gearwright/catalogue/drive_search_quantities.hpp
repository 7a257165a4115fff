// The quantities of a search for drives, which has the key `kind` in [search]. A result contains
// them under `search`.
#pragma once

#include <optional>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/catalogue/quantity.hpp"

namespace gearwright {

const Quantities<FoundDrive>& found_drive_quantities();

struct DriveSearchView {
  const DriveSearchProblem* problem;
  const DriveSearchResult* result;
  const DriveDesigns* designs;
  std::optional<double> default_face_load{};  ///< the default K_Hβ, if the search is rated and its
                                              ///< spec gives none
};
const Quantities<DriveSearchView>& drive_search_quantities();

}  // namespace gearwright
