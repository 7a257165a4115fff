// The quantities of a search for drives, which has the key `kind` in [search]. A result contains
// them under `search`.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/drive_search.hpp"
#include "gearwright/drive/drive.hpp"

namespace gearwright {

/// A drive in the result of a search, computed in the same way as by the verb `drive`. Its verdict
/// is green.
struct FoundDrive {
  DriveCandidate candidate;
  Drive drive;
};
const Quantities<FoundDrive>& found_drive_quantities();

/// The reasons why a computed candidate is left out.
enum class DriveFault { no_teeth, neighbours, sliding, safety, verdict };
inline constexpr std::array<std::string_view, 5> kDriveFaultNames{"no_teeth", "neighbours",
                                                                  "sliding", "safety", "verdict"};

struct DriveDesigns {
  std::vector<FoundDrive> list;     ///< sorted by the first objective, the best drive first
  std::vector<std::size_t> pareto;  ///< indices in `list`
  std::size_t computed = 0;
  std::size_t hopeless = 0;      ///< trains that were left out because their estimated safeties are
                                 ///< too small
  std::size_t beyond_limit = 0;  ///< candidates that were not computed because of the limit
  std::array<std::size_t, kDriveFaultNames.size()> left_out{};
};

struct DriveSearchView {
  const DriveSearchProblem* problem;
  const DriveSearchResult* result;
  const DriveDesigns* designs;
  std::optional<double> default_face_load{};  ///< the default K_Hβ, if the search is rated and its
                                              ///< spec gives none
};
const Quantities<DriveSearchView>& drive_search_quantities();

}  // namespace gearwright
