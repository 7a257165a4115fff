// When nothing is feasible: what change of one number would let something through.
//
// Each limit is loosened by itself, by bisection on the whole search, to the least change after
// which a design exists; limits that do not help however far they go are not named.
#pragma once

#include <string>
#include <vector>

#include "gearwright/design/search.hpp"

namespace gearwright {

struct NearestChange {
  std::string field;  ///< the member of SearchProblem, "limits.contact_ratio"
  std::string from;   ///< as given, "1.2" or "[99, 101]"
  std::string to;     ///< with which a design exists: rounded to the side that lets it through
  /// |to − from| in units of the value itself (distance, ratio, teeth), of 1, or of 2 (sliding); a
  /// switch counts 0.5.
  double effort;  ///< they are ordered by it
};

/// More trials than this are not asked again and again.
inline constexpr std::int64_t kMaxForChange = 2'000'000;

/// The changes, smallest first.   Domain: nothing is feasible; size() ≤ kMaxForChange (contract)
std::vector<NearestChange> nearest_changes(const SearchProblem& problem);

}  // namespace gearwright
