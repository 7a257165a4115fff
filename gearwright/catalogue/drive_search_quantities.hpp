// The quantities of a search for drives: `search` of a result with `kind`.
#pragma once

#include <array>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/drive_search.hpp"
#include "gearwright/drive/drive.hpp"
#include "gearwright/verdict/verdict.hpp"

namespace gearwright {

/// A drive that a search has found, computed as the verb drive does.
struct FoundDrive {
  DriveCandidate candidate;
  Drive drive;
  Verdict verdict;
};
const Quantities<FoundDrive>& found_drive_quantities();

struct DriveSearchView {
  const DriveSearchProblem* problem;
  const DriveSearchResult* result;
  const std::vector<FoundDrive>* designs;
  const std::vector<std::size_t>* pareto;
};
const Quantities<DriveSearchView>& drive_search_quantities();

}  // namespace gearwright
